//! The curves of all contestants over each other.

use super::comparison::{Comparison, Outcome};
use super::tick::wall;
use crate::chart::{Figure, Guide, Panel, Series};
use crate::compare::setting::Setting;
use crate::equilibrium::equilibrium;
use crate::meters::Criterion;

/// How many times the starting swing is shown where nobody is stable.
const SHOWN: f64 = 3.0;

type Points = Vec<(f64, f64)>;

pub(super) fn of(comparison: &Comparison) -> Figure {
    let surface = wall(&comparison.scene).map(|wall| 1e3 * wall.position.get());
    let observed: Vec<&Outcome> =
        comparison.outcomes.iter().filter(|outcome| observes(outcome)).collect();
    let everyone: Vec<&Outcome> = comparison.outcomes.iter().collect();
    let position = panel(comparison, "position", "position, mm", &everyone, |outcome| {
        &outcome.curves.position
    });
    let observer = panel(comparison, "observer", "observer sum, mJ", &observed, |outcome| {
        &outcome.curves.observer
    });
    let figure = Figure::new(format!("{}: {}", comparison.name, Setting(&comparison.scene)))
        .with_width(960.0)
        .with_panel_height(280.0)
        .with_panel(match surface {
            Some(surface) => position.with_guide(Guide::horizontal(surface, "wall surface")),
            None => position,
        });
    if observed.is_empty() {
        return figure;
    }
    figure.with_panel(observer.with_guide(Guide::horizontal(0.0, "")))
}

/// Whether the contestant has a sum to show.
fn observes(outcome: &Outcome) -> bool {
    outcome.curves.observer.iter().any(|point| point.1 != 0.0)
}

fn panel(
    comparison: &Comparison,
    title: &str,
    label: &str,
    outcomes: &[&Outcome],
    curve: impl Fn(&Outcome) -> &Points,
) -> Panel {
    let shown = outcomes.iter().flat_map(|outcome| {
        let until = shown_until(comparison, outcome, outcomes);
        curve(outcome).iter().take_while(move |point| point.0 < until).map(|point| point.1)
    });
    let range = span(shown).filter(|_| outcomes.iter().any(|outcome| is_unstable(outcome)));
    let mut panel =
        Panel::new(title, "time, s", label).with_x_range(0.0, comparison.scene.duration.get());
    for (index, outcome) in outcomes.iter().enumerate() {
        let points = curve(outcome);
        // An unstable curve ends where it first leaves the frame: its returns would only be upright lines.
        let end = range.filter(|_| is_unstable(outcome)).and_then(|(low, high)| {
            points.iter().position(|point| !(low..=high).contains(&point.1))
        });
        let kept = &points[..end.map_or(points.len(), |end| end + 1)];
        let unstable = if is_unstable(outcome) { " (unstable, cut off)" } else { "" };
        let name = format!("{}{unstable}", outcome.score.stabilizer);
        let scaled = kept.iter().map(|(t, y)| (*t, 1e3 * y)).collect();
        let series = Series::line(name, outcome.number, scaled);
        // Over an equal curve, dashes let both be seen.
        let hides = outcomes[..index].iter().any(|other| curve(other) == points);
        panel = panel.with_series(if hides { series.dashed() } else { series });
    }
    match range {
        Some((low, high)) => panel.with_y_range(1e3 * low, 1e3 * high),
        None => panel,
    }
}

fn is_unstable(outcome: &Outcome) -> bool {
    outcome.score.stable == Some(false)
}

/// Until when a curve counts for the range that is shown: the stable ones to their end and the others not at
/// all, or where all are unstable, until each leaves some starting swings.
fn shown_until(comparison: &Comparison, outcome: &Outcome, outcomes: &[&Outcome]) -> f64 {
    if !is_unstable(outcome) {
        return f64::INFINITY;
    }
    if !outcomes.iter().all(|outcome| is_unstable(outcome)) {
        return f64::NEG_INFINITY;
    }
    let reach = SHOWN * Criterion::of(&comparison.scene).start();
    let rest = equilibrium(&comparison.scene).unwrap_or(0.0);
    let points = &outcome.curves.position;
    let left = points.iter().find(|point| (point.1 - rest).abs() > reach);
    left.map_or(f64::INFINITY, |point| point.0)
}

/// What the values cover and a little more, if that is anything.
fn span(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let covered = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (value.min(low), value.max(high))
    });
    let room = 0.05 * (covered.1 - covered.0);
    (room > 0.0 && room.is_finite()).then_some((covered.0 - room, covered.1 + room))
}
