//! Neutral settings, which change no bit.

use lyapunov::laws::Samples;
use lyapunov::{
    Scalar, Signal, Stabilizer,
    stabilizers::{DriftCompensated, StabilizerExt},
};
use nalgebra::Vector3;

use crate::support::{PERIOD, popc};

fn same<V: Signal>(mut one: impl Stabilizer<V>, mut other: impl Stabilizer<V>) {
    for (sample, effort) in Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(5) {
        let (a, b) = (one.stabilize(&sample, effort), other.stabilize(&sample, effort));
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
    }
}

fn neutral<V: Signal>() {
    let of = V::Scalar::of;
    let popc = popc::<V::Scalar>();
    same::<V>(popc.budgeted(of(0.0)).expect("none"), popc);
    same::<V>(popc.bounded(of(f64::INFINITY)).expect("none"), popc);
    same::<V>(popc.above_velocity(of(0.0)).expect("none"), popc);
    same::<V>(popc.spread_over(1).expect("none"), popc);
    same::<V>(popc.rising_over(1).expect("none"), popc);
    same::<V>(popc.rate_limited::<V>(of(f64::INFINITY)).expect("none"), popc);
    same::<V>(DriftCompensated::<_, V>::new(popc, of(0.0)).expect("none"), popc);
}

#[test]
fn on_a_line_and_in_space() {
    neutral::<f64>();
    neutral::<f32>();
    neutral::<Vector3<f64>>();
    neutral::<Vector3<f32>>();
}
