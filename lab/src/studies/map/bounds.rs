//! Stiffness limits of the linear loop over a map.

use rayon::prelude::*;

use super::axis::Axis;
use super::grid::Grid;
use super::survey::{Reach, Survey};
use crate::files::Scene;
use crate::measure::Limits;

/// Bounds on the stiffness of the environment, where that is an axis, for values of the other axis.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// Whether the stiffness is the y axis.
    upwards: bool,
    /// The number of each sample of the other axis, its value, and the bounds there.
    samples: Vec<(usize, f64, Limits)>,
}

/// Ratio of the stiffness up to which the runs under a stabilizer stay bounded to the exact limit of the linear loop without
/// one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverExact {
    /// The ratio.
    pub ratio: f64,
    /// Whether the true ratio may be larger: the runs stay bounded up to the edge of the map.
    pub is_least: bool,
}

/// Curve of one bound along one axis over the values of the other.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) label: &'static str,
    pub(super) colour: usize,
    pub(super) is_dashed: bool,
    /// Values of x and y.
    pub(super) points: Vec<(f64, f64)>,
}

impl Bounds {
    /// Bounds over `grid`; none if no axis is the stiffness of the environment.
    pub fn of(grid: &Grid) -> Option<Self> {
        let key = format!("environment.{}.stiffness", grid.scene.environment.name());
        let upwards = match (grid.x.key == key, grid.y.key == key) {
            (true, _) => false,
            (_, true) => true,
            _ => return None,
        };
        let (which, other) = if upwards { (0, &grid.x) } else { (1, &grid.y) };
        let sample = |(number, index): (usize, u64)| {
            let value = other.value(index);
            let scene: Scene = grid.with(which, value).ok()?;
            Some((number, value, Limits::of(&scene)))
        };
        let samples = other.samples().into_par_iter().enumerate().filter_map(sample).collect();
        Some(Self { upwards, samples })
    }

    /// A curve for each bound that applies.
    pub(super) fn curves(&self) -> Vec<Curve> {
        let Some((.., first)) = self.samples.first() else { return Vec::new() };
        let names = first.named().map(|(key, words, _)| (key, words));
        let curve = |(number, (key, label)): (usize, (&'static str, &'static str))| {
            let points: Vec<(f64, f64)> = self
                .samples
                .iter()
                .map(|(_, other, limits)| {
                    let bound = limits.named()[number].2.unwrap_or(f64::NAN);
                    if self.upwards { (*other, bound) } else { (bound, *other) }
                })
                .collect();
            let applies = points.iter().any(|(x, y)| x.is_finite() && y.is_finite());
            let colour = COLOURS[number % COLOURS.len()];
            applies.then_some(Curve {
                label,
                colour,
                is_dashed: key != "exact_max_stiffness",
                points,
            })
        };
        names.into_iter().enumerate().filter_map(curve).collect()
    }

    /// Ratio of the last bounded stiffness before the first one that grows under stabilizer `index` to the exact limit of
    /// the linear loop without one: the median ratio over the values of the other axis.
    ///
    /// Where no judged cell grows the last bounded stiffness counts as the least that is possible, and where the first one
    /// grows 0. Values of the other axis that decide nothing are left out: those without a limit, those at which the first
    /// stiffness grows and the limit is no larger, and those with no cell judged. None if no value is left.
    pub fn over_exact(&self, survey: &Survey, index: usize) -> Option<OverExact> {
        let grid = survey.grid();
        let (axis, reaches): (&Axis, &[Reach]) = if self.upwards {
            (&grid.y, survey.along_y(index))
        } else {
            (&grid.x, survey.along_x(index))
        };
        let ratio = |(number, _, limits): &(usize, f64, Limits)| {
            let (Reach { end, is_broken }, exact) = (reaches[*number], limits.exact?);
            let is_least = !is_broken;
            let reached = if end == 0 { 0.0 } else { axis.value(end - 1) };
            let unknown = end == 0 && (is_least || exact <= axis.from);
            (!unknown && exact > 0.0).then(|| OverExact { ratio: reached / exact, is_least })
        };
        let mut ratios: Vec<OverExact> = self.samples.iter().filter_map(ratio).collect();
        ratios.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
        let (low, high) = (ratios.len().saturating_sub(1) / 2, ratios.len() / 2);
        let ratio = f64::midpoint(ratios.get(low)?.ratio, ratios.get(high)?.ratio);
        // A ratio that may be larger could lie beyond the middle.
        let is_least = ratios.iter().take(high + 1).any(|over| over.is_least);
        Some(OverExact { ratio, is_least })
    }
}

/// Indices of colours that stand out on the ramp of a heat map.
const COLOURS: [usize; 4] = [3, 4, 5, 1];
