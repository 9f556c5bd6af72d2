//! The closed loop of a scene, tick by tick.

use lyapunov::{Drive, Mask, OnePort, ParameterError, Plant, Scalar, Signal, Stabilizer};

use crate::building::Seen;
use crate::family::{Contender, Member};
use crate::scene::Scene;
use crate::{AnyStabilizer, Assembly, Row, Space};

/// The rows of a scene, from tick 0 to the last, computed as they are asked for.
///
/// Ends early, after the last tick on which everything is finite, if the motion leaves the range of the scalar.
#[derive(Debug)]
pub struct Rollout<V: Signal = f64> {
    rate: f64,
    tick: u64,
    last: u64,
    assembly: Assembly<V>,
    seen: Seen<V>,
    drive: Drive<V>,
    further: Vec<f64>,
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
        Self::assemble(scene, Some(AnyStabilizer::new(stabilizer)))
    }

    /// The loop of `scene` under `member` of the family, whatever the scene names.
    ///
    /// # Errors
    /// As [`Rollout::of`].
    pub fn under(scene: &Scene, member: Member) -> Result<Self, ParameterError>
    where
        V: Scalar,
    {
        let nobody = member == Member::Plain(Contender::Nobody);
        let stabilizer = if nobody { None } else { Some(member.on(scene)?) };
        Self::assemble(scene, stabilizer)
    }

    /// What the plant tells of the coming tick, before anything measures it.
    pub(crate) fn drive(&self) -> &Drive<V> {
        &self.drive
    }

    /// What stood before the stabilizer on the last tick: the drive as measured, and the environment's effort.
    pub(crate) fn seen(&self) -> Option<(Drive<V>, V)> {
        self.seen.environment.get()
    }

    /// The further numbers of the last row, as [`further_columns`](crate::further_columns) names them.
    pub fn further(&self) -> &[f64] {
        &self.further
    }

    fn assemble(
        scene: &Scene,
        stabilizer: Option<AnyStabilizer<V>>,
    ) -> Result<Self, ParameterError> {
        let seen = Seen::default();
        let assembly = Assembly::watched(scene, &seen, stabilizer)?;
        let (rate, last, drive) = (scene.servo_rate.get(), scene.ticks(), assembly.plant.start());
        Ok(Self { rate, tick: 0, last, assembly, seen, drive, further: Vec::new() })
    }

    fn row(&mut self) -> Option<Row> {
        let acted = self.assembly.port.respond(&self.drive);
        let action = self.assembly.port.action();
        let (measured, environment) = self.seen.environment.get()?;
        let (_, command) = self.seen.command.get()?;
        let control = measured.velocity.scale(action.alpha);
        let signals = [
            self.drive.position,
            measured.position,
            measured.velocity,
            environment,
            control,
            command,
            acted,
        ];
        let [x, x_measured, v, f_env, f_ctl, f_out, f_act] = signals.map(|signal| signal.axis(0));
        let row = Row {
            t: self.tick as f64 / self.rate,
            x,
            x_measured,
            v,
            f_env,
            f_ctl,
            f_out,
            f_act,
            observer: action.sum.lane(0),
            alpha: action.alpha.lane(0),
            shortfall: action.shortfall.lane(0),
            accepted: Mask::all(action.accepted),
        };
        self.further.clear();
        for axis in 1..V::DIMENSIONS {
            self.further.extend(signals.map(|signal| signal.axis(axis)));
        }
        self.further.extend(self.seen.operator());
        self.assembly.plant.advance_into(acted, &mut self.drive);
        let in_range = row.in_range() && self.further.iter().all(|number| number.is_finite());
        in_range.then_some(row)
    }
}

impl<V: Space> Iterator for Rollout<V> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        if self.tick > self.last {
            return None;
        }
        let row = self.row();
        self.tick = if row.is_some() { self.tick + 1 } else { u64::MAX };
        row
    }
}
