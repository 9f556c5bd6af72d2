//! What one tick came to.

use crate::Scene;

/// One servo tick, in SI units: the columns of `lyapunov run --csv`, along the first axis where there are several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Time, s.
    pub t: f64,
    /// The plant's true position, m.
    pub x: f64,
    /// The position as measured, m.
    pub x_measured: f64,
    /// The velocity as estimated, m/s.
    pub v: f64,
    /// The environment's force, N.
    pub f_env: f64,
    /// The controller's force, N.
    pub f_ctl: f64,
    /// The force commanded, after saturation, N.
    pub f_out: f64,
    /// The force on the plant until the next tick, after delay, N.
    pub f_act: f64,
    /// The observer sum before this tick's correction, J.
    pub observer: f64,
    /// The damping injected, N·s/m.
    pub alpha: f64,
    /// The debt that this tick's correction cannot serve, J.
    pub shortfall: f64,
    /// Whether the stabilizer accepted the sample.
    pub accepted: bool,
}

impl Row {
    /// The numbers of the row, in the order of the columns, without the last.
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
            self.observer,
            self.alpha,
            self.shortfall,
        ]
    }

    pub(crate) fn in_range(&self) -> bool {
        self.accepted && self.numbers().iter().all(|number| number.is_finite())
    }
}

/// What is told of each further axis, in this order.
pub(crate) const FURTHER: [&str; 7] =
    ["", "_measured", "_v", "_f_env", "_f_ctl", "_f_out", "_f_act"];

/// The names of the columns that a scene has beside those of [`Row`]: the further axes of a space, and the operator's
/// motion where a link sets it apart from the device's.
pub fn further_columns(scene: &Scene) -> Vec<String> {
    let axes = ["x", "y", "z"];
    let dimensions = scene.dimensions();
    let mut columns = Vec::new();
    for axis in &axes[1..dimensions] {
        columns.extend(FURTHER.map(|name| format!("{axis}{name}")));
    }
    if scene.link.is_some() {
        for axis in &axes[..dimensions] {
            columns.push(format!("{axis}_operator"));
            columns.push(format!("{axis}_v_operator"));
        }
    }
    columns
}
