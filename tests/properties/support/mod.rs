//! Shared by the properties: generic ports, numbers to try, and reference arithmetic.

mod double;
mod models;
mod motion;
mod numbers;
mod ports;
mod two_masses;

use std::fmt::Debug;

use nalgebra::SVector;
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed, TestCaseResult, TestError, TestRunner};

use lyapunov::{
    Dissipation, LyapunovCandidate, PortSample, Scalar, Signal,
    candidates::{Gate, InContact},
    environments::Wall,
};

pub(crate) use double::Double;
pub(crate) use models::{Book, Credit, Ledger, Stream, drive_of, power, stream};
pub(crate) use motion::{Gain, Motion, State, quadrature, runge_kutta};
pub(crate) use numbers::{Bits, bad, hostile, log_between, ordinary, unit, wild};
pub(crate) use ports::{Faulty, Scripted, Spy};
pub(crate) use two_masses::TwoMasses;

/// Number of random cases of a property.
pub(crate) const CASES: u32 = 10_000;

/// One value at a time: `f32` or `f64`.
pub(crate) trait Real: Scalar<Mask = bool> + Into<f64> + PartialOrd {
    /// The largest and the smallest power of two among hostile numbers.
    const EXPONENTS: (i32, i32);

    /// The scalar with any bit pattern.
    fn of_bits(bits: u64) -> Self;

    fn f64(self) -> f64 {
        self.into()
    }

    /// Half the distance from one to the next number: the relative error of one rounding.
    fn unit() -> f64 {
        Self::epsilon().f64() / 2.0
    }
}

impl Real for f32 {
    const EXPONENTS: (i32, i32) = (-149, 58);

    fn of_bits(bits: u64) -> Self {
        f32::from_bits(bits as u32)
    }
}

impl Real for f64 {
    const EXPONENTS: (i32, i32) = (-1074, 497);

    fn of_bits(bits: u64) -> Self {
        f64::from_bits(bits)
    }
}

/// A port of one value at a time, axis by axis.
pub(crate) trait Port: Signal<Scalar: Real> {
    const AXES: usize;

    /// A credit that counts beyond a surface on the first axis.
    type Contact: LyapunovCandidate<Self> + Copy + Debug;

    fn contact(damping: Self::Scalar, surface: Self::Scalar) -> Self::Contact;

    fn from_axes(axis: impl FnMut(usize) -> Self::Scalar) -> Self;

    fn axis(&self, index: usize) -> Self::Scalar;

    fn axes(&self) -> impl Iterator<Item = Self::Scalar> {
        (0..Self::AXES).map(|index| self.axis(index))
    }

    fn all_finite(&self) -> bool {
        self.axes().all(|axis| axis.f64().is_finite())
    }
}

macro_rules! port {
    ($($real:ident),+) => {$(
        impl Port for $real {
            const AXES: usize = 1;

            type Contact = Dissipation<$real, InContact<$real>>;

            fn contact(damping: $real, surface: $real) -> Self::Contact {
                Wall::new(1.0, damping).expect("a wall").at(surface).dissipation()
            }

            fn from_axes(mut axis: impl FnMut(usize) -> $real) -> Self {
                axis(0)
            }

            fn axis(&self, _index: usize) -> $real {
                *self
            }
        }
    )+};
}

port!(f32, f64);

/// A gate that is open strictly beyond a surface on the first axis of several.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FirstAxis<T> {
    surface: T,
}

impl<T: Real, const N: usize> Gate<SVector<T, N>> for FirstAxis<T> {
    fn open(&self, sample: &PortSample<SVector<T, N>>) -> bool {
        sample.position[0] > self.surface
    }
}

impl<T: Real, const N: usize> Port for SVector<T, N> {
    const AXES: usize = N;

    type Contact = Dissipation<T, FirstAxis<T>>;

    fn contact(damping: T, surface: T) -> Self::Contact {
        Dissipation::of(damping).expect("a damping").gated(FirstAxis { surface })
    }

    fn from_axes(axis: impl FnMut(usize) -> T) -> Self {
        let values: [T; N] = std::array::from_fn(axis);
        SVector::from(values)
    }

    fn axis(&self, index: usize) -> T {
        self[index]
    }
}

/// Equal to the last bit; a NaN equals every NaN.
pub(crate) fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// [`same`] on every axis.
pub(crate) fn same_axes<V: Port>(a: V, b: V) -> bool {
    a.axes().zip(b.axes()).all(|(a, b)| same(a.f64(), b.f64()))
}

/// Tests `property` on `cases` values, always the same ones, and shrinks a failure.
pub(crate) fn hold<S: Strategy>(
    cases: u32,
    strategy: S,
    property: impl Fn(S::Value) -> TestCaseResult,
) {
    run(cases, strategy, &property);
}

/// One runner for all properties of the same values: compiling one for each takes minutes.
fn run<S: Strategy>(cases: u32, strategy: S, property: &dyn Fn(S::Value) -> TestCaseResult) {
    let config = Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x5eed),
        // Of ten thousand cases, the default one takes two thirds of the time.
        rng_algorithm: RngAlgorithm::XorShift,
        max_shrink_iters: 20_000,
        ..Config::default()
    };
    match TestRunner::new(config).run(&strategy, property) {
        Ok(()) => {}
        Err(TestError::Fail(why, value)) => panic!("{why}\nfor {value:#?}"),
        Err(aborted) => panic!("{aborted}"),
    }
}

/// Makes tests of a property that is generic over a type, one for each type.
macro_rules! each_type {
    ($property:ident: $($name:ident = $of:ty),+ $(,)?) => {
        mod $property {$(
            #[test]
            fn $name() {
                super::check::$property::<$of>();
            }
        )+}
    };
}

/// Makes tests of a property that is generic over the port, one for each port.
macro_rules! every_port {
    ($($property:ident),+ $(,)?) => {$(
        crate::support::each_type!($property:
            f32_scalar = f32,
            f64_scalar = f64,
            f32_vector = nalgebra::Vector3<f32>,
            f64_vector = nalgebra::Vector3<f64>,
        );
    )+};
}

/// Makes tests of a property that is generic over the scalar.
macro_rules! every_real {
    ($($property:ident),+ $(,)?) => {$(
        crate::support::each_type!($property: f32 = f32, f64 = f64);
    )+};
}

pub(crate) use {each_type, every_port, every_real};
