//! Figures of all entrants' curves: overlaid, or for many a small panel each. Equal curves are drawn once.

use super::comparison::{Comparison, Outcome};
use super::equal::{CURVES, Points, is_same};
use super::table::Setting;
use crate::files::Scene;
use crate::measure::Verdict;
use crate::measure::quantile::median;
use crate::simulate::Criterion;
use crate::text::{file_name, shortened_names};
use lyapunov_figures::{Figure, Guide, PALETTE, Panel, Series};

/// Height of a small panel, in pixels of the drawing, and how many stand side by side.
const SMALL: f64 = 96.0;
const BESIDE: usize = 4;

/// Characters of a title of a small panel.
const ROOM: usize = 20;

/// Characters of a name in a legend.
const LEGEND: usize = 60;

/// The shown range as a multiple of the starting swing, if every entrant grows.
const SHOWN: f64 = 3.0;

/// A curve this many times as large as the middle one, or as small, has a scale of its own among small panels; and of a
/// run that nobody judges, it does not set the scale where all are overlaid.
const APART: f64 = 2.5;

type Range = (f64, f64);

pub(super) fn of(comparison: &Comparison) -> Figure {
    let everyone: Vec<&Outcome> = comparison.outcomes.iter().collect();
    let colours = colours(&everyone);
    let observed: Vec<&Outcome> =
        everyone.iter().copied().filter(|outcome| observes(outcome)).collect();
    let wall = comparison.scene.environment.wall();
    let surface = wall.map(|wall| 1e3 * wall.position.get());
    let (what, label) = coordinate(&comparison.scene);
    let position = Drawing {
        comparison,
        colours: &colours,
        what,
        label,
        unit: "mm",
        scale: 1e3,
        guide: surface.map(|surface| (surface, "wall surface")),
        curve: |outcome| &outcome.curves.position,
    };
    let energy = Drawing {
        comparison,
        colours: &colours,
        what: "observed energy",
        label: "energy",
        unit: "mJ",
        scale: 1e3,
        guide: Some((0.0, "")),
        curve: |outcome| &outcome.curves.observed_energy,
    };
    let groups = shared(&everyone, &[position.curve, energy.curve]);
    if groups.len() > PALETTE.len() {
        let pairs = position.small(&groups).into_iter().zip(energy.small(&groups));
        let panels = pairs.flat_map(|(moved, summed)| [moved, summed]);
        return panels.fold(small(comparison), Figure::with_panel);
    }
    let figure =
        empty(comparison).with_panel_height(280.0).with_panel(position.overlaid(&everyone));
    if observed.is_empty() { figure } else { figure.with_panel(energy.overlaid(&observed)) }
}

/// The coordinate that positions are drawn along: what it is, and its name on the axis.
fn coordinate(scene: &Scene) -> (&'static str, &'static str) {
    match (scene.dimensions(), Criterion::of(scene).equilibria.len()) {
        (1, _) => ("position", "position"),
        (_, 1..) => ("distance from the equilibrium", "distance"),
        (_, 0) => ("distance from the hand's rest", "distance"),
    }
}

/// The forces on the plant.
pub(super) fn forces(comparison: &Comparison) -> Figure {
    let everyone: Vec<&Outcome> = comparison.outcomes.iter().collect();
    let force = Drawing {
        comparison,
        colours: &colours(&everyone),
        what: if comparison.scene.dimensions() > 1 {
            "size of the force on the plant"
        } else {
            "force on the plant"
        },
        label: "force",
        unit: "N",
        scale: 1.0,
        guide: None,
        curve: |outcome| &outcome.curves.force,
    };
    let groups = shared(&everyone, &[force.curve]);
    if groups.len() > PALETTE.len() {
        return force.small(&groups).into_iter().fold(small(comparison), Figure::with_panel);
    }
    empty(comparison).with_panel_height(320.0).with_panel(force.overlaid(&everyone))
}

/// An empty figure of a comparison.
fn empty(comparison: &Comparison) -> Figure {
    let title = format!("{}: {}", file_name(&comparison.name), Setting(&comparison.scene));
    Figure::new(title).with_width(960.0)
}

/// An empty figure for small panels: more curves than colours cannot be told apart in one.
fn small(comparison: &Comparison) -> Figure {
    empty(comparison).with_columns(BESIDE).with_panel_height(SMALL)
}

/// Whether the entrant has an observed energy to show.
fn observes(outcome: &Outcome) -> bool {
    outcome.curves.observed_energy.iter().any(|point| point.1 != 0.0)
}

/// A curve that is drawn of every outcome.
struct Drawing<'a> {
    comparison: &'a Comparison,
    colours: &'a [Shared<'a>],
    what: &'static str,
    /// Its name beside a small panel.
    label: &'static str,
    unit: &'static str,
    /// Units of the label per unit of the curve.
    scale: f64,
    /// A level with its name.
    guide: Option<(f64, &'static str)>,
    curve: fn(&Outcome) -> &Points,
}

/// Outcomes with the same curve, the first of which is drawn, and their names.
struct Shared<'a> {
    first: &'a Outcome,
    names: Vec<&'a str>,
}

/// The outcomes, those once that share all `curves`.
fn shared<'a>(outcomes: &[&'a Outcome], curves: &[fn(&Outcome) -> &Points]) -> Vec<Shared<'a>> {
    let mut all: Vec<Shared<'a>> = Vec::new();
    for outcome in outcomes {
        let name = &outcome.score.stabilizer[..];
        let has_same = |one: &&mut Shared<'_>| {
            curves.iter().all(|curve| is_same(curve(one.first), curve(outcome)))
        };
        match all.iter_mut().find(has_same) {
            Some(one) => one.names.push(name),
            None => all.push(Shared { first: outcome, names: vec![name] }),
        }
    }
    all
}

/// The outcomes that have a colour each, in every panel and figure of the page: equal ones have one.
fn colours<'a>(outcomes: &[&'a Outcome]) -> Vec<Shared<'a>> {
    let mut outcomes = outcomes.to_vec();
    outcomes.sort_by_key(|it| it.number);
    shared(&outcomes, &CURVES)
}

impl Drawing<'_> {
    /// A panel for each curve, on one scale, but for those that it would flatten or that would flatten the others.
    fn small(&self, shared: &[Shared<'_>]) -> Vec<Panel> {
        let ranges: Vec<Option<Range>> =
            shared.iter().map(|one| self.range(&[one.first], shared)).collect();
        let sizes = ranges.iter().flatten().map(|(low, high)| high - low);
        let middle = median(sizes).unwrap_or(0.0);
        let is_usual = |range: &Range| {
            let size = range.1 - range.0;
            size <= APART * middle && size * APART >= middle
        };
        let common = hull(ranges.iter().flatten().copied().filter(is_usual));
        let panel = |(one, range): (&Shared<'_>, &Option<Range>)| {
            let is_apart = range.is_some_and(|range| !is_usual(&range));
            let shown = if is_apart { *range } else { common };
            let panel = Panel::new(
                shortened_names(&one.names, ROOM),
                "time, s",
                format!("{}, {}", self.label, self.unit),
            );
            let is_zero = (self.curve)(one.first).iter().all(|point| point.1 == 0.0);
            let note = match (is_zero, is_apart) {
                (true, _) => "0 throughout",
                (false, true) => "own scale",
                (false, false) => "",
            };
            self.framed(panel, &[(one, note.to_owned())], shown, false)
        };
        shared.iter().zip(&ranges).map(panel).collect()
    }

    /// All curves in one frame, that of the runs that do not grow if some do.
    fn overlaid(&self, outcomes: &[&Outcome]) -> Panel {
        let shared = &shared(outcomes, &[self.curve])[..];
        let panel = Panel::new(self.what, "time, s", format!("{}, {}", self.what, self.unit));
        let outcomes: Vec<&Outcome> = shared.iter().map(|one| one.first).collect();
        let setting = self.setting(&outcomes);
        let some_leave = setting.len() < outcomes.len() || outcomes.iter().all(|it| grows(it));
        let range = self.range(&setting, shared).filter(|_| some_leave);
        let named: Vec<_> =
            shared.iter().map(|one| (one, shortened_names(&one.names, LEGEND))).collect();
        self.framed(panel, &named, range, true)
    }

    /// The outcomes that set the scale of all: not those that grow, unless all do, and not those far larger that nobody
    /// judges.
    fn setting<'a>(&self, outcomes: &[&'a Outcome]) -> Vec<&'a Outcome> {
        let calm: Vec<&Outcome> = outcomes.iter().copied().filter(|it| !grows(it)).collect();
        let sized = |outcome: &Outcome| {
            let points = (self.curve)(outcome).iter().map(|point| point.1);
            span(points).map_or(0.0, |(low, high)| high - low)
        };
        let Some(middle) = median(calm.iter().map(|outcome| sized(outcome))) else {
            return outcomes.to_vec();
        };
        let judged = |outcome: &&Outcome| {
            outcome.score.verdict != Verdict::TooShort || sized(outcome) <= APART * middle
        };
        calm.into_iter().filter(judged).collect()
    }

    /// The index of the colour of a curve.
    fn colour(&self, one: &Shared<'_>) -> usize {
        let name = &&one.first.score.stabilizer[..];
        self.colours.iter().position(|it| it.names.contains(name)).unwrap_or(0)
    }

    /// The range of the curves of `outcomes`, as far as they count among `all`.
    fn range(&self, outcomes: &[&Outcome], all: &[Shared<'_>]) -> Option<Range> {
        let all_grow = all.iter().all(|one| grows(one.first));
        span(outcomes.iter().flat_map(|outcome| {
            let until = shown_until(self.comparison, outcome, all_grow);
            let points = (self.curve)(outcome).iter();
            points.take_while(move |point| point.0 < until).map(|point| point.1)
        }))
    }

    /// `panel` with the named curves; one that leaves `range` and grows, or is not judged, ends there.
    fn framed(
        &self,
        panel: Panel,
        named: &[(&Shared<'_>, String)],
        range: Option<Range>,
        has_names: bool,
    ) -> Panel {
        let mut panel = panel.with_x_range(0.0, self.comparison.scene.duration.get());
        for (one, name) in named {
            let (outcome, points) = (one.first, (self.curve)(one.first));
            // A curve that grows ends where it first leaves the frame: its returns would only be upright lines.
            let ends = grows(outcome) || outcome.score.verdict == Verdict::TooShort;
            let is_zero = points.iter().all(|point| point.1 == 0.0);
            let end = range.filter(|_| ends).and_then(|(low, high)| {
                points.iter().position(|point| !(low..=high).contains(&point.1))
            });
            let kept = &points[..end.map_or(points.len(), |end| end + 1)];
            let cut = match (grows(outcome), end) {
                _ if is_zero => "",
                (true, _) => "(grows, cut off)",
                (false, Some(_)) => "(cut off)",
                (false, None) => "",
            };
            let gap = if name.is_empty() || cut.is_empty() { "" } else { " " };
            let colour = if has_names { self.colour(one) } else { 0 };
            let scaled = kept.iter().map(|(t, y)| (*t, self.scale * y)).collect();
            panel = panel.with_series(Series::line(format!("{name}{gap}{cut}"), colour, scaled));
        }
        if let Some((low, high)) = range {
            panel = panel.with_y_range(self.scale * low, self.scale * high);
        }
        // Small panels have no room to write beside a line.
        match self.guide {
            Some((level, name)) => {
                panel.with_guide(Guide::horizontal(level, if has_names { name } else { "" }))
            }
            None => panel,
        }
    }
}

fn grows(outcome: &Outcome) -> bool {
    outcome.score.verdict == Verdict::Grows
}

/// The time up to which a curve counts for the shown range: to its end unless it grows, else not at all, or if all grow,
/// until it leaves [`SHOWN`] starting swings, where the scene has any.
fn shown_until(comparison: &Comparison, outcome: &Outcome, all_grow: bool) -> f64 {
    if !grows(outcome) {
        return f64::INFINITY;
    }
    if !all_grow {
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
fn span(values: impl Iterator<Item = f64>) -> Option<Range> {
    let covered = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (value.min(low), value.max(high))
    });
    let room = 0.05 * (covered.1 - covered.0);
    (room > 0.0 && room.is_finite()).then_some((covered.0 - room, covered.1 + room))
}

/// The range that covers all `ranges`.
fn hull(ranges: impl Iterator<Item = Range>) -> Option<Range> {
    ranges.reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)))
}

#[cfg(test)]
mod tests {
    use super::super::Entrants;
    use super::super::tests::{Damper, press};
    use super::*;
    use crate::simulate::family::StabilizerName;
    use crate::studies::paper::Case;

    #[test]
    fn figures_end_a_curve_that_grows_where_it_leaves_the_frame() {
        let entrants = Entrants::<f64>::standard();
        let comparison =
            Comparison::of("50k", &Case::Plain50k.scene().unwrap(), &entrants).unwrap();
        let figure = comparison.figure();
        let [position, energy] = &figure.panels[..] else { panic!() };
        let (low, high) = position.y_range.unwrap();
        assert!((-13.0..-10.0).contains(&low) && (0.0..2.0).contains(&high), "{low} {high}");
        assert!(position.series[0].points.len() < 50 && position.series[1].points.len() == 1001);
        // It is drawn to the first point outside, so that the line meets the frame.
        let (last, kept) = position.series[0].points.split_last().unwrap();
        let is_within = |point: &(f64, f64)| (low..=high).contains(&point.1);
        assert!(kept.iter().all(is_within) && !is_within(last), "{last:?}");
        // POPC is LOLC with a spring as its candidate: one curve with both names. Every name is there once.
        assert!(position.series[1].label.starts_with("popc = lolc-spring"), "{position:?}");
        // A stabilizer has one colour.
        for shown in &energy.series {
            let same = position.series.iter().find(|it| it.label == shown.label).unwrap();
            assert_eq!(shown.colour, same.colour, "{}", shown.label);
        }
        for (panel, count) in [(position, 5), (energy, 4)] {
            let labels =
                panel.series.iter().map(|series| series.label.replace(" (grows, cut off)", ""));
            let labels: Vec<String> = labels.collect();
            let mut names: Vec<&str> = labels.iter().flat_map(|label| label.split(" = ")).collect();
            names.sort_unstable();
            names.dedup();
            let all = comparison.scores().filter(|score| names.contains(&&score.stabilizer[..]));
            assert!(names.len() == count && all.count() == count, "{labels:?}");
        }

        // The whole family has more curves than there are colours.
        let family = Entrants::<f64>::of(StabilizerName::ALL);
        let family = Comparison::of("50k", &Case::Plain50k.scene().unwrap(), &family).unwrap();
        let panels = family.figure().panels;
        let kinds = panels.len() / 2;
        assert!((10..StabilizerName::ALL.len() - 2).contains(&kinds), "{kinds}");
        assert!(panels.iter().all(|panel| panel.series.len() == 1));
        // One scale, unless a panel says that it has its own; and every curve fills a part of it.
        let own = |panel: &&Panel| panel.series[0].label.contains("own scale");
        let usual: Vec<_> = panels.iter().step_by(2).filter(|panel| !own(panel)).collect();
        assert!(usual.len() > kinds / 2 && usual.iter().all(|it| it.y_range == usual[0].y_range));
        for panel in panels.iter().filter(|panel| !panel.series[0].label.contains("grows")) {
            let values = || panel.series[0].points.iter().map(|point| point.1);
            let size = values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min);
            let (low, high) = panel.y_range.unwrap();
            assert!(size == 0.0 || size > 0.1 * (high - low), "{}: {size}", panel.title);
        }

        let alone = Entrants::<f64>::empty().with("pump", |_| Ok(Damper(-40.0)));
        let alone = Comparison::of("alone", &Case::Plain8k.scene().unwrap(), &alone).unwrap();
        let range = alone.figure().panels[0].y_range.unwrap();
        assert!(range.1 - range.0 < 60.0, "{range:?}");
    }

    #[test]
    fn as_many_forces_as_there_are_colours_share_a_frame() {
        let panels = |count: u32| {
            let damped = |all: Entrants<f64>, it| {
                all.with(format!("damper {it}"), move |_| Ok(Damper(0.5 * f64::from(it))))
            };
            let entrants = (1..=count).fold(Entrants::<f64>::empty(), damped);
            Comparison::of("press", &press(""), &entrants).unwrap().forces().panels.len()
        };
        let colours = PALETTE.len() as u32;
        assert_eq!([panels(colours), panels(colours + 1)], [1, colours as usize + 1]);
    }
}
