//! Exact steps against exact bodies.

use lyapunov::lanes::AutoF64x4;
use lyapunov::laws::Samples;
use lyapunov::{
    Plant, Scalar,
    bodies::{Body, Impedance, PlantExt, TwoMassBody},
    integrators::{CoupledOscillators, Exact, Oscillator},
    trajectories::Sine,
};

use crate::{hand, moved, pair};

fn exactly_as<T: Scalar>() {
    let of = T::of;
    let period = of(1e-3);
    let led = Sine::new(0.001, 0.01, 2.0, 1000.0).expect("a sine");
    let firm = Impedance { stiffness: of(400.0), ..hand() };
    let body = Body::new(hand(), period).expect("a body").starting(of(-0.004), of(0.1));
    let dynamics = Oscillator::new(hand()).expect("parts");
    let stepped = moved(dynamics, Exact::new(), period, 1).starting(of(-0.004), of(0.1));
    let mut one = body.led_by(led).gripped(hand(), [(300, firm)]).expect("a grip");
    let mut other = stepped.led_by(led).gripped(hand(), [(300, firm)]).expect("a grip");
    let linked = TwoMassBody::new(pair(), period).expect("a body").resting_at(of(0.01));
    let mut linked = linked.starting(of(-0.004), of(0.1));
    let dynamics = CoupledOscillators::new(pair()).expect("parts");
    let mut coupled = moved(dynamics, Exact::new(), period, 1).resting_at(of(0.01));
    coupled = coupled.starting(of(-0.004), of(0.1));
    assert_eq!(one.start(), other.start());
    assert_eq!(linked.start(), coupled.start());
    for (_, effort) in Samples::<T>::new(period) {
        assert_eq!(one.advance(effort), other.advance(effort));
        assert_eq!(linked.advance(effort), coupled.advance(effort));
    }
}

#[test]
fn one_exact_step_is_the_exact_body_bit_for_bit() {
    exactly_as::<f64>();
    exactly_as::<f32>();
    exactly_as::<AutoF64x4>();
}
