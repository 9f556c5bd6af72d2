//! Wave variables: they decode to what was sent, and store the energy under way.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{
    Scalar,
    channels::{Channel, ConstantDelay},
    stabilizers::WaveTransform,
    stabilizers::{WaveFilter, WaveFollower},
};
use nalgebra::Vector3;

use crate::support::{Dice, PERIOD};
use crate::worked::near;

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
    for ticks in 0..8_u32 {
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
            let from = (tick + 1usize).saturating_sub(ticks as usize);
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

fn worked<T: Scalar>() {
    let wave = WaveTransform::new(T::of(2.0)).expect("an impedance");
    for (v, f, there, back) in
        [(0.5, 3.0, 2.0, -1.0), (-0.5, 3.0, 1.0, -2.0), (0.0, 1.0, 0.5, -0.5), (0.1, 0.2, 0.2, 0.0)]
    {
        let (u, w) = wave.encode(T::of(v), T::of(f));
        near(&[u.lane(0), w.lane(0)], &[there, back]);
    }
    let (stiffness, b) = (T::of(50.0), T::of(8.0));
    let matched = WaveFollower::matched(wave, stiffness).expect("a follower");
    let stiff = WaveFollower::new(wave, stiffness, b).expect("a follower");
    let asked = [(1.0, 0.0, 0.0), (1.0, 0.01, 0.0), (1.0, 0.01, 0.5)];
    let [rest, pulled, moving] = [[0.5, 1.0, 0.0], [0.375, 1.25, -0.25], [0.625, 0.75, 0.25]];
    let other = [[0.2, 1.6, -0.6], [0.15, 1.7, -0.7], [0.55, 0.9, 0.1]];
    for (follower, expected) in [(matched, [rest, pulled, moving]), (stiff, other)] {
        for ((u, e, v), expected) in asked.into_iter().zip(expected) {
            let found = follower.follow(T::of(u), T::of(e), T::of(v));
            near(&[found.flow, found.effort, found.back].map(|it| it.lane(0)), &expected);
        }
    }
    let mut filter = WaveFilter::new(T::of(0.25)).expect("a filter");
    let sent = [1.0, 1.0, 1.0, 0.0, 0.0, -1.0].map(|wave| filter.pass(T::of(wave)).lane(0));
    near(&sent, &[0.25, 0.4375, 0.578125, 0.433594, 0.325195, -0.00610352]);
}

crate::worked::each_scalar!(the_worked_rows, worked);

/// What comes in goes on or comes back, `F v = (u² − w²) / 2`, and of a slave that rests the share `(b − B) / (b + B)` comes back.
#[test]
fn a_follower_keeps_the_power_and_reflects_by_its_mismatch() {
    let (b, mut dice) = (1.7, Dice::of(8));
    let wave = WaveTransform::new(b).expect("an impedance");
    for damping in [0.0, 0.5, 1.7, 20.0] {
        let follower = WaveFollower::new(wave, 80.0, damping).expect("a follower");
        for _ in 0..200 {
            let (u, e, v): (Vector3<f64>, Vector3<f64>, Vector3<f64>) =
                (dice.signal(2.0), dice.signal(0.1), dice.signal(1.0));
            let found = follower.follow(u, e, v);
            let power = (u.norm_squared() - found.back.norm_squared()) / 2.0;
            assert!((power - found.effort.dot(&found.flow)).abs() < 1e-12 * (1.0 + power.abs()));
            let law = (found.flow - v) * damping + e * 80.0;
            assert!((found.effort - law).norm() < 1e-12 * (1.0 + law.norm()));
            let rest = follower.follow(u, Vector3::zeros(), Vector3::zeros());
            let reflected = u * ((b - damping) / (b + damping));
            assert!((rest.back - reflected).norm() < 1e-12);
        }
    }
    assert!(WaveFollower::new(wave, -1.0, 1.0).is_err());
    assert!(WaveFollower::new(wave, 1.0, f64::NAN).is_err());
}

/// No more comes out of a filter than went in, and with it in both paths the channel stays passive, losses included.
#[test]
fn a_filter_gives_no_energy() {
    for (share, loss) in [(1.0, 0.0), (0.25, 0.0), (0.05, 0.3), (1.0, 0.9)] {
        let wave = WaveTransform::new(1.3).expect("an impedance");
        let (mut dice, mut crossed, mut returning) = (Dice::of(3), 0.0, 0.0);
        let (mut came, mut went) = (0.0, 0.0);
        let mut filters = [WaveFilter::new(share).expect("a filter"); 2];
        let channel = || ConstantDelay::<f64, 8>::new(5, 0.0).expect("a delay");
        let (mut there, mut back) = (channel(), channel());
        let lost =
            |wave: f64, dice: &mut Dice| if dice.within(1.0).abs() < loss { 0.0 } else { wave };
        for _ in 0..2000 {
            let (flow, force) = (dice.within(1.0), dice.within(5.0));
            let (felt, sent) = wave.effort(flow, returning);
            let filtered = filters[0].pass(sent);
            came += sent * sent;
            went += filtered * filtered;
            assert!(went <= came * (1.0 + 1e-12));
            let arrived = lost(there.carry(filtered), &mut dice);
            let (moves, answered) = wave.flow(force, arrived);
            crossed += felt * flow - force * moves;
            returning = lost(back.carry(filters[1].pass(answered)), &mut dice);
            assert!(crossed >= -1e-9, "{crossed}");
        }
    }
    assert!(WaveFilter::<f64>::new(0.0).is_err() && WaveFilter::<f64>::new(1.1).is_err());
    let mut neutral = WaveFilter::new(1.0).expect("a filter");
    let mut dice = Dice::of(6);
    for _ in 0..1000 {
        let wave = dice.within(1.0) * 2f64.powf(dice.within(40.0));
        assert_eq!(neutral.pass(wave).to_bits(), wave.to_bits());
    }
    let mut filter = WaveFilter::new(0.5).expect("a filter");
    assert_eq!((filter.pass(f64::NAN), filter.pass(1.0)), (0.0, 0.5));
}
