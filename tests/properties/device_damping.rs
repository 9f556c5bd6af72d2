//! Credit of a device's own damper: never more than the damper dissipates.
//!
//! With the backward difference `v = Δx / T` the credit of a tick is `b Δx² / T`, and by the Cauchy-Schwarz inequality
//! `b ∫ v² dt` is at least that.

use approx::abs_diff_eq;
use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{
    Dissipation, LyapunovCandidate, OnePort, Plant, PortSample, Scalar,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Spring,
};

use crate::support::{
    Bits, CASES, Gain, Motion, Port, Real, Scripted, Spy, State, hold, log_between, ordinary, unit,
};

/// The energy that the damper of one axis dissipates over a period.
fn burnt(motion: &Motion, nodes: &[(Gain, f64)], start: State, effort: f64) -> f64 {
    let power = |velocity: f64| motion.damping * velocity * velocity;
    let at =
        |(gain, weight): &(Gain, f64)| weight * power(gain.step(motion, start, effort).velocity);
    nodes.iter().map(at).sum()
}

/// Additional credit by the rounding of positions: `b ((|Δx| + δ)² − Δx²) / T` for a displacement with the
/// error `δ`, the rounding of both positions and of the three terms that move the body.
fn rounding<T: Real>(motion: &Motion, gain: &Gain, start: State, effort: f64, period: f64) -> f64 {
    let State { position, velocity } = start;
    let [by_position, by_velocity, by_effort] = gain.position;
    let terms = [by_position * position, by_velocity * velocity, by_effort * effort];
    let moved: f64 = terms.iter().sum();
    let size: f64 = terms.iter().map(|term| term.abs()).sum();
    let off = T::unit() * (2.0 * position.abs() + 10.0 * size) + 4.0 * T::smallest_positive().f64();
    motion.damping * off * (2.0 * moved.abs() + off) / period
}

/// The sample of a port that takes its velocities from displacements.
fn told<V: Port>(sample: &PortSample<V>) -> PortSample<V> {
    let mut spy = Spy::on(Scripted::of(Vec::new()));
    (&mut spy).differenced().respond(sample);
    spy.asked[0]
}

mod check {
    use super::*;

    pub(super) fn is_at_most_what_dissipates<V: Port>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let of = |value: f64| V::Scalar::of(value);
            let impedance = Impedance {
                mass: of(log_between(bits[0], 0.05, 2.0)),
                damping: of(5.0 * unit(bits[1])),
                stiffness: of(200.0 * unit(bits[2])),
            };
            let period = of(log_between(bits[3], 1e-3, 0.05));
            let Impedance { mass, damping, stiffness } = impedance;
            let [mass, damping, stiffness] = [mass, damping, stiffness].map(Real::f64);
            let motion = Motion { mass, damping, stiffness, rest: 0.0 };
            let (whole, nodes) = (motion.over(period.f64()), motion.nodes(period.f64()));
            let start = V::from_axes(|axis| ordinary(bits[5 + axis], 0.01));
            let flow = V::from_axes(|axis| ordinary(bits[8 + axis], 0.5));
            let mut plant = Body::new(impedance, period).expect("a body").starting(start, flow);
            let mut port = Spring::new(of(log_between(bits[4], 10.0, 1000.0))).expect("a spring");
            let mut credit = Dissipation::of(impedance.damping).expect("a damping");
            let mut before = plant.start();
            for _ in 0..20 {
                let effort = port.respond(&before);
                let sample = plant.advance(effort);
                let credited = credit.decrease(&told(&sample)).f64();
                let mut most = 0.0;
                for axis in 0..V::AXES {
                    let (position, velocity) =
                        (before.position.axis(axis).f64(), before.velocity.axis(axis).f64());
                    let (from, effort) = (State { position, velocity }, effort.axis(axis).f64());
                    most += burnt(&motion, &nodes, from, effort)
                        + rounding::<V::Scalar>(&motion, &whole, from, effort, period.f64());
                }
                // The credit itself is a product of rounded factors.
                most *= 1.0 + 16.0 * V::Scalar::unit();
                prop_assert!(credited <= most, "{credited:e} J of {most:e} burnt");
                before = sample;
            }
            Ok(())
        });
    }

    /// Where the velocity is constant, because the effort makes up for the damper, the credit is all that is
    /// dissipated.
    pub(super) fn is_all_that_dissipates_at_constant_speed<V: Port>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let of = |value: f64| V::Scalar::of(value);
            let (mass, damping) = (of(log_between(bits[0], 0.05, 2.0)), of(5.0 * unit(bits[1])));
            let period = of(log_between(bits[3], 1e-3, 0.05));
            let impedance = Impedance { mass, damping, stiffness: of(0.0) };
            let flow = V::from_axes(|axis| ordinary(bits[8 + axis], 0.5));
            let body = Body::new(impedance, period).expect("a body");
            let sample = body.starting(V::zero(), flow).advance(flow.scale(-damping));
            let credited = Dissipation::of(damping).expect("a damping").decrease(&told(&sample));
            let square: f64 = flow.axes().map(|v| v.f64() * v.f64()).sum();
            let burnt = damping.f64() * square * period.f64();
            // Twice the relative error of the displacement, which is summed from two terms of like size.
            let bound = 64.0
                * V::Scalar::unit()
                * burnt
                * (1.0 + damping.f64() * period.f64() / mass.f64());
            prop_assert!(
                abs_diff_eq!(credited.f64(), burnt, epsilon = bound),
                "{credited:?} of {burnt:e}"
            );
            Ok(())
        });
    }
}

crate::support::every_port!(is_at_most_what_dissipates, is_all_that_dissipates_at_constant_speed);
