//! Sum for each axis: its reports, and every axis as it would be alone.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::laws::Samples;
use lyapunov::{
    DampingLimit, HeldTick, Lolc, Mask, PortEnergy, PortSample, Scalar, Signal, Stabilizer,
    stabilizers::PerAxis,
};
use nalgebra::SVector;

type Popc<T> = Lolc<T, PortEnergy>;

fn popc<T: Scalar>(cap: f64) -> Popc<T> {
    let limit = DampingLimit::of_mass(T::of(cap), T::of(0.2), T::of(1e-3)).expect("a limit");
    Lolc::new(PortEnergy, limit)
}

fn samples<V: Signal>(seed: u64) -> Samples<V> {
    Samples::new(V::Scalar::of(1e-3)).seeded(seed)
}

fn alone(sample: &PortSample<SVector<f64, 3>>, axis: usize) -> PortSample<f64> {
    sample.map(sample.period, |axes| axes[axis])
}

#[test]
fn every_axis_acts_as_it_would_alone() {
    let mut each = PerAxis::of([popc::<f64>(0.5); 3]);
    let mut single = [popc::<f64>(0.5); 3];
    let mut active = 0;
    for (sample, effort) in samples::<SVector<f64, 3>>(7) {
        let correction = each.stabilize(&sample, effort);
        let told: Vec<_> = (0..3)
            .map(|axis| single[axis].stabilize(&alone(&sample, axis), effort[axis]))
            .collect();
        for (axis, told) in told.iter().enumerate() {
            assert_eq!(correction.effort[axis].to_bits(), told.effort.to_bits());
        }
        let least = told.iter().map(|it| it.observed_energy).fold(f64::INFINITY, f64::min);
        let most = told.iter().map(|it| it.alpha).fold(0.0, f64::max);
        let owed: f64 = told.iter().map(|it| it.shortfall).sum();
        assert_eq!((correction.observed_energy, correction.shortfall), (least, owed));
        // The reported dissipation is that of the axes, no less, and more by a rounding at most.
        let burns = |v: f64, alpha: f64| alpha * v * v;
        let burnt: f64 = (0..3).map(|axis| burns(sample.velocity[axis], told[axis].alpha)).sum();
        let said = correction.alpha * sample.velocity.norm_squared();
        assert!(said <= burnt * (1.0 + 1e-14) && correction.alpha <= most, "{said} {burnt}");
        assert!(said >= burnt * (1.0 - 1e-14) || correction.alpha == most, "{said} {burnt}");
        active += usize::from(correction.alpha > 0.0);
    }
    assert!(active > 100);
}

/// +1 mJ on x, −0.9 mJ on y.
#[test]
fn one_sum_is_silent_where_a_sum_per_axis_acts() {
    let axes = |x, y| SVector::from([x, y]);
    let sample = HeldTick {
        period: 1e-3,
        position: axes(0.0, 0.0),
        velocity: axes(0.1, 0.1),
        displacement: axes(1e-4, 1e-4),
        applied: axes(10.0, -9.0),
    }
    .sample();
    let effort = axes(0.5, 0.5);
    let one = popc::<f64>(0.5).stabilize(&sample, effort);
    assert!(
        abs_diff_eq!(one.observed_energy, 1e-4, epsilon = 1e-18)
            && one.alpha == 0.0
            && one.effort == effort
    );
    let each = PerAxis::of([popc::<f64>(0.5); 2]).stabilize(&sample, effort);
    assert_abs_diff_eq!(each.observed_energy, -9e-4, epsilon = 1e-18);
    // Half of m / T is 100 N·s/m; 0.9 mJ would take 90 at 0.1 m/s.
    assert!(each.effort.x == 0.5 && abs_diff_eq!(each.effort.y, 9.5, epsilon = 1e-9));
    assert!(abs_diff_eq!(each.alpha, 45.0, epsilon = 1e-9) && each.shortfall == 0.0);
}

#[test]
fn a_bad_axis_does_not_stop_the_others() {
    let axes = |x, y| SVector::from([x, y]);
    let sample = HeldTick {
        period: 1e-3,
        position: axes(0.0, 0.0),
        velocity: axes(f64::NAN, 0.1),
        displacement: axes(1e-4, 1e-4),
        applied: axes(10.0, -9.0),
    }
    .sample();
    let correction = PerAxis::of([popc::<f64>(0.5); 2]).stabilize(&sample, axes(0.5, 0.5));
    assert!(!correction.accepted.all());
    assert!(correction.effort.x == 0.0 && abs_diff_eq!(correction.effort.y, 9.5, epsilon = 1e-9));
    assert!(correction.alpha.is_finite() && correction.observed_energy.is_finite());
}
