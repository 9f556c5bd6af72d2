//! The rules between the values of a teleoperator.

use super::parts::Channel;
use super::teleoperator::Teleoperator;
use crate::files::scene::{Conflict, Scalar, check_single, check_ticks};

impl Teleoperator {
    /// Checks the rules between values, except those of the loop's blocks, which are checked when the loop is built.
    ///
    /// # Errors
    /// The first broken rule, with its key.
    pub(crate) fn check_rules(&self) -> Result<(), Conflict> {
        check_ticks(self.duration, self.servo_rate)?;
        self.check_start()?;
        self.check_wall()?;
        let Channel { spread, loss, seed, .. } = self.channel;
        if seed.is_none() && (spread.get() > 0 || loss.get() > 0.0) {
            return Err(Conflict::new(
                "channel.seed",
                "the channel is random, and there is no `seed` in [channel]",
                "give one, so that the run can be repeated: `seed = 1`",
            ));
        }
        if self.scalar == Scalar::F32 { check_single(self) } else { Ok(()) }
    }

    /// Checks that there is an impedance, which wave variables need and nothing else does.
    ///
    /// # Errors
    /// No impedance and no damping that it would follow from.
    pub(crate) fn check_impedance(&self) -> Result<(), Conflict> {
        if self.wave_impedance() > 0.0 {
            return Ok(());
        }
        Err(Conflict::new(
            "coordination.damping",
            "the wave variables take the damping of [coordination] as their impedance, and it is 0",
            "give `damping = 5.0` in N.s/m there, or `impedance = 5.0` in [stabilizer.wave-variables], \
             or leave the wave variables out of --stabilizers",
        ))
    }

    fn check_start(&self) -> Result<(), Conflict> {
        let stored = self.stored_at_start();
        if stored > 0.0 && stored.is_finite() {
            return Ok(());
        }
        Err(Conflict::new(
            "master.start",
            format!("the hand's spring stores {stored:?} J at this start"),
            "energies are compared with that: give a start and a stiffness whose energy is above 0 and finite, for \
             example `start = -0.01` and `hand_stiffness = 100.0`",
        ))
    }

    fn check_wall(&self) -> Result<(), Conflict> {
        let Some(wall) = self.slave.wall else { return Ok(()) };
        let (start, surface) = (self.master.start.get(), wall.position.get());
        if surface < start {
            return Err(Conflict::new(
                "slave.wall.position",
                format!("the slave starts at {start:?} m, within the wall at {surface:?} m"),
                format!("give a surface at {start:?} m or beyond"),
            ));
        }
        let (mass, rate) = (self.slave.mass.get(), self.servo_rate.get());
        let most = mass * rate * rate;
        if wall.stiffness.get() <= most {
            return Ok(());
        }
        Err(Conflict::new(
            "slave.wall.stiffness",
            "the slave bounces off this wall within a tick or two, too fast for its servo loop",
            format!("give at most mass · servo_rate² = {most:?} N/m, or a higher rate"),
        ))
    }
}
