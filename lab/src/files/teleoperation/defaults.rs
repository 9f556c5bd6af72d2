//! Values that follow from a teleoperator: the defaults of its stabilizers, and the rest of an ideal link.

use super::teleoperator::Teleoperator;
use crate::files::scene::{NonNegative, Positive, Share};

/// The share of a tank that is sent on a tick, as in a public course.
const SHARE: f64 = 0.1;

/// The time constant of the wave filter, as a part of the longest way there and back.
const FILTERED: f64 = 0.1;

/// Settings of the two-layer architecture with every default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layers {
    /// Energy up to which the master's damper fills its tank, J.
    pub level: f64,
    /// Damping at the master for each joule that its tank lacks, N·s/(m J).
    pub gain: f64,
    /// Share of its tank that each end sends on a tick.
    pub share: f64,
}

impl Teleoperator {
    /// The energy stored in the hand's spring at the start, J: all the energy of the system.
    pub fn stored_at_start(&self) -> f64 {
        let start = self.master.start.get();
        0.5 * self.master.hand_stiffness.get() * start * start
    }

    /// The longest that a signal takes there and back, s: a force returns one tick later than the channel says.
    pub fn round_trip(&self) -> f64 {
        let longest = u32::from(self.channel.delay.get()) + u32::from(self.channel.spread.get());
        f64::from(2 * longest + 1) / self.servo_rate.get()
    }

    /// The force at which hand, coordination and wall rest in series, N, without anything between them: that of an
    /// ideal link. 0 where the hand rests before the wall.
    pub fn ideal_force(&self) -> f64 {
        let Some(wall) = self.slave.wall else { return 0.0 };
        let springs = [self.master.hand_stiffness, self.coordination.stiffness, wall.stiffness];
        let yields: f64 = springs.iter().map(|spring| spring.get().recip()).sum();
        (-wall.position.get()).max(0.0) / yields
    }

    /// The impedance of the wave variables, or its default, N·s/m.
    pub fn wave_impedance(&self) -> f64 {
        let given = self.stabilizer.wave_variables.impedance;
        given.map_or(self.coordination.damping.get(), Positive::get)
    }

    /// The time constant of the wave filter, or its default, s.
    pub fn wave_filter_time(&self) -> f64 {
        let given = self.stabilizer.wave_variables.filter_time;
        given.map_or_else(|| FILTERED * self.round_trip(), NonNegative::get)
    }

    /// The settings of the two-layer architecture, or their defaults.
    ///
    /// A spring `K` that acts late by `t` feeds a slow motion like a damping of `−K t`: that and the coordination's own
    /// damper are what the master's has to dissipate.
    pub fn layers(&self) -> Layers {
        let given = self.stabilizer.two_layer;
        let level = given.level.map_or_else(|| self.stored_at_start(), Positive::get);
        let gain = given.gain.map_or_else(
            || {
                let (stiffness, damping) = (self.coordination.stiffness, self.coordination.damping);
                let needed = damping.get() + stiffness.get() * self.round_trip();
                let cap = self.stabilizer.damping_cap.get();
                let most = cap * self.master.mass.get() * self.servo_rate.get();
                needed.min(most) / level
            },
            NonNegative::get,
        );
        Layers { level, gain, share: given.share.map_or(SHARE, Share::get) }
    }
}
