//! Wave variables: they decode to what was sent, and store the energy under way.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    Scalar,
    channels::{Channel, ConstantDelay},
    stabilizers::WaveTransform,
};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD};

/// The distance from a number to the next, in its own scalar.
fn ulp<T: Scalar>(size: f64) -> f64 {
    size.log2().floor().exp2() * T::epsilon().lane(0)
}

fn round_trip<T: Scalar>() {
    let mut dice = Dice::of(11);
    let mut most = 0f64;
    for _ in 0..200_000 {
        let power = |dice: &mut Dice| 2f64.powf(dice.within(20.0));
        let impedance = T::of(power(&mut dice));
        let wave = WaveTransform::new(impedance).expect("an impedance");
        let v = T::of(dice.within(1.0).signum() * power(&mut dice));
        // As large as b v, so that neither hides the other's error; now and then anything.
        let like = if dice.within(1.0) > 0.0 { impedance.lane(0) * v.lane(0) } else { 1.0 };
        let f = T::of(dice.within(3.0) * like);
        let (there, back) = wave.encode(v, f);
        let (flow, effort) = wave.decode(there, back);
        let (b, v, f) = (impedance.lane(0), v.lane(0), f.lane(0));
        let unit = ulp::<T>((b * v).abs().max(f.abs()));
        most = most.max(b * (flow.lane(0) - v).abs() / unit).max((effort.lane(0) - f).abs() / unit);
    }
    assert!(most <= 4.0, "{most} ulp");
    assert!(most > 0.5, "nothing was rounded: {most} ulp");
}

#[test]
fn round_trip_in_single_and_double_precision() {
    round_trip::<f64>();
    round_trip::<f32>();
}

#[test]
fn power_is_the_difference_of_the_waves() {
    let wave = WaveTransform::new(0.7).expect("an impedance");
    let mut dice = Dice::of(4);
    for _ in 0..1000 {
        let (v, f): (Vector3<f64>, Vector3<f64>) = (dice.signal(2.0), dice.signal(3.0));
        let (there, back) = wave.encode(v, f);
        let power = (there.norm_squared() - back.norm_squared()) / 2.0;
        assert_abs_diff_eq!(power, f.dot(&v), epsilon = 1e-13);
        let (effort, sent) = wave.effort(v, back);
        assert!((effort - f).norm() < 1e-13 && (sent - there).norm() < 1e-13);
        let (flow, sent) = wave.flow(f, there);
        assert!((flow - v).norm() < 1e-13 && (sent - back).norm() < 1e-13);
    }
}

/// The energy that went in at both ends is what is under way, tick by tick, and that is a sum of squares.
#[test]
fn a_constant_delay_stores_what_is_under_way() {
    for ticks in 0..8usize {
        let wave = WaveTransform::new(1.3).expect("an impedance");
        let mut there = ConstantDelay::<f64, 8>::new(ticks, 0.0).expect("a delay");
        let mut back = ConstantDelay::<f64, 8>::new(ticks, 0.0).expect("a delay");
        let (mut dice, mut stored, mut returning) = (Dice::of(3), 0.0, 0.0);
        let mut sent = Vec::new();
        for tick in 0..2000 {
            // The master moves as it likes, the slave's environment pushes as it likes.
            let (flow, force) = (dice.within(1.0), dice.within(5.0));
            let (felt, wave_there) = wave.effort(flow, returning);
            let (moves, wave_back) = wave.flow(force, there.carry(wave_there));
            stored += (felt * flow - force * moves) * PERIOD;
            returning = back.carry(wave_back);
            sent.push((wave_there, wave_back));
            // What returns is used on the next tick, so one more of those is under way.
            let from = (tick + 1usize).saturating_sub(ticks);
            let squares: f64 = sent[from..].iter().map(|(u, w)| u * u + w * w).sum();
            let waiting = squares + returning * returning;
            let under_way = waiting * PERIOD / 2.0;
            assert!(
                abs_diff_eq!(stored, under_way, epsilon = 1e-11),
                "{stored:e} of {under_way:e} J"
            );
        }
    }
}

#[test]
fn a_matched_end_sends_nothing_back() {
    let wave = WaveTransform::new(2.5).expect("an impedance");
    let (there, _) = wave.encode(0.4, 1.0);
    // F = b v with v = (√(2b) u − F) / b: F = √(b / 2) u.
    let (flow, back) = wave.flow((2.5_f64 / 2.0).sqrt() * there, there);
    assert!(
        back.abs() < 1e-15
            && abs_diff_eq!(flow * 2.5, (2.5_f64 / 2.0).sqrt() * there, epsilon = 1e-15)
    );
}
