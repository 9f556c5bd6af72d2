//! Lanes of integrators, each equal to its scalar run.

use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::laws::Samples;
use lyapunov::{
    Plant, Scalar,
    bodies::{DampedMass, Impedance, IntegratedPlant, TwoMassParts},
    integrators::{
        Adaptive, Coordinates, CoupledOscillators, DormandPrince5, DormandPrince8, Exact,
        ImplicitMidpoint, Integrator, Mechanics, Oscillator, RungeKutta4, RungeKuttaNystrom4,
        SemiImplicitEuler,
    },
};

use crate::{hand, moved, pair};

/// Each lane, with parts of its own, against the scalar of the same numbers.
fn lane_by_lane<T, L, D, S, I, J>(
    stepped: impl Fn(usize) -> IntegratedPlant<T, D, I>,
    lanes: IntegratedPlant<L, S, J>,
) where
    T: Scalar,
    L: Scalar,
    D: Mechanics<T, Coordinates: Coordinates<T>>,
    S: Mechanics<L, Coordinates: Coordinates<L>>,
    I: Integrator<T, D>,
    J: Integrator<L, S>,
{
    let place = |lane: usize| 0.001 * lane as f64 - 0.004;
    let mut lanes = lanes.starting(L::from_lanes(place), L::of(0.1));
    let mut scalars: Vec<_> =
        (0..L::LANES).map(|lane| stepped(lane).starting(T::of(place(lane)), T::of(0.1))).collect();
    for (_, effort) in Samples::<L>::new(L::of(1e-3)) {
        let sample = lanes.advance(effort);
        for (lane, scalar) in scalars.iter_mut().enumerate() {
            let alone = scalar.advance(T::of(effort.lane(lane)));
            assert_eq!(sample.position.lane(lane).to_bits(), alone.position.lane(0).to_bits());
            assert_eq!(sample.velocity.lane(lane).to_bits(), alone.velocity.lane(0).to_bits());
        }
    }
}

fn lanes_are_scalars<T: Scalar, L: Scalar>() {
    let mass = |lane: usize| 0.2 + 0.1 * lane as f64;
    let one =
        |lane| Oscillator::new(Impedance { mass: T::of(mass(lane)), ..hand() }).expect("parts");
    let ones = Oscillator::new(Impedance { mass: L::from_lanes(mass), ..hand() }).expect("parts");
    let device = |lane| DampedMass { mass: T::of(mass(lane)), damping: T::of(0.1) };
    let two = |lane| CoupledOscillators::new(TwoMassParts { device: device(lane), ..pair() });
    let two = |lane| two(lane).expect("parts");
    let device = DampedMass { mass: L::from_lanes(mass), damping: L::of(0.1) };
    let twos = CoupledOscillators::new(TwoMassParts { device, ..pair() }).expect("parts");
    macro_rules! with {
        ($period:literal: $($integrator:expr),+) => {$(
            let (short, wide) = (T::of($period), L::of($period));
            lane_by_lane(
                |lane| moved::<T, _, _>(one(lane), $integrator, short, 3),
                moved::<L, _, _>(ones, $integrator, wide, 3),
            );
            lane_by_lane(
                |lane| moved::<T, _, _>(two(lane), $integrator, short, 3),
                moved::<L, _, _>(twos, $integrator, wide, 3),
            );
        )+};
    }
    with!(1e-3: SemiImplicitEuler, ImplicitMidpoint, RungeKutta4, RungeKuttaNystrom4, Exact::new());
    with!(1e-3: DormandPrince5, DormandPrince8);
    // With this tolerance lanes take steps of their own, some more than others.
    let tolerance = 1e-5;
    with!(1.0: Adaptive::new(DormandPrince5, Scalar::of(tolerance)).expect("a tolerance"));
    with!(1.0: Adaptive::new(DormandPrince8, Scalar::of(tolerance)).expect("a tolerance"));
}

#[test]
fn each_lane_is_its_scalar_run_bit_for_bit() {
    lanes_are_scalars::<f64, AutoF64x4>();
    lanes_are_scalars::<f64, WideF64x4>();
    lanes_are_scalars::<f32, AutoF32x8>();
}
