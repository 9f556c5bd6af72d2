//! Figures of all entrants' curves, overlaid.

use super::comparison::{Comparison, Outcome};
use super::contacts::wall;
use super::table::Setting;
use crate::measure::Verdict;
use crate::simulate::Criterion;
use crate::text::file_name;
use lyapunov_figures::{Figure, Guide, PALETTE, Panel, Series};

/// Height of a panel with a single curve, in pixels of the drawing.
const ALONE: f64 = 130.0;

/// The shown range as a multiple of the starting swing, if every entrant grows.
const SHOWN: f64 = 3.0;

type Points = Vec<(f64, f64)>;

pub(super) fn of(comparison: &Comparison) -> Figure {
    let everyone: Vec<&Outcome> = comparison.outcomes.iter().collect();
    let observed: Vec<&Outcome> =
        everyone.iter().copied().filter(|outcome| observes(outcome)).collect();
    let position =
        Drawing { label: "position, mm", scale: 1e3, curve: |outcome| &outcome.curves.position };
    let energy = Drawing {
        label: "observed energy, mJ",
        scale: 1e3,
        curve: |outcome| &outcome.curves.observed_energy,
    };
    let figure = empty(comparison);
    let surface = wall(&comparison.scene).map(|wall| 1e3 * wall.position.get());
    let on_surface = |panel: Panel| match surface {
        Some(surface) => panel.with_guide(Guide::horizontal(surface, "wall surface")),
        None => panel,
    };
    let about_zero = |panel: Panel| panel.with_guide(Guide::horizontal(0.0, ""));
    // More curves than colours cannot be told apart: each then has a row of its own, on common scales.
    if everyone.len() > PALETTE.len() {
        let (reach, sums) =
            (position.range(comparison, &everyone), energy.range(comparison, &observed));
        return everyone.iter().fold(
            figure.with_columns(2).with_panel_height(ALONE),
            |figure, outcome| {
                let name = &outcome.score.stabilizer;
                let moved = position.panel(comparison, name, &[outcome], reach);
                let figure = figure.with_panel(on_surface(moved));
                let summed = energy.panel(comparison, name, &[outcome], sums);
                figure.with_panel(about_zero(summed))
            },
        );
    }
    let moved = position.overlaid(comparison, "position", &everyone);
    let figure = figure.with_panel_height(280.0).with_panel(on_surface(moved));
    if observed.is_empty() {
        return figure;
    }
    figure.with_panel(about_zero(energy.overlaid(comparison, "observed energy", &observed)))
}

/// The forces on the plant: overlaid, or for many entrants in a row each.
pub(super) fn forces(comparison: &Comparison) -> Figure {
    let everyone: Vec<&Outcome> = comparison.outcomes.iter().collect();
    let force = Drawing { label: "force, N", scale: 1.0, curve: |outcome| &outcome.curves.force };
    let figure = empty(comparison);
    if everyone.len() <= PALETTE.len() {
        let panel = force.overlaid(comparison, "force on the plant", &everyone);
        return figure.with_panel_height(320.0).with_panel(panel);
    }
    let reach = force.range(comparison, &everyone);
    everyone.iter().fold(figure.with_columns(2).with_panel_height(ALONE), |figure, outcome| {
        let name = &outcome.score.stabilizer;
        figure.with_panel(force.panel(comparison, name, &[outcome], reach))
    })
}

/// An empty figure of a comparison.
fn empty(comparison: &Comparison) -> Figure {
    let title = format!("{}: {}", file_name(&comparison.name), Setting(&comparison.scene));
    Figure::new(title).with_width(960.0)
}

/// Whether the entrant has an observed energy to show.
fn observes(outcome: &Outcome) -> bool {
    outcome.curves.observed_energy.iter().any(|point| point.1 != 0.0)
}

/// A curve that is drawn of every outcome.
struct Drawing {
    label: &'static str,
    /// Units of the label per unit of the curve.
    scale: f64,
    curve: fn(&Outcome) -> &Points,
}

impl Drawing {
    /// The range of the curves of `outcomes`, as far as they count.
    fn range(&self, comparison: &Comparison, outcomes: &[&Outcome]) -> Option<(f64, f64)> {
        span(outcomes.iter().flat_map(|outcome| {
            let until = shown_until(comparison, outcome, outcomes);
            let points = (self.curve)(outcome).iter();
            points.take_while(move |point| point.0 < until).map(|point| point.1)
        }))
    }

    /// The curves of `outcomes`; one of a run that grows ends where it leaves `range`.
    fn panel(
        &self,
        comparison: &Comparison,
        title: &str,
        outcomes: &[&Outcome],
        range: Option<(f64, f64)>,
    ) -> Panel {
        let mut panel = Panel::new(title, "time, s", self.label)
            .with_x_range(0.0, comparison.scene.duration.get());
        for (index, outcome) in outcomes.iter().enumerate() {
            let points = (self.curve)(outcome);
            // A curve that grows ends where it first leaves the frame: its returns would only be upright lines.
            let end = range.filter(|_| grows(outcome)).and_then(|(low, high)| {
                points.iter().position(|point| !(low..=high).contains(&point.1))
            });
            let kept = &points[..end.map_or(points.len(), |end| end + 1)];
            let name = if outcomes.len() > 1 { &outcome.score.stabilizer[..] } else { "" };
            let cut = if grows(outcome) { "(grows, cut off)" } else { "" };
            let gap = if name.is_empty() || cut.is_empty() { "" } else { " " };
            // Alone in its panel, a curve needs no dashes.
            let colour =
                if outcomes.len() > 1 { outcome.number } else { outcome.number % PALETTE.len() };
            let scaled = kept.iter().map(|(t, y)| (*t, self.scale * y)).collect();
            let series = Series::line(format!("{name}{gap}{cut}"), colour, scaled);
            // Over an equal curve, dashes let both be seen.
            let hides = outcomes[..index].iter().any(|other| (self.curve)(other) == points);
            panel = panel.with_series(if hides { series.dashed() } else { series });
        }
        match range {
            Some((low, high)) => panel.with_y_range(self.scale * low, self.scale * high),
            None => panel,
        }
    }

    /// All curves in one frame, that of the runs that do not grow if some do.
    fn overlaid(&self, comparison: &Comparison, title: &str, outcomes: &[&Outcome]) -> Panel {
        let some_grow = outcomes.iter().any(|outcome| grows(outcome));
        let range = self.range(comparison, outcomes).filter(|_| some_grow);
        self.panel(comparison, title, outcomes, range)
    }
}

fn grows(outcome: &Outcome) -> bool {
    outcome.score.verdict == Verdict::Grows
}

/// The time up to which a curve counts for the shown range: to its end unless it grows, else not at all, or if all grow,
/// until it leaves [`SHOWN`] starting swings, where the scene has any.
fn shown_until(comparison: &Comparison, outcome: &Outcome, outcomes: &[&Outcome]) -> f64 {
    if !grows(outcome) {
        return f64::INFINITY;
    }
    if !outcomes.iter().all(|outcome| grows(outcome)) {
        return f64::NEG_INFINITY;
    }
    let criterion = Criterion::of(&comparison.scene);
    let Some(rest) = criterion.place() else { return f64::INFINITY };
    let reach = SHOWN * criterion.start;
    let points = &outcome.curves.position;
    let left = points.iter().find(|point| (point.1 - rest).abs() > reach);
    left.map_or(f64::INFINITY, |point| point.0)
}

/// The range of the values with a margin, unless the range is empty or infinite.
fn span(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let covered = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (value.min(low), value.max(high))
    });
    let room = 0.05 * (covered.1 - covered.0);
    (room > 0.0 && room.is_finite()).then_some((covered.0 - room, covered.1 + room))
}
