//! Values stored and read back, bit for bit.

use std::fmt::Debug;

use lyapunov::laws::Samples;
use lyapunov::telemetry::{EnergyMeter, EnergySummary, RecordedTick};
use lyapunov::{
    AdmittanceSample, Correction, DampingLimit, Popc, PortEnergy, PortSample, Scalar, Signal,
    Stabilizer, accumulators::DoubleDouble, integrators::State,
};
use nalgebra::{Vector2, Vector6};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// `value` after a way through JSON. Debug text shows every digit and the sign of 0.
#[track_caller]
fn comes_back<T: Serialize + DeserializeOwned + Debug>(value: &T) {
    let text = serde_json::to_string(value).expect("it is written");
    let read: T = serde_json::from_str(&text).expect("it is read");
    assert_eq!(format!("{read:?}"), format!("{value:?}"), "{text}");
}

fn ticks_come_back<V: Signal + Serialize + DeserializeOwned>()
where
    V::Scalar: Serialize + DeserializeOwned,
    <V::Scalar as Scalar>::Mask: Serialize + DeserializeOwned,
{
    let of = V::Scalar::of;
    let mut popc = Popc::new(PortEnergy, DampingLimit::at(of(100.0)).expect("a limit"));
    let mut meter = EnergyMeter::new();
    for (sample, effort) in Samples::<V>::new(of(1e-3)) {
        let correction = popc.stabilize(&sample, effort);
        meter.add(&sample, &correction);
        comes_back(&RecordedTick { sample, correction });
        let PortSample { period, position, velocity, displacement, applied, work } = sample;
        comes_back(&AdmittanceSample {
            period,
            momentum: position,
            effort: velocity,
            impulse: displacement,
            flow: applied,
            work,
        });
        comes_back(&State { position, velocity });
    }
    comes_back(&meter.summary());
}

#[test]
fn samples_and_corrections_come_back() {
    ticks_come_back::<f64>();
    ticks_come_back::<f32>();
    ticks_come_back::<Vector2<f64>>();
    ticks_come_back::<Vector6<f32>>();
    ticks_come_back::<DoubleDouble>();
    comes_back(&Correction::<f64> { accepted: false, ..Correction::none(-0.0) });
}

/// The names are part of a stored file, so they are written out here.
#[test]
fn fields_are_stored_by_name() {
    let sample = PortSample::<f32>::new(0.5, 1.0, 2.0, 3.0, 4.0);
    assert_eq!(
        serde_json::to_string(&sample).expect("text"),
        r#"{"period":0.5,"position":1.0,"velocity":2.0,"displacement":3.0,"applied":4.0,"work":12.0}"#
    );
    assert_eq!(
        serde_json::to_string(&Correction::none(Vector2::new(1.0, 2.0))).expect("text"),
        r#"{"effort":[1.0,2.0],"observed_energy":0.0,"alpha":0.0,"shortfall":0.0,"accepted":true}"#
    );
    let summary = EnergySummary { ticks: 3, active: 1.0, ..EnergySummary::<f32>::default() };
    let text = serde_json::to_string(&summary).expect("text");
    assert!(
        text.starts_with(r#"{"ticks":3,"active":1.0,"rejected":0.0,"now":0.0,"least""#),
        "{text}"
    );
}

/// JSON knows no number that is not finite, and nothing takes one for 0.
#[test]
fn what_is_not_finite_is_refused_by_json() {
    let text = serde_json::to_string(&PortSample::starting(1e-3, f64::NAN, 0.0)).expect("text");
    assert!(serde_json::from_str::<PortSample<f64>>(&text).is_err(), "{text}");
}

/// A pair from elsewhere, whose parts overlap, becomes the number that it adds up to.
#[test]
fn a_foreign_pair_is_made_our_own() {
    let read: DoubleDouble = serde_json::from_str(r#"{"high":1.0,"low":1.0}"#).expect("a pair");
    assert_eq!((read.high(), read.low()), (2.0, 0.0));
    let third = DoubleDouble::of(1.0) / DoubleDouble::of(3.0);
    comes_back(&third);
    comes_back(&DoubleDouble::of(-0.0));
}
