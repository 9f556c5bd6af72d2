//! Series on the page.

use super::axes::Axes;
use super::drawing::Drawing;
use super::geometry::{Place, Rect};
use super::palette::Stroke;
use super::series::{Series, Trace};
use super::thinning::{thinned, thinned_dots};

const DOT_DIAMETER: f64 = 3.4;

/// Series on the page, thinned and cut off at the frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    stroke: Stroke,
    lines: Vec<Vec<Place>>,
    dots: Vec<Place>,
}

impl Curve {
    pub(super) fn of(series: &Series, axes: &Axes) -> Self {
        let mut curve = Self { stroke: Stroke::of(series), lines: Vec::new(), dots: Vec::new() };
        for run in runs(series, axes) {
            curve.add(run, series.trace, axes.area);
        }
        curve
    }

    pub(super) fn all(series: &[Series], axes: &Axes) -> Vec<Self> {
        series.iter().map(|series| Self::of(series, axes)).collect()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.lines.is_empty() && self.dots.is_empty()
    }

    fn add(&mut self, run: Vec<Place>, trace: Trace, area: Rect) {
        let first = run.first().copied().unwrap_or_default();
        let is_one_place =
            run.iter().all(|(x, y)| (x - first.0).abs() < 0.05 && (y - first.1).abs() < 0.05);
        if trace == Trace::Dots || (is_one_place && trace != Trace::Bars) {
            let inside = run.into_iter().filter(|place| area.contains(*place));
            self.dots.extend(thinned_dots(inside.collect()));
            return;
        }
        let points = thinned(run, area.width);
        let path = if trace == Trace::Steps { held(&points) } else { points };
        self.lines.extend(area.cut_all(&path));
    }

    /// Number of pieces of the curve that an opaque area would hide.
    pub(super) fn pieces_within(&self, area: &Rect) -> usize {
        let pieces = self
            .lines
            .iter()
            .flat_map(|line| line.windows(2))
            .filter(|pair| area.cut(pair[0], pair[1]).is_some());
        let dots = self.dots.iter().filter(|place| area.contains(**place));
        pieces.count() + dots.count()
    }

    pub(super) fn draw(&self, drawing: &mut Drawing) {
        drawing.curves(self.lines.clone(), self.stroke);
        drawing.dots(self.dots.clone(), self.stroke.colour, DOT_DIAMETER);
    }
}

/// Parts of the series on the page, split where a point is not finite.
fn runs(series: &Series, axes: &Axes) -> Vec<Vec<Place>> {
    // More gaps than this cannot be seen; the curve is drawn through them.
    const MOST_GAPS: usize = 500;
    let is_finite = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
    let runs: Vec<Vec<Place>> = series
        .points
        .split(|point| !is_finite(point))
        .filter(|run| !run.is_empty())
        .map(|run| run.iter().map(|point| axes.place(*point)).collect())
        .collect();
    let as_one = match series.trace {
        Trace::Dots => true,
        Trace::Bars => false,
        Trace::Line | Trace::Steps => runs.len() > MOST_GAPS,
    };
    if as_one { vec![runs.concat()] } else { runs }
}

/// Path of values that are held until the next point.
fn held(points: &[Place]) -> Vec<Place> {
    let first = points.first().copied();
    let steps = points.windows(2).flat_map(|pair| [(pair[1].0, pair[0].1), pair[1]]);
    first.into_iter().chain(steps).collect()
}

#[cfg(test)]
mod tests {
    use super::super::span::Span;
    use super::*;

    const AXES: Axes = Axes {
        area: Rect::new(0.0, 0.0, 100.0, 100.0),
        x: Span { low: 0.0, high: 1.0 },
        y: Span { low: 0.0, high: 1.0 },
    };

    #[test]
    fn a_held_value_jumps_at_the_next_point() {
        let series = Series::steps("", 0, vec![(0.0, 0.0), (0.5, 1.0), (1.0, 0.5)]);
        let curve = Curve::of(&series, &AXES);
        let expected = vec![(0.0, 100.0), (50.0, 100.0), (50.0, 0.0), (100.0, 0.0), (100.0, 50.0)];
        assert_eq!(curve.lines, [expected]);
    }

    #[test]
    fn bars_go_from_their_start_to_their_end_at_their_height() {
        let bars = [(0.0, 0.25, 0.5), (0.5, 0.5 + 1e-6, 0.0), (0.75, 2.0, 1.0)];
        let curve = Curve::of(&Series::bars("", 0, &bars), &AXES);
        let ends = |line: &Vec<Place>| (line[0], line[line.len() - 1]);
        let drawn: Vec<_> = curve.lines.iter().map(ends).collect();
        assert_eq!(drawn[0], ((0.0, 50.0), (25.0, 50.0)));
        assert!((drawn[1].0.0 - 50.0).abs() < 1e-3 && drawn[1].0.1 == 100.0);
        assert_eq!(drawn[2], ((75.0, 0.0), (100.0, 0.0)));
        assert!(curve.dots.is_empty() && curve.stroke.dash.is_empty());
    }

    #[test]
    fn points_that_are_not_finite_leave_a_gap() {
        let points = vec![
            (0.0, 0.0),
            (0.1, 0.1),
            (0.2, f64::NAN),
            (0.3, 0.3),
            (0.4, 0.4),
            (0.5, f64::INFINITY),
            (0.6, 0.6),
        ];
        let curve = Curve::of(&Series::line("", 0, points), &AXES);
        assert_eq!(curve.lines.len(), 2);
        assert_eq!(curve.dots.len(), 1);
    }

    #[test]
    fn nothing_leaves_the_frame() {
        let points = (0..1000)
            .map(|index| (f64::from(index) / 500.0 - 0.5, f64::from(index % 7) * 1e300 - 1e300));
        for trace in [Trace::Line, Trace::Steps, Trace::Dots] {
            let series = Series { trace, ..Series::line("", 0, points.clone().collect()) };
            let curve = Curve::of(&series, &AXES);
            let places = curve.lines.iter().flatten().chain(&curve.dots);
            assert!(places.into_iter().all(|place| AXES.area.contains(*place)));
        }
    }
}
