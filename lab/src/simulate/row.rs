//! One tick as a row of a table.

use lyapunov::{Mask, Scalar};

use super::building::Space;
use super::tick::Tick;
use crate::files::Scene;

/// One servo tick, in SI units: the columns of `lyapunov run --csv`, along the first axis where there are several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Time, s.
    pub t: f64,
    /// The plant's true position, m.
    pub x: f64,
    /// The measured position, m.
    pub x_measured: f64,
    /// The estimated velocity, m/s.
    pub v: f64,
    /// The environment's force, N.
    pub f_env: f64,
    /// The controller's force, what the stabilizer adds to the environment's, N.
    pub f_ctl: f64,
    /// The commanded force, after saturation, N.
    pub f_out: f64,
    /// The force applied to the plant until the next tick, after delay, N.
    pub f_act: f64,
    /// The observed energy before this tick's correction, J.
    pub observed_energy: f64,
    /// The injected damping, N·s/m.
    pub alpha: f64,
    /// The debt that this tick's correction cannot serve, J.
    pub shortfall: f64,
    /// Whether the stabilizer accepted the sample.
    pub accepted: bool,
}

impl Row {
    /// The row of `tick` along the first axis, in the first lane.
    #[inline]
    pub fn of<V: Space>(tick: &Tick<V>) -> Self {
        let [x, x_measured, v, f_env, f_ctl, f_out, f_act] = along(tick, 0);
        Self {
            t: tick.time,
            x,
            x_measured,
            v,
            f_env,
            f_ctl,
            f_out,
            f_act,
            observed_energy: tick.correction.observed_energy.lane(0),
            alpha: tick.correction.alpha.lane(0),
            shortfall: tick.correction.shortfall.lane(0),
            accepted: Mask::all(tick.correction.accepted),
        }
    }

    /// The numbers of the row in the order of the columns, without the last.
    #[inline]
    pub(crate) fn numbers(&self) -> [f64; 11] {
        [
            self.t,
            self.x,
            self.x_measured,
            self.v,
            self.f_env,
            self.f_ctl,
            self.f_out,
            self.f_act,
            self.observed_energy,
            self.alpha,
            self.shortfall,
        ]
    }
}

/// The numbers of `tick` in the columns of its scene's rows; 1 where it is accepted, else 0.
pub fn row_numbers<V: Space>(tick: &Tick<V>) -> impl Iterator<Item = f64> {
    let row = Row::of(tick);
    let accepted = f64::from(u8::from(row.accepted));
    row.numbers().into_iter().chain([accepted]).chain(further_numbers(tick))
}

/// Column suffixes of each axis, in the order of [`along`].
const AXIS: [&str; 7] = ["", "_measured", "_v", "_f_env", "_f_ctl", "_f_out", "_f_act"];

/// Names of the columns that a scene has beside those of [`Row`]: the further axes of a space, and the operator's
/// motion where a link sets it apart from the device's.
pub(crate) fn further_columns(scene: &Scene) -> Vec<String> {
    let axes = ["x", "y", "z"];
    let dimensions = scene.dimensions();
    let mut columns = Vec::new();
    for axis in &axes[1..dimensions] {
        columns.extend(AXIS.map(|name| format!("{axis}{name}")));
    }
    if scene.link.is_some() {
        for axis in &axes[..dimensions] {
            columns.push(format!("{axis}_operator"));
            columns.push(format!("{axis}_v_operator"));
        }
    }
    columns
}

/// The numbers of `tick` in those columns.
pub(crate) fn further_numbers<V: Space>(tick: &Tick<V>) -> impl Iterator<Item = f64> {
    let axes = (1..V::DIMENSIONS).flat_map(|axis| along(tick, axis));
    let operator = tick.operator.into_iter().flat_map(|operator| {
        (0..V::DIMENSIONS)
            .flat_map(move |axis| [operator.position.axis(axis), operator.velocity.axis(axis)])
    });
    axes.chain(operator)
}

#[inline]
fn along<V: Space>(tick: &Tick<V>, axis: usize) -> [f64; 7] {
    [
        tick.truth.position.axis(axis),
        tick.measured.position.axis(axis),
        tick.measured.velocity.axis(axis),
        tick.environment.axis(axis),
        tick.added().axis(axis),
        tick.command.axis(axis),
        tick.applied.axis(axis),
    ]
}
