//! Report on a fit.

use nalgebra::Vector4;
use serde::Serialize;

use super::device::Device;
use super::estimate::Estimate;
use super::notes::notes;
use super::recording::Recording;
use super::wall::Wall;
use crate::files::log::{BadRows, Column};
use crate::measure::Oddity;

/// Numbers of a scene as a log tells them, in SI units.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The name of the log.
    pub log: String,
    /// The columns as they were read.
    pub columns: Vec<Column>,
    /// Whether the numbers have decimal commas.
    pub decimal_commas: bool,
    /// The number of rows that the scene was fitted to.
    pub rows: usize,
    /// The bad rows, which were left out.
    pub bad_rows: BadRows,
    /// Stretches without a gap; each is predicted from a state of its own.
    pub stretches: usize,
    /// Time from the first row to the last, s.
    pub duration: f64,
    /// The median period, s.
    pub median_period: f64,
    /// The mean period without gaps, s: that of the scene.
    pub mean_period: f64,
    /// Mass of hand and device, kg.
    pub mass: Estimate,
    /// Damping of hand and device, N·s/m.
    pub damping: Estimate,
    /// Stiffness of the hand's spring, N/m.
    pub stiffness: Estimate,
    /// Where that spring is relaxed, m; none where no spring is told from 0.
    pub rest: Option<Estimate>,
    /// Constant force at the log's position nearest to 0, N: that of the spring and of a load.
    pub load: Estimate,
    /// Position in m and velocity in m/s at the start.
    pub start: [f64; 2],
    /// The wall; none where the force does not grow with a depth.
    pub wall: Option<WallReport>,
    /// The largest position, m.
    pub furthest: f64,
    /// The least position, m.
    pub nearest: f64,
    /// The step of the grid on which all positions lie, m.
    pub resolution: Option<f64>,
    /// Rows by which the recorded force acts late on the device.
    pub acts_late: usize,
    /// What the fit leaves of the positions.
    pub residual: Residual,
    /// The difference between a run of the scene and the log, root mean square, m; none where the scene does not run.
    pub replayed: Option<f64>,
    /// What the data cannot tell, and what they contradict.
    pub notes: Vec<String>,
    /// The signs of a mistake in the log.
    pub look_at: Vec<Oddity>,
}

/// What a fit leaves of the positions, root mean square, in m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Residual {
    /// Of the whole log, predicted from its first row.
    pub whole: f64,
    /// Of stretches of 32 rows, each with a state and a constant force of its own.
    pub short: f64,
    /// Whether something pushes that the log does not hold; the numbers are then those of the short stretches.
    pub is_pushed: bool,
}

/// A wall `f = max(0, K (x − x0) + B v)` for `x > x0`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WallReport {
    /// Where it stands, `x0` in m.
    pub position: Estimate,
    /// `K` in N/m.
    pub stiffness: Estimate,
    /// `B` in N·s/m.
    pub damping: Estimate,
    /// Rows in contact.
    pub rows: usize,
    /// Rows by which its force is late.
    pub late: usize,
    /// What it leaves of the force in contact, root mean square, N.
    pub residual: f64,
    /// The largest force of the log, N.
    pub peak: f64,
    /// Whether the rows with that force are clipped; they were left out then.
    pub is_clipped: bool,
}

impl WallReport {
    fn of(wall: &Wall, origin: f64) -> Option<Self> {
        let spread = wall.spread?;
        let [stiffness, damping] = [wall.at[0], wall.at[1]];
        let place = wall.position();
        let off = wall.unsure_force();
        let reach = |slope: Vector4<f64>, by: f64| {
            let variance = slope.dot(&(spread.covariance * slope)).max(0.0);
            spread.factor * (variance + (off / by).powi(2)).sqrt()
        };
        let by_place = Vector4::new(-place / stiffness, 0.0, -stiffness.recip(), 0.0);
        let of_place = reach(by_place, stiffness);
        let of_stiffness = reach(Vector4::x(), wall.travel);
        let of_damping = reach(Vector4::y(), wall.speed);
        let size = place.abs().max(wall.travel);
        Some(Self {
            position: Estimate::about(place, place, of_place, size).from(origin),
            stiffness: Estimate::about(stiffness, stiffness, of_stiffness, stiffness),
            damping: Estimate::about(damping, damping, of_damping, damping),
            rows: wall.rows,
            late: wall.lag,
            residual: wall.error,
            peak: wall.largest,
            is_clipped: wall.is_clipped,
        })
    }
}

impl Report {
    pub(super) fn of(
        name: &str,
        recording: &Recording,
        device: &Device,
        wall: Option<&Wall>,
    ) -> Self {
        let (first, last) = recording.times().unwrap_or_default();
        let origin = recording.origin;
        let [nearest, furthest] = recording.ends().map(|it| origin + it);
        let [position, velocity] = device.start();
        Self {
            log: name.to_owned(),
            columns: recording.columns.clone(),
            decimal_commas: recording.decimal_commas,
            rows: recording.rows(),
            bad_rows: recording.bad_rows.clone(),
            stretches: recording.stretches.len(),
            duration: last - first,
            median_period: recording.period,
            mean_period: recording.mean_period(),
            mass: device.mass(),
            damping: device.damping(),
            stiffness: device.stiffness(),
            rest: device.rest().map(|it| it.from(origin)),
            load: device.load(),
            start: [origin + position, velocity],
            wall: wall.and_then(|it| WallReport::of(it, origin)),
            furthest,
            nearest,
            resolution: recording.resolution(),
            acts_late: device.lag(),
            residual: Residual {
                whole: device.error,
                short: device.short_error,
                is_pushed: device.is_pushed,
            },
            replayed: None,
            notes: notes(recording, device, wall),
            look_at: recording.look_at.clone(),
        }
    }

    /// Rows by which the loop is late in all.
    pub(super) fn delay(&self) -> usize {
        self.acts_late + self.wall.map_or(0, |wall| wall.late)
    }
}
