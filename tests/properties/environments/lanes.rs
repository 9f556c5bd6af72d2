//! Lanes of environments, each equal to its scalar run bit for bit.

use proptest::array::{uniform2, uniform16};
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::lanes::{AutoF32x4, AutoF32x8, AutoF64x4, AutoF64x8, WideF32x8, WideF64x4};
use lyapunov::{LyapunovCandidate, OnePort, PortSample, Scalar};

use super::models::{Environment, Example2, Hunt, Layered, Moving, Parts, Varying, each};
use crate::support::{Bits, CASES, Real, bad, hold, hostile, same};

/// A motion near the surface, or any numbers at all.
fn sample<T: Scalar, R: Real>(parts: &Parts<T>, bits: [Bits; 2], first: usize) -> PortSample<T> {
    let sample = parts.sample(bits, first);
    let any = |bits: Bits| each(bits, first, |bits| hostile::<R>(bits >> 3).f64());
    let none = |bits: Bits| each(bits, first, |bits| bad::<R>(bits >> 3).f64());
    match bits[0] % 8 {
        0 => PortSample { position: any(bits[0]), velocity: any(bits[1]), ..sample },
        1 => PortSample { position: none(bits[0]), ..sample },
        2 => PortSample { velocity: none(bits[1]), ..sample },
        _ => sample,
    }
}

fn equals<E: Environment, L: Scalar, R: Real>() {
    let samples = vec(uniform2(any::<Bits>()), 1..12);
    hold(CASES / 20, (uniform16(any::<Bits>()), samples), |(bits, samples)| {
        let parts = Parts::<L>::of(&bits, 0);
        let (mut port, mut term) = E::build(parts);
        let mut alone: Vec<_> = (0..L::LANES)
            .map(|lane| {
                let parts = Parts::<R>::of(&bits, lane);
                (parts, E::build(parts))
            })
            .collect();
        for (call, reading) in samples.into_iter().enumerate() {
            let lanes = sample::<L, R>(&parts, reading, 0);
            let (effort, credit) = (port.respond(&lanes), term.decrease(&lanes));
            for (lane, (parts, (port, term))) in alone.iter_mut().enumerate() {
                let sample = sample::<R, R>(parts, reading, lane);
                prop_assert!(same(lanes.position.lane(lane), sample.position.f64()));
                let (one, other) = (effort.lane(lane), port.respond(&sample).f64());
                prop_assert!(same(one, other), "call {call}, lane {lane}: {one:e}, {other:e}");
                let (one, other) = (credit.lane(lane), term.decrease(&sample).f64());
                prop_assert!(same(one, other), "credit {call}, lane {lane}: {one:e}, {other:e}");
            }
        }
        Ok(())
    });
}

fn all<L: Scalar, R: Real>() {
    equals::<Layered, L, R>();
    equals::<Hunt, L, R>();
    equals::<Moving, L, R>();
    equals::<Varying, L, R>();
    equals::<Example2<false>, L, R>();
    equals::<Example2<true>, L, R>();
}

#[test]
fn lanes_of_f64() {
    all::<AutoF64x4, f64>();
    all::<AutoF64x8, f64>();
    all::<WideF64x4, f64>();
}

#[test]
fn lanes_of_f32() {
    all::<AutoF32x4, f32>();
    all::<AutoF32x8, f32>();
    all::<WideF32x8, f32>();
}
