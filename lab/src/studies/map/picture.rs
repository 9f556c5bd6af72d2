//! Heat maps of a map.

use super::axis::{Axis, Spacing};
use super::bounds::{Bounds, Curve};
use super::outcome::Measure;
use super::survey::Survey;
use crate::files::scene::unit;
use lyapunov_figures::{Figure, HeatMap, Numbering, Panel, Series};

/// Width of a panel, in pixels of the drawing.
const WIDTH: f64 = 560.0;

const HEIGHT: f64 = 330.0;

/// A heat map with the name of its files and its caption.
#[derive(Debug)]
pub struct NamedFigure {
    /// The name of its files, without an ending.
    pub name: &'static str,
    /// The caption.
    pub words: &'static str,
    /// The map, a panel for each stabilizer.
    pub figure: Figure,
}

/// One figure for the verdicts and one for each measure, a panel for each stabilizer.
pub fn figures(survey: &Survey, bounds: Option<&Bounds>) -> Vec<NamedFigure> {
    let curves = bounds.map_or_else(Vec::new, Bounds::curves);
    let stable =
        figure(survey, "stable: dark, unstable: light, not judged: empty", &curves, |index| {
            Some((survey.stable(index), Some((0.0, 1.0))))
        });
    let mut drawn = vec![NamedFigure { name: "stable", words: STABLE, figure: stable }];
    for (number, measure) in Measure::ALL.iter().enumerate() {
        let range = range(survey, number);
        let of = |index| Some((survey.mean(index, number), range));
        let name = measure.key.rsplit_once('_').map_or(measure.key, |(name, _unit)| name);
        let figure = figure(survey, measure.words, &curves, of);
        drawn.push(NamedFigure { name, words: measure.words, figure });
    }
    drawn
}

const STABLE: &str =
    "Dark where the loop is stable, light where it is not, empty where nothing was judged";

/// Range of a measure over all stabilizers, so that one colour means the same in every panel.
fn range(survey: &Survey, measure: usize) -> Option<(f64, f64)> {
    let all = (0..survey.grid().stabilizers.len()).flat_map(|index| survey.mean(index, measure));
    let finite = all.filter(|value| value.is_finite());
    finite.fold(None, |range, value| match range {
        None => Some((value, value)),
        Some((low, high)) => Some((f64::min(low, value), f64::max(high, value))),
    })
}

type Field = (Vec<f64>, Option<(f64, f64)>);

fn figure(
    survey: &Survey,
    words: &str,
    curves: &[Curve],
    of: impl Fn(usize) -> Option<Field>,
) -> Figure {
    let grid = survey.grid();
    let columns = if grid.stabilizers.len() > 1 { 2 } else { 1 };
    let mut figure = Figure::new(words)
        .with_width(WIDTH * columns as f64)
        .with_columns(columns)
        .with_panel_height(HEIGHT);
    for (index, member) in grid.stabilizers.iter().enumerate() {
        let Some((values, colours)) = of(index) else { continue };
        let (x, y) = (Shown::of(&grid.x), Shown::of(&grid.y));
        let heat = HeatMap { range: colours, ..HeatMap::new(survey.size().0, values) };
        let mut panel = Panel::new(member.name(), label(&grid.x), label(&grid.y))
            .with_heat(heat)
            .with_numbers(x.numbering, y.numbering)
            .with_x_range(x.range.0, x.range.1)
            .with_y_range(y.range.0, y.range.1);
        for curve in curves {
            let points = curve.points.iter().map(|&(a, b)| (x.place(a), y.place(b))).collect();
            let series = Series::line(curve.label, curve.colour, points);
            panel = panel.with_series(if curve.is_dashed { series.dashed() } else { series });
        }
        figure = figure.with_panel(panel);
    }
    figure
}

/// Label of an axis.
fn label(axis: &Axis) -> String {
    match unit(&axis.key) {
        "" => axis.key.clone(),
        unit => format!("{}, {unit}", axis.key),
    }
}

/// An axis as drawn: each cell is centred on its value.
struct Shown {
    numbering: Numbering,
    range: (f64, f64),
}

impl Shown {
    fn of(axis: &Axis) -> Self {
        let numbering = match axis.spacing {
            Spacing::Linear => Numbering::Plain,
            Spacing::Logarithmic => Numbering::PowersOfTen,
        };
        let shown = Self { numbering, range: (0.0, 1.0) };
        let (from, to) = (shown.place(axis.from), shown.place(axis.to));
        let half = 0.5 * (to - from) / (axis.count - 1) as f64;
        Self { range: (from - half, to + half), ..shown }
    }

    fn place(&self, value: f64) -> f64 {
        match self.numbering {
            Numbering::Plain => value,
            Numbering::PowersOfTen => libm::log10(value),
        }
    }
}
