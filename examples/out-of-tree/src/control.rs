//! The loop of a six-axis device, whoever stabilizes it.

use lyapunov::{
    ParameterError, Popc,
    poses::{Pose, PoseTrack, Screw, WithPose},
    prelude::*,
    stabilizers::{AxisWeights, BodyInertia, DirectedDamping, Member, NoStabilizer, PartLimits},
    stabilizers::{Watchdog, WatchdogTimes},
    telemetry::{EnergyMeter, TickRing},
};

use crate::{DryFriction, WhileGiving};

const PERIOD: f32 = 1e-3; // s
const LEAST: BodyInertia<f32> = BodyInertia { mass: 0.4, moment: 2e-4 }; // kg, kg·m²
const FASTEST: f32 = 20.0; // m/s, rad/s: no hand moves faster, so such a reading is wrong
const WALL: f32 = 4000.0; // N/m
const FRICTION: f32 = 0.02; // N and N·m: less than the device has

/// Signal at the port: twists and wrenches, with the pose beside them.
pub type Port = WithPose<f32>;

/// The own stabilizer with one sum, and a limit for each part.
pub type Own = DirectedDamping<WhileGiving<f32, DryFriction<f32>>, AxisWeights<Port>, f32>;

/// A loop on the own stabilizer and the own candidate.
pub fn own(start: Pose<f32>) -> Result<Control<Own>, ParameterError> {
    let law = WhileGiving::new(DryFriction::of(FRICTION)?, DampingLimit::at(f32::INFINITY)?);
    Control::on(DirectedDamping::within(law, limits(PERIOD)?), start)
}

/// A loop on one that ships, chosen while the program runs: one type, and no allocator.
pub fn shipped(name: &str, start: Pose<f32>) -> Result<Control<Member<Port>>, ParameterError> {
    let popc = Popc::new(PortEnergy, limits(PERIOD)?.rotation); // the smaller one, for all axes
    let member =
        if name == "popc" { Member::Popc(popc) } else { Member::NoStabilizer(NoStabilizer) };
    Control::on(member, start)
}

fn limits(period: f32) -> Result<PartLimits<f32>, ParameterError> {
    PartLimits::of_body(0.5, LEAST, period)
}

/// The loop, with all that it remembers.
pub struct Control<S> {
    track: PoseTrack<f32>,
    readings: Readings<Port>,
    /// What stabilizes it, to be read, changed, stored and restored between ticks.
    pub stabilizer: Watchdog<S, Port>,
    /// The last ticks; `log.csv()` is what `observe` reads.
    pub log: TickRing<Port, 64>,
    /// The energies at the port since the start.
    pub energies: EnergyMeter<f32>,
}

impl<S: Stabilizer<Port> + StabilizerExt> Control<S> {
    fn on(stabilizer: S, start: Pose<f32>) -> Result<Self, ParameterError> {
        let times = WatchdogTimes { hold: 5.0 * PERIOD, rise: 0.1 };
        Ok(Self {
            track: PoseTrack::from(start),
            readings: Readings::every(PERIOD)?.no_faster_than(FASTEST)?,
            stabilizer: stabilizer.watched(times)?,
            log: TickRing::new(),
            energies: EnergyMeter::new(),
        })
    }

    /// One tick: the pose, if it could be read, and the wrench that acted since the last; commands one.
    pub fn tick(&mut self, pose: Option<Pose<f32>>, applied: Screw<f32>) -> Screw<f32> {
        let applied = WithPose::of(applied);
        let checked = match pose {
            Some(pose) => self.readings.read(Reading { position: self.track.tell(&pose), applied }),
            None => self.readings.missed(applied),
        };
        let correction = self.stabilizer.stabilize(&checked.sample, wall(&checked.sample));
        self.log.push(&checked.sample, &correction);
        self.energies.add(&checked.sample, &correction);
        correction.effort.screw
    }
}

impl Control<Own> {
    /// Changes the period between ticks, and the limits with it.
    pub fn set_period(&mut self, period: f32) -> Result<(), ParameterError> {
        let law = *self.stabilizer.stabilizer().stabilizer();
        self.readings.set_period(period)?;
        *self.stabilizer.stabilizer_mut() = DirectedDamping::within(law, limits(period)?);
        Ok(())
    }
}

/// The own controller: a wall below `z = 0`. Efforts resist motion, so it is negative in there.
fn wall(sample: &PortSample<Port>) -> Port {
    let mut wrench = Screw::default();
    wrench.translation.z = WALL * sample.position.pose.position.z.min(0.0);
    WithPose::of(wrench)
}
