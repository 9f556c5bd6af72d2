//! The document `map.json`.

use lyapunov::Scalar;
use serde::Serialize;

use super::axis::{Axis, Spacing};
use super::bounds::Bounds;
use super::method::Method;
use super::run::Run;
use super::survey::Survey;
use super::workload::Workload;
use crate::measure::{Oddity, Verdict};
use crate::show::json;
use crate::simulate::F64x8;
use crate::simulate::family::{Judgement, StabilizerName};

/// Method and cost of a map's computation.
#[derive(Clone, Debug, Serialize)]
pub struct Computation {
    /// Its cost.
    #[serde(flatten)]
    pub workload: Workload,
    /// The number of threads.
    pub threads: usize,
    /// Cells that run side by side in one vector; 1: one by one.
    pub lanes: usize,
    /// `lanes`, or `single` for a scene that lanes do not have: in `f32`, or with an adaptive integrator.
    pub method: &'static str,
    /// The vector instructions of the lanes; null without lanes.
    pub instructions: Option<&'static str>,
}

impl Computation {
    /// Computation of `run`, which took `workload`.
    pub fn of(run: &Run<'_>, workload: Workload) -> Self {
        let (lanes, method, instructions) = match run.method() {
            Method::Kernel(kernel) => (kernel.lanes(), "lanes", Some(kernel.instructions().name())),
            Method::Lanes(instructions) => (F64x8::LANES, "lanes", Some(instructions.name())),
            Method::Single => (1, "single", None),
        };
        Self { workload, threads: run.threads(), lanes, method, instructions }
    }
}

#[derive(Serialize)]
struct Document<'a> {
    /// The keys that come from a clock or depend on the machine.
    not_deterministic: [&'static str; 5],
    x: Along<'a>,
    y: Along<'a>,
    /// Cells that are judged by speed, for want of an equilibrium.
    cells_by_speed: u64,
    #[serde(flatten)]
    computation: Option<&'a Computation>,
    areas: Vec<Line>,
    look_at: Vec<Oddity>,
}

/// An axis.
#[derive(Serialize)]
pub(super) struct Along<'a> {
    key: &'a str,
    from: f64,
    to: f64,
    count: u64,
    spacing: &'static str,
}

#[derive(Serialize)]
struct Line {
    stabilizer: &'static str,
    settles_cells: u64,
    swinging_cells: u64,
    grows_cells: u64,
    too_short_cells: u64,
    judged_cells: u64,
    /// None where no cell was judged.
    settles_share: Option<f64>,
    settles_area: Option<f64>,
    /// Of the cells that settle or swing.
    bounded_share: Option<f64>,
    bounded_area: Option<f64>,
    /// None where the stiffness is no axis, or no value of the other axis decides it.
    bounded_stiffness_over_exact: Option<f64>,
    /// Whether that is only a lower bound.
    bounded_stiffness_over_exact_is_least: bool,
    /// Place in the table, from 1.
    rank: usize,
    rendered_percent: Option<f64>,
    force_felt_percent: Option<f64>,
    stiffness_felt_percent: Option<f64>,
    energy_given_mj: Option<f64>,
    energy_given_beyond_damper_mj: Option<f64>,
    broken_cells: Option<u64>,
    judged_by: Judgement,
}

/// An axis as JSON.
pub(super) fn along(axis: &Axis) -> Along<'_> {
    let spacing = match axis.spacing {
        Spacing::Linear => "linear",
        Spacing::Logarithmic => "log",
    };
    Along { key: &axis.key, from: axis.from, to: axis.to, count: axis.count, spacing }
}

/// The map as JSON; docs/map.md explains its keys.
pub fn document(
    survey: &Survey,
    bounds: Option<&Bounds>,
    computation: Option<&Computation>,
) -> String {
    let (grid, ranking) = (survey.grid(), survey.ranking());
    let line = |(index, member): (usize, &StabilizerName)| {
        let (settling, bounded) = (survey.settling(index), survey.bounded(index));
        let over = bounds.and_then(|bounds| bounds.over_exact(survey, index));
        let rendered = survey.rendered(index);
        let above = ranking.iter().take_while(|ranked| **ranked != index);
        Line {
            stabilizer: member.name(),
            settles_cells: settling.cells,
            swinging_cells: survey.cells(index, Verdict::Swinging),
            grows_cells: survey.cells(index, Verdict::Grows),
            too_short_cells: survey.cells(index, Verdict::TooShort),
            judged_cells: survey.judged(index),
            settles_share: settling.share,
            settles_area: settling.area,
            bounded_share: bounded.share,
            bounded_area: bounded.area,
            bounded_stiffness_over_exact: over.map(|over| over.ratio),
            bounded_stiffness_over_exact_is_least: over.is_some_and(|over| over.is_least),
            rank: above.count() + 1,
            rendered_percent: rendered.percent,
            force_felt_percent: rendered.force_felt,
            stiffness_felt_percent: rendered.stiffness_felt,
            energy_given_mj: rendered.energy_given,
            energy_given_beyond_damper_mj: rendered.energy_given_beyond_damper,
            broken_cells: rendered.broke,
            judged_by: member.judgement(),
        }
    };
    let document = Document {
        not_deterministic: [
            "kernel_seconds",
            "measures_seconds",
            "threads",
            "lanes",
            "instructions",
        ],
        x: along(&grid.x),
        y: along(&grid.y),
        cells_by_speed: survey.by_speed(),
        computation,
        areas: grid.stabilizers.iter().enumerate().map(line).collect(),
        look_at: survey.look_at().into_iter().collect(),
    };
    json::text(&document)
}
