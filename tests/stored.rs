//! Values stored and read back, bit for bit.

use std::fmt::Debug;

use ciborium::Value;
use lyapunov::laws::Samples;
use lyapunov::telemetry::{EnergyMeter, EnergySummary, RecordedTick};
use lyapunov::{
    AdmittanceSample, CheckedSample, Correction, DampingLimit, Popc, PortEnergy, PortSample,
    Reading, Readings, Scalar, Signal, Stabilizer,
    accumulators::DoubleDouble,
    integrators::State,
    poses::{BodyAxes, Pose, Screw, WithPose},
};
use nalgebra::{Isometry3, Vector2, Vector3, Vector6};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// `value` after a way through CBOR. Debug text shows every digit and the sign of 0.
#[track_caller]
fn comes_back<T: Serialize + DeserializeOwned + Debug>(value: &T) {
    let mut bytes = Vec::new();
    ciborium::into_writer(value, &mut bytes).expect("it is written");
    let read: T = ciborium::from_reader(&bytes[..]).expect("it is read");
    assert_eq!(format!("{read:?}"), format!("{value:?}"));
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

/// The keys of a stored value, in their order.
fn keys(value: &impl Serialize) -> String {
    let stored = Value::serialized(value).expect("a value");
    let fields = stored.into_map().expect("fields by name");
    let names: Vec<String> =
        fields.into_iter().map(|(key, _)| key.into_text().expect("a name")).collect();
    names.join(" ")
}

/// The names are part of a stored file, so they are written out here.
#[test]
fn fields_are_stored_by_name() {
    let sample = PortSample::<f32>::starting(0.5, 1.0, 2.0);
    assert_eq!(keys(&sample), "period position velocity displacement applied work");
    assert_eq!(
        keys(&AdmittanceSample::starting(0.5, 1.0)),
        "period momentum effort impulse flow work"
    );
    let correction = Correction::none(Vector2::new(1.0, 2.0));
    assert_eq!(keys(&correction), "effort observed_energy alpha shortfall accepted");
    assert_eq!(keys(&State { position: 1.0, velocity: 2.0 }), "position velocity");
    assert_eq!(
        keys(&EnergySummary::<f32>::default()),
        "ticks active rejected now least most asked absorbed shortfall largest_shortfall"
    );
}

#[test]
fn what_is_not_finite_comes_back_too() {
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 5e-324] {
        comes_back(&PortSample::starting(1e-3, odd, odd));
        comes_back(&RecordedTick { correction: Correction::none(odd), ..RecordedTick::default() });
    }
}

/// A reading and what was found in it.
#[test]
fn readings_come_back() {
    let mut readings =
        Readings::every(1e-3).expect("a period").no_faster_than(2.0).expect("a speed");
    let mut told = Vec::new();
    for position in [0.3, 0.3005, f64::NAN, 0.0, 0.301] {
        let reading = Reading { position, applied: 2.0 };
        comes_back(&reading);
        told.push(readings.read(reading));
    }
    told.iter().for_each(comes_back);
    assert!(told[0] == told[0] && told[0] != told[1]);
    let late = CheckedSample { late: !told[1].late, ..told[1] };
    assert_ne!(late, told[1]);
}

/// A port of a rigid body.
#[test]
fn screws_come_back() {
    let twist =
        Screw::<f64, BodyAxes>::new(Vector3::new(0.1, -0.2, 0.3), Vector3::new(1.0, 2.0, 3.0));
    comes_back(&twist);
    let pose = Pose::from(Isometry3::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.1, 0.2, 0.3)));
    let at: WithPose<f64, BodyAxes> = WithPose { screw: twist, pose };
    comes_back(&RecordedTick {
        sample: PortSample::starting(1e-3, at, at),
        correction: Correction::none(at),
    });
}
