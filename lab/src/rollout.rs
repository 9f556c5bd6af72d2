//! The closed loop of a scene, tick by tick.

use lyapunov::{OnePort, ParameterError, Plant, PortSample, Scalar, Signal, Stabilizer};

use crate::building::Seen;
use crate::family::Member;
use crate::scene::Scene;
use crate::{AnyStabilizer, Assembly, Row, Space, Tick};

/// The ticks of a scene, from tick 0 to the last, computed as they are asked for.
///
/// Ends early, after the last tick on which everything is finite, if the motion leaves the range of the scalar.
#[derive(Debug)]
pub struct Rollout<V: Signal = f64> {
    rate: f64,
    number: u64,
    last: u64,
    assembly: Assembly<V>,
    seen: Seen<V>,
    truth: PortSample<V>,
}

impl<V: Space> Rollout<V> {
    /// The loop of `scene` with the stabilizer it names, in the scalar of `V` whatever the scene says of it.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or together with others.
    pub fn of(scene: &Scene) -> Result<Self, ParameterError> {
        Self::assemble(scene, AnyStabilizer::of(scene)?)
    }

    /// The loop of `scene` with `stabilizer` in the place of the scene's own.
    ///
    /// # Errors
    /// As [`Rollout::of`].
    pub fn stabilized_by(
        scene: &Scene,
        stabilizer: impl Stabilizer<V> + 'static,
    ) -> Result<Self, ParameterError> {
        Self::assemble(scene, AnyStabilizer::new(stabilizer))
    }

    /// The loop of `scene` under `member` of the family, whatever the scene names.
    ///
    /// # Errors
    /// As [`Rollout::of`].
    pub fn under(scene: &Scene, member: Member) -> Result<Self, ParameterError>
    where
        V: Scalar,
    {
        Self::assemble(scene, member.on(scene)?)
    }

    /// The ticks as rows: the first axis of each.
    pub fn rows(self) -> impl Iterator<Item = Row> {
        self.map(|tick| Row::of(&tick))
    }

    /// The loop of `scene` with `stabilizer`, which has a box already.
    pub(crate) fn assemble(
        scene: &Scene,
        stabilizer: AnyStabilizer<V>,
    ) -> Result<Self, ParameterError> {
        let seen = Seen::default();
        let assembly = Assembly::watched(scene, &seen, stabilizer)?;
        let (rate, last, truth) = (scene.servo_rate.get(), scene.ticks(), assembly.plant.start());
        Ok(Self { rate, number: 0, last, assembly, seen, truth })
    }

    /// The next tick, whether or not it is in range, and whether or not the scene is over.
    pub(crate) fn tick(&mut self) -> Tick<V> {
        let truth = self.truth;
        let applied = self.assembly.port.respond(&truth);
        let tick = self.seen.tick(self.number as f64 / self.rate, truth, applied);
        self.assembly.plant.advance_into(applied, &mut self.truth);
        self.number += 1;
        tick
    }
}

impl<V: Space> Iterator for Rollout<V> {
    type Item = Tick<V>;

    fn next(&mut self) -> Option<Tick<V>> {
        if self.number > self.last {
            return None;
        }
        let tick = self.tick();
        if tick.in_range() {
            return Some(tick);
        }
        self.number = u64::MAX;
        None
    }
}
