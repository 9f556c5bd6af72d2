//! Snapshots of ports with memory, and of what stands beside a loop, bit for bit.

use serde::{Serialize, de::DeserializeOwned};

use lyapunov::{
    Correction, OnePort, PortSample, Signal, Snapshot, Stabilizer,
    effects::{Fallback, OnePortExt},
    environments::{MovingWall, Spring, VaryingSpring, Wall},
    laws::Samples,
    poses::{Pose, PoseTrack},
    stabilizers::{Account, CoupledPort, InputToState, VirtualCoupling},
    telemetry::EnergyMeter,
};
use nalgebra::{Isometry3, Vector2, Vector3};

use crate::snapshots::goes_on;
use crate::support::{PERIOD, loaded, popc, read, stored, written};

/// A port in the place of a stabilizer: what it answers, and what it tells of its correction.
#[derive(Clone)]
struct Answering<P>(P);

impl<V: Signal, P: OnePort<V>> Stabilizer<V> for Answering<P> {
    fn stabilize(&mut self, sample: &PortSample<V>, _effort: V) -> Correction<V> {
        let effort = self.0.respond(sample);
        Correction { effort, ..self.0.correction() }
    }
}

impl<P: Snapshot> Snapshot for Answering<P> {
    type State = P::State;

    fn state(&self) -> P::State {
        self.0.state()
    }

    fn restored(self, state: P::State) -> Result<Self, lyapunov::ParameterError> {
        Ok(Self(self.0.restored(state)?))
    }
}

fn port<V, P>(port: P)
where
    V: Signal,
    P: OnePort<V> + Snapshot<State: Serialize + DeserializeOwned> + Clone,
{
    goes_on::<V, _>(Answering(port));
}

fn wall() -> Wall<f64> {
    Wall::new(8000.0, 2.0).expect("a wall")
}

#[test]
fn environments() {
    port::<f64, _>(wall());
    port::<f64, _>(MovingWall::new(wall(), 1e-3, 7.0, 1000.0).expect("one"));
    let body = lyapunov::bodies::Impedance { mass: 0.3, damping: 1.0, stiffness: 50.0 };
    port::<f64, _>(lyapunov::environments::MassSpringDamper::new(body).expect("one"));
    let spring = Spring::new(500.0).expect("one");
    port::<f64, _>(VaryingSpring::new(spring, 100.0, 7.0, 1000.0).expect("one"));
    let spring: Spring<Vector2<f64>> = Spring::new(500.0).expect("one");
    port::<Vector2<f64>, _>(spring);
}

#[test]
fn effects() {
    port::<f64, _>(wall().differenced());
    port::<f64, _>(wall().low_passed(40.0).expect("one"));
    port::<f64, _>(wall().saturated(5.0).expect("one"));
    port::<f64, _>(wall().scaled(0.5).expect("one"));
    port::<f64, _>(wall().encoded(1e-4).expect("one"));
    port::<f64, _>(wall().guarded(Fallback::Hold));
    port::<f64, _>(wall().noisy(1e-4, |_| 7).expect("one"));
    port::<f64, _>(wall().dropped(0.3, Fallback::Hold, |_| 7).expect("one"));
}

/// Guards keep bad samples from what holds and delays, so that their memory is finite and has a text.
#[test]
fn holds_and_delays() {
    port::<f64, _>(wall().held(3).expect("one").guarded(Fallback::Hold));
    port::<f64, _>(wall().delayed::<4>(3).expect("one").guarded(Fallback::Zero));
    let whole = wall().held(2).expect("one").stabilized(popc::<f64>());
    port::<f64, _>(whole.saturated(5.0).expect("one").guarded(Fallback::Hold).differenced());
}

#[test]
fn ports_around_an_environment() {
    let coupling = VirtualCoupling { stiffness: 2000.0, damping: 3.0, drag: 0.5 };
    port::<f64, _>(CoupledPort::new(wall(), coupling).expect("one"));
    port::<f64, _>(InputToState::new(wall(), 1e4, 0.1).expect("one"));
    port::<f64, _>(InputToState::adaptive(wall(), 1.5, 0.1).expect("one"));
}

#[test]
fn counters_out_of_range_are_refused() {
    let held = wall().held(3).expect("one");
    let ((), _, missed, effort): (_, _, _, f64) = held.state();
    assert!(held.restored(((), 2, missed, effort)).is_ok());
    assert!(held.restored(((), 3, missed, effort)).is_err());
    let delayed = OnePortExt::<f64>::delayed::<4>(wall(), 3).expect("one");
    let ((), _, waiting) = delayed.state();
    assert!(
        delayed.restored(((), 2, waiting)).is_ok() && delayed.restored(((), 3, waiting)).is_err()
    );
}

/// Any stored count goes on with the next call, from 0.
#[test]
fn the_largest_count_goes_on() {
    let rest = PortSample::starting(PERIOD, -1.0, 0.0);
    let moving = || MovingWall::new(wall(), 1e-3, 7.0, 1000.0).expect("one");
    let varying = || {
        VaryingSpring::<f64>::new(Spring::new(500.0).expect("one"), 100.0, 7.0, 1e3).expect("one")
    };
    let (mut wall, mut spring) =
        (moving().restored(u64::MAX).expect("one"), varying().restored(u64::MAX).expect("one"));
    let (mut fresh_wall, mut fresh_spring) = (moving(), varying());
    wall.respond(&rest);
    spring.respond(&rest);
    assert_eq!((wall.state(), spring.state()), (0, 0));
    assert_eq!(wall.respond(&rest), fresh_wall.respond(&rest));
    assert_eq!(spring.respond(&rest), fresh_spring.respond(&rest));

    let told = Correction { observed_energy: -1.0, ..Correction::none(0.0) };
    let mut meter = EnergyMeter::<f64>::new();
    meter.add(&rest, &told);
    let (_, sums, last) = meter.state();
    let mut meter = meter.restored((u64::MAX, sums, last)).expect("a meter");
    for _ in 0..2 {
        meter.add(&rest, &Correction::none(0.0));
    }
    assert_eq!((meter.summary().ticks, meter.summary().least), (1, 0.0));
}

/// A meter and a track of poses go on as if nothing had been.
#[test]
fn meters_and_tracks() {
    let (mut popc, mut meter) = (popc::<f32>(), EnergyMeter::<f32>::new());
    let mut track = PoseTrack::<f64>::from(Pose::at(Vector3::new(f64::NAN, 0.0, 0.0)));
    let mut resumed = None;
    for (tick, (sample, effort)) in Samples::<f32>::new(PERIOD as f32).enumerate() {
        let correction = popc.stabilize(&sample, effort);
        if tick == 777 {
            let again: (u64, [(f32, f32); 4], [f32; 5]) = read(&written(&meter.state()));
            let meter = EnergyMeter::new().restored(again).expect("a state");
            let again = loaded(&stored(&track.state()));
            let fresh = PoseTrack::<f64>::from(Pose::at(Vector3::zeros()));
            resumed = Some((meter, fresh.restored(again).expect("a state")));
        }
        let turned = Vector3::new(0.3, 0.2, 0.1) * (tick as f64 * 0.01);
        let pose = Pose::from(Isometry3::rotation(turned));
        let now = track.tell(&pose);
        meter.add(&sample, &correction);
        if let Some((meter_again, track_again)) = &mut resumed {
            meter_again.add(&sample, &correction);
            assert_eq!(*meter_again, meter);
            assert_eq!(track_again.tell(&pose), now);
        }
    }
    assert!(resumed.is_some());
}

/// A stabilizer inside the adaptors of a loop is changed where it stands: each lends the next.
#[test]
fn a_stabilizer_behind_adaptors_is_reached() {
    let mut chain = wall()
        .stabilized(popc())
        .saturated(5.0)
        .and_then(|port| port.delayed::<4>(1))
        .and_then(|port| port.encoded(1e-5))
        .and_then(|port| port.low_passed(30.0))
        .expect("a chain");
    chain.port_mut().port_mut().port_mut().port_mut().stabilizer_mut().owe(0.25).expect("a debt");
    let inside = chain.port().port().port().port().stabilizer();
    assert_eq!(inside.observed_energy(), -0.25);
}
