//! Filters, noise and dropout on lanes, with parameters and seeds of their own in each lane: each lane equals its
//! scalar run bit for bit.

use nalgebra::SVector;
use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::lanes::{AutoF32x4, AutoF64x8, WideF32x8, WideF64x4};
use lyapunov::{
    HeldTick, OnePort, ParameterError, Scalar, Signal,
    bodies::Impedance,
    effects::{Fallback, OnePortExt},
    environments::MassSpringDamper,
};

use crate::support::{Bits, CASES, Real, hold, log_between, same, unit};

const TICKS: usize = 30;

struct Parameters {
    bits: [Bits; 8],
}

impl Parameters {
    fn spread(&self, lane: usize, which: usize) -> Bits {
        let spread = (lane as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (self.bits[which % 8] ^ spread ^ which as u64).wrapping_mul(0xbf58_476d_1ce4_e5b9)
    }

    fn each<T: Scalar>(&self, first: usize, which: usize, least: f64, most: f64) -> T {
        T::from_lanes(|lane| log_between(self.spread(first + lane, which), least, most))
    }

    /// The answers of a damper behind the effects, to a random walk of each axis and lane.
    fn run<V: Signal>(&self, first: usize) -> Result<Vec<V>, ParameterError> {
        let (mass, damping, stiffness) =
            (V::Scalar::of(0.0), self.each(first, 0, 0.1, 5.0), self.each(first, 1, 10.0, 1e3));
        let environment = MassSpringDamper::new(Impedance { mass, damping, stiffness })?;
        let seed = |which| move |lane: usize| self.spread(first + lane, which);
        let policy = [Fallback::Hold, Fallback::Zero][self.bits[0] as usize % 2];
        // In some lanes there is no noise.
        let deviation: V::Scalar = self.each(first, 2, 1e-7, 1e-4);
        let deviation = V::Scalar::from_lanes(|lane| {
            deviation.lane(lane) * (self.bits[3] >> (first + lane) & 1) as f64
        });
        let dropped = environment.dropped(self.each(first, 3, 1e-2, 1.0), policy, seed(4))?;
        let ticks = 1 + (self.bits[5] % 6) as u32;
        let mut filtered = dropped
            .low_passed(self.each(first, 6, 1.0, 1e3))?
            .encoded(self.each(first, 7, 1e-6, 1e-4))?
            .noisy(deviation, seed(8))?;
        let mut windowed = dropped
            .held(1 + (self.bits[1] % 3) as u32)?
            .windowed::<6>(ticks, self.each(first, 7, 1e-6, 1e-3))?
            .noisy(deviation, seed(9))?;
        let (period, mut position) = (V::Scalar::of(1e-3), V::zero());
        let mut answers = Vec::new();
        for tick in 0..TICKS {
            let mut axis = 0;
            let moved = V::zero().map(|_| {
                axis += 1;
                let which = 100 * tick + axis;
                let step = |lane| 1e-4 * (2.0 * unit(self.spread(first + lane, which)) - 1.0);
                V::Scalar::from_lanes(step)
            });
            position = position + moved;
            let applied = answers.last().copied().unwrap_or_else(V::zero);
            let sample =
                HeldTick { period, position, velocity: moved, displacement: moved, applied }
                    .sample();
            answers.push(filtered.respond(&sample));
            answers.push(windowed.respond(&sample));
        }
        Ok(answers)
    }
}

fn agree<L: Scalar, T: Real>(bits: [Bits; 8]) -> TestCaseResult {
    let parameters = Parameters { bits };
    let lanes = parameters.run::<SVector<L, 3>>(0).expect("right parameters");
    for lane in 0..L::LANES {
        let alone = parameters.run::<SVector<T, 3>>(lane).expect("right parameters");
        for (call, (lanes, alone)) in lanes.iter().zip(&alone).enumerate() {
            let equal = (0..3).all(|axis| same(lanes[axis].lane(lane), alone[axis].f64()));
            prop_assert!(equal, "lane {lane}, answer {call}: {lanes:?} for {alone:?}");
        }
    }
    Ok(())
}

macro_rules! lanes {
    ($($name:ident: $lanes:ident of $real:ident),+ $(,)?) => {$(
        #[test]
        fn $name() {
            hold(CASES / 20, uniform8(any::<Bits>()), agree::<$lanes, $real>);
        }
    )+};
}

lanes! {
    auto_f32x4: AutoF32x4 of f32,
    auto_f64x8: AutoF64x8 of f64,
    wide_f32x8: WideF32x8 of f32,
    wide_f64x4: WideF64x4 of f64,
}

/// The runs are worth comparing: answers differ from lane to lane and from call to call.
#[test]
fn runs_show_something() {
    let parameters = Parameters { bits: [1, 2, 3, 4, 5, 6, 7, 8] };
    let answers = parameters.run::<AutoF64x8>(0).expect("right parameters");
    for answers in answers.chunks(2).collect::<Vec<_>>().windows(2).skip(4).step_by(7) {
        let differ = (1..8).filter(|lane| answers[1][0].lane(*lane) != answers[1][0].lane(0));
        assert!(differ.count() > 3);
    }
    let last = answers.len() - 1;
    assert!((0..8).any(|lane| answers[last].lane(lane) != answers[last - 6].lane(lane)));
}
