//! Heat maps of a map.

use super::axis::{Axis, Spacing};
use super::bounds::{Bounds, Curve};
use super::grid::Grid;
use super::survey::Survey;
use crate::files::scene::unit;
use crate::measure::Verdict;
use crate::measure::runs::Measure;
use lyapunov_figures::{Figure, HeatMap, Numbering, Panel, Series};

/// Width of a panel, in pixels of the drawing.
const WIDTH: f64 = 560.0;

const HEIGHT: f64 = 330.0;

/// The most picture elements along an axis; a larger map is drawn by the means of its cells.
pub(super) const FINEST: u64 = 512;

/// The middle one of the values of `axis` that share an element of the picture.
pub(super) fn middle(axis: &Axis, element: u64, elements: u64) -> u64 {
    let first = |element: u64| (element * axis.count).div_ceil(elements);
    first(element).midpoint(first(element + 1) - 1)
}

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

/// The names of all figures of a map.
pub fn figure_names() -> impl Iterator<Item = &'static str> {
    [VERDICT].into_iter().chain(Measure::ALL.iter().map(figure_name))
}

/// The name of the figure of `measure`: its key without the unit.
fn figure_name(measure: &Measure) -> &'static str {
    measure.key.rsplit_once('_').map_or(measure.key, |(name, _unit)| name)
}

/// One figure for the verdicts and one for each measure, a panel for each stabilizer.
pub fn figures(survey: &Survey, bounds: Option<&Bounds>) -> Vec<NamedFigure> {
    let curves = bounds.map_or_else(Vec::new, Bounds::curves);
    let words = Verdict::ALL.map(Verdict::word);
    let judged = &words[..Verdict::TooShort as usize];
    let verdicts = figure(survey, "verdicts on the runs", &curves, |index| {
        HeatMap::of_classes(survey.size().0, survey.verdicts(index), judged)
    });
    let mut drawn = vec![NamedFigure { name: VERDICT, words: VERDICTS, figure: verdicts }];
    for (number, measure) in Measure::ALL.iter().enumerate() {
        // No cell has some measures, such as the stiffness felt where no contact is long.
        let Some((low, high)) = range(survey, number) else { continue };
        let of =
            |index| HeatMap::new(survey.size().0, survey.mean(index, number)).with_range(low, high);
        let figure = figure(survey, measure.words, &curves, of);
        drawn.push(NamedFigure { name: figure_name(measure), words: measure.words, figure });
    }
    drawn
}

const VERDICT: &str = "verdict";

const VERDICTS: &str = "The verdict on each run, empty where it is too short to judge";

/// Range of a measure over all stabilizers, so that one colour means the same in every panel.
fn range(survey: &Survey, measure: usize) -> Option<(f64, f64)> {
    let all = (0..survey.grid().stabilizers.len()).flat_map(|index| survey.mean(index, measure));
    let finite = all.filter(|value| value.is_finite());
    finite.fold(None, |range, value| match range {
        None => Some((value, value)),
        Some((low, high)) => Some((f64::min(low, value), f64::max(high, value))),
    })
}

fn figure(survey: &Survey, words: &str, curves: &[Curve], of: impl Fn(usize) -> HeatMap) -> Figure {
    panels(survey.grid(), words, curves, |index| (of(index), Vec::new()))
}

/// A figure with a heat map for each stabilizer, with `curves` and the series `of` each.
pub(super) fn panels(
    grid: &Grid,
    words: &str,
    curves: &[Curve],
    of: impl Fn(usize) -> (HeatMap, Vec<Series>),
) -> Figure {
    let columns = if grid.stabilizers.len() > 1 { 2 } else { 1 };
    let mut figure = Figure::new(words)
        .with_width(WIDTH * columns as f64)
        .with_columns(columns)
        .with_panel_height(HEIGHT);
    for (index, member) in grid.stabilizers.iter().enumerate() {
        let (x, y) = (Shown::of(&grid.x), Shown::of(&grid.y));
        let (heat, series) = of(index);
        let mut panel = Panel::new(member.name(), label(&grid.x), label(&grid.y))
            .with_heat(heat)
            .with_numbers(x.numbering, y.numbering)
            .with_numbers_within(x.numbered, y.numbered)
            .with_x_range(x.range.0, x.range.1)
            .with_y_range(y.range.0, y.range.1);
        for curve in curves {
            let points = curve.points.iter().map(|&(a, b)| (x.place(a), y.place(b)));
            let points: Vec<(f64, f64)> = points.collect();
            if !points.iter().any(|(a, b)| x.shows(*a) && y.shows(*b)) {
                continue;
            }
            let series = Series::line(curve.label, curve.colour, points);
            panel = panel.with_series(if curve.is_dashed { series.dashed() } else { series });
        }
        figure = figure.with_panel(series.into_iter().fold(panel, Panel::with_series));
    }
    figure
}

/// Label of an axis.
pub(super) fn label(axis: &Axis) -> String {
    match unit(&axis.key) {
        "" => axis.key.clone(),
        unit => format!("{}, {unit}", axis.key),
    }
}

/// An axis as drawn: each cell is centred on its value.
pub(super) struct Shown {
    pub(super) numbering: Numbering,
    pub(super) range: (f64, f64),
    /// From the first cell's value to the last one's: no number stands for a cell that is not there.
    numbered: (f64, f64),
}

impl Shown {
    pub(super) fn of(axis: &Axis) -> Self {
        let numbering = match axis.spacing {
            Spacing::Linear => Numbering::Plain,
            Spacing::Logarithmic => Numbering::PowersOfTen,
        };
        let shown = Self { numbering, range: (0.0, 1.0), numbered: (0.0, 1.0) };
        let (from, to) = (shown.place(axis.from), shown.place(axis.to));
        let half = match axis.count {
            1 if from == 0.0 => 0.5,
            1 => 0.05 * from.abs(),
            count => 0.5 * (to - from) / (count - 1) as f64,
        };
        Self { range: (from - half, to + half), numbered: (from, to), ..shown }
    }

    fn shows(&self, place: f64) -> bool {
        (self.range.0..=self.range.1).contains(&place)
    }

    pub(super) fn place(&self, value: f64) -> f64 {
        match self.numbering {
            Numbering::Plain => value,
            Numbering::PowersOfTen => libm::log10(value),
        }
    }
}
