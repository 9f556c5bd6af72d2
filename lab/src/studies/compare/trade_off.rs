//! Trade-off of a stabilizer: on how many walls its run stays bounded, against how well it renders them.

use std::ops::ControlFlow;

use rayon::prelude::*;

use super::comparison::{CompareError, Comparison};
use super::entrant_run::{EntrantRun, Watch};
use super::entrants::Entrants;
use crate::files::scene::{Environment, NonNegative, Positive, Scene};
use crate::measure::quantile::median;
use crate::show::csv::{self, Field};
use crate::show::described::saturated;
use crate::simulate::family::BasicName;
use crate::simulate::{Criterion, Space};
use crate::text::{file_name, found, given, shortened_names};
use lyapunov_figures::{Figure, Panel, Series};

/// The number of values of the wall's stiffness, and of its damping.
const VALUES: usize = 12;

/// The factor by which the wall becomes softer and stiffer than the scene's own.
const SPREAD: f64 = 16.0;

/// The most ticks of a run.
const MOST: u64 = 20_000;

/// Height of an entrant's bars, in pixels of the drawing.
const ROW: f64 = 30.0;

/// The number of walls on which each entrant's run stays bounded, that is settles or swings, and how close it comes to the
/// ideal wall on the common ones. A wall is common if it is bounded under every stabilizer that is bounded on any wall, and
/// not under `none`, where that takes part.
///
/// The walls stand at the scene's position: 12 stiffnesses from a sixteenth to 16 times its own, in equal ratios, by 12
/// dampings from 0 to `m / (r T)`, which stops the mass `m` within one period `r T` of the environment.
#[derive(Clone, Debug)]
pub struct TradeOff {
    title: String,
    /// The name, the number of bounded walls, and the median force error on the common walls.
    rows: Vec<(String, usize, Option<f64>)>,
    walls: usize,
    common: usize,
    /// Walls that are bounded under `none`, where that takes part.
    alone: Option<usize>,
    /// Whether runs are bounded, and none of them touches its wall.
    is_untouched: bool,
    /// The remark on a saturation.
    saturated: Option<String>,
}

/// Common walls below which their median says little.
const FEW: usize = 10;

/// Room for the names of a row, in characters.
const ROOM: usize = 30;

impl TradeOff {
    /// The number of runs for each entrant, and the ticks of each; none if the scene has no wall, or is too short to judge.
    pub fn runs(scene: &Scene) -> Option<(u64, u64)> {
        let walls = walls(scene);
        walls.first().map(|one| (walls.len() as u64, one.ticks() + 1))
    }

    /// The trade-off of `comparison` with its `entrants`; `watch` receives how many more ticks are done. None for a
    /// scene without a wall, or whose runs are too short to judge.
    ///
    /// # Errors
    /// Those of [`Comparison::watched`].
    pub fn of<V: Space>(
        comparison: &Comparison,
        entrants: &Entrants<V>,
        watch: &Watch<'_>,
    ) -> Result<Option<Self>, CompareError> {
        let walls = walls(&comparison.scene);
        if walls.is_empty() {
            return Ok(None);
        }
        let error = |number: usize, scene: &Scene| {
            let entrant = &entrants.entries()[number];
            let quiet = |_| watch(0);
            let run = EntrantRun::of(scene, entrant, &quiet);
            let refused = |reason| CompareError::of(reason, &entrant.name, &comparison.name, scene);
            let run = run.map_err(refused)?;
            match watch(scene.ticks() + 1) {
                ControlFlow::Break(()) => Err(CompareError::Stopped),
                // A wall that is never touched counts as bounded, and has no error to compare.
                ControlFlow::Continue(()) if run.score.verdict.is_bounded() => {
                    Ok(Some(run.score.force_error.unwrap_or(f64::NAN)))
                }
                ControlFlow::Continue(()) => Ok(None),
            }
        };
        let of_wall = |scene: &Scene| -> Result<Vec<Option<f64>>, CompareError> {
            comparison.outcomes.iter().map(|outcome| error(outcome.number, scene)).collect()
        };
        let errors: Result<Vec<_>, _> = walls.par_iter().map(of_wall).collect();
        let names = comparison.scores().map(|score| score.stabilizer.clone()).collect();
        let title = format!("{}: {}", file_name(&comparison.name), range(&walls));
        let saturated = saturated(&comparison.scene);
        Ok(Some(Self { saturated, ..Self::told(title, names, &errors?) }))
    }

    /// The trade-off from the force errors of all entrants, wall by wall; an error is none where the run is not bounded.
    fn told(title: String, names: Vec<String>, errors: &[Vec<Option<f64>>]) -> Self {
        let bounded = |index: usize| errors.iter().filter(|wall| wall[index].is_some()).count();
        let held: Vec<usize> = (0..names.len()).map(bounded).collect();
        let is_nobody = |index: usize| names[index] == BasicName::NoStabilizer.name();
        let counts = |index: usize| held[index] > 0 && !is_nobody(index);
        // Where `none` is bounded too, no stabilizer shows its cost.
        let agrees = |wall: &[Option<f64>], index: usize| match wall[index] {
            Some(error) => !is_nobody(index) && error.is_finite(),
            None => !counts(index),
        };
        let is_common = |wall: &&Vec<Option<f64>>| {
            let all = 0..names.len();
            all.clone().any(counts) && all.clone().all(|index| agrees(wall, index))
        };
        let common: Vec<&Vec<Option<f64>>> = errors.iter().filter(is_common).collect();
        let rows = names.iter().enumerate().map(|(index, name)| {
            let own = common.iter().filter_map(|wall| wall[index]);
            let middle = counts(index).then(|| median(own)).flatten();
            (name.clone(), held[index], middle)
        });
        let alone = (0..names.len()).find(|index| is_nobody(*index)).map(|index| held[index]);
        let (walls, common) = (errors.len(), common.len());
        let mut bounded = errors.iter().flatten().flatten().peekable();
        let is_untouched = bounded.peek().is_some() && bounded.all(|error| error.is_nan());
        Self { title, rows: rows.collect(), walls, common, alone, is_untouched, saturated: None }
    }

    /// The remarks that the figure needs, without the last full stop.
    pub fn note(&self) -> Option<String> {
        let saturated = self.saturated.as_ref().map(|it| format!("Note: {it}"));
        let notes: Vec<String> = self.lack().into_iter().chain(saturated).collect();
        (!notes.is_empty()).then(|| notes.join(". "))
    }

    /// The reason why there are no common walls, or few; none where there are enough.
    fn lack(&self) -> Option<String> {
        let Self { walls, common, is_untouched, .. } = *self;
        let is_nobody = |name: &str| name == BasicName::NoStabilizer.name();
        if self.rows.iter().all(|(name, ..)| is_nobody(name)) {
            return Some("No wall is common: no stabilizer takes part".to_owned());
        }
        let alone = self.alone.filter(|alone| *alone > 0);
        let left_out = alone.map_or_else(String::new, |alone| {
            format!("; {alone} of {walls} are bounded without a stabilizer and left out")
        });
        match (common, alone) {
            (0, Some(alone)) if alone == walls => {
                let why = "all are bounded without a stabilizer, and none shows what one costs";
                Some(format!("No wall is common: {why}"))
            }
            (0, _) if is_untouched => {
                Some(format!("No wall is common: no bounded run touches its wall{left_out}"))
            }
            (0, alone) => {
                let none = if alone.is_some() { "no other" } else { "none" };
                Some(format!(
                    "No wall is common: {none} is bounded under all stabilizers{left_out}"
                ))
            }
            (common, _) if common < FEW => {
                Some(format!("Common walls: {common} only, whose median says little{left_out}"))
            }
            _ => None,
        }
    }

    /// The rows with the names of those that are equal: the share of bounded walls in percent, and the force error.
    fn drawn(&self) -> Vec<(String, f64, f64)> {
        let mut rows: Vec<(Vec<&str>, usize, Option<f64>)> = Vec::new();
        for (name, bounded, error) in &self.rows {
            match rows.iter_mut().find(|row| (row.1, row.2) == (*bounded, *error)) {
                Some((names, ..)) => names.push(name),
                None => rows.push((vec![name], *bounded, *error)),
            }
        }
        let share = |bounded: usize| 100.0 * bounded as f64 / self.walls as f64;
        let told = rows.into_iter().map(|(names, bounded, error)| {
            (shortened_names(&names, ROOM), share(bounded), error.unwrap_or(f64::NAN))
        });
        told.collect()
    }

    /// A bar for the bounded walls and one for the force error, side by side; equal rows once.
    pub fn figure(&self) -> Figure {
        let rows = self.drawn();
        let names: Vec<String> = rows.iter().map(|(name, ..)| name.clone()).collect();
        let panel = |title: &str, label: &str, colour: usize, of: &dyn Fn(usize) -> f64| {
            let bars = (0..names.len()).map(|row| (0.0, of(row), -(row as f64)));
            Panel::new(title, label, "")
                .with_series(Series::bars("", colour, &bars.collect::<Vec<_>>()))
                .with_rows(names.clone())
        };
        let (share, error) = (|row: usize| rows[row].1, |row: usize| rows[row].2);
        let shares =
            panel(&format!("settles or swings, of {} walls", self.walls), "share, %", 0, &share);
        let title = match self.alone {
            Some(alone) if alone == self.walls => {
                "force error: all walls hold without a stabilizer".to_owned()
            }
            _ => format!("force error, common walls: {}", self.common),
        };
        let errors = panel(&title, "force error, N rms, median", 1, &error);
        let height = (ROW * names.len() as f64).max(3.0 * ROW);
        Figure::new(self.title.clone())
            .with_width(960.0)
            .with_columns(2)
            .with_panel_height(height)
            .with_panel(shares.with_x_range(0.0, 100.0))
            .with_panel(if self.common == 0 { errors.with_x_range(0.0, 1.0) } else { errors })
    }

    /// The trade-off as comma-separated values.
    pub fn csv(&self) -> String {
        let records = self.rows.iter().map(|(name, bounded, error)| {
            let [bounded, walls, common] = [*bounded, self.walls, self.common].map(Field::Count);
            [Field::Text(name), bounded, walls, common, (*error).into()]
        });
        csv::text(
            ["stabilizer", "bounded_walls", "walls", "common_walls", "force_error_rms_n"],
            records,
        )
    }
}

/// The first and the last wall, in words.
fn range(walls: &[Scene]) -> String {
    let of = |scene: &Scene| {
        let wall = scene.environment.wall();
        wall.map_or([0.0; 2], |wall| [wall.stiffness.get(), wall.damping.get()])
    };
    let [first, last] = [&walls[0], &walls[walls.len() - 1]].map(of);
    format!(
        "walls of {} to {} N/m by 0 to {} N.s/m, {} s at {} Hz",
        found(first[0]),
        found(last[0]),
        found(last[1]),
        given(walls[0].duration.get()),
        given(walls[0].servo_rate.get())
    )
}

/// The scene with each of the walls, its run cut to [`MOST`] ticks; empty if it has none, or if that is too short to judge.
fn walls(scene: &Scene) -> Vec<Scene> {
    let Some(&own) = scene.environment.wall() else { return Vec::new() };
    let period = scene.period() * scene.environment_ratio() as f64;
    let (stiffness, damping) = (own.stiffness.get(), scene.port_mass() / period);
    let last = (VALUES - 1) as f64;
    let longest = MOST as f64 / scene.servo_rate.get();
    let duration = Positive::new(scene.duration.get().min(longest));
    let with = |index: usize| {
        let [row, column] = [index / VALUES, index % VALUES].map(|it| it as f64 / last);
        let stiffness = stiffness * libm::pow(SPREAD, 2.0 * column - 1.0);
        let mut wall = own;
        wall.stiffness = NonNegative::new(stiffness).ok()?;
        wall.damping = NonNegative::new(damping * row).ok()?;
        let mut with = scene.to_draft();
        with.environment = Environment::Wall(wall);
        with.duration = duration.ok()?;
        with.check().ok().filter(|scene| Criterion::of(scene).shortage.is_none())
    };
    if stiffness > 0.0 { (0..VALUES * VALUES).filter_map(with).collect() } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The trade-off of `names` on walls with these errors.
    fn of(names: &[&str], errors: &[&[Option<f64>]]) -> TradeOff {
        let names = names.iter().map(|name| (*name).to_owned()).collect();
        let errors: Vec<_> = errors.iter().map(|wall| wall.to_vec()).collect();
        TradeOff::told("walls".to_owned(), names, &errors)
    }

    #[test]
    fn walls_that_are_not_common_have_their_reason() {
        let names = ["none", "popc"];
        let note = |errors: &[&[Option<f64>]]| of(&names, errors).note().unwrap_or_default();
        let (held, grows) = (Some(0.5), None);
        assert!(note(&[&[held, held], &[held, held]]).contains("all are bounded without"));
        let some = note(&[&[held, held], &[grows, grows]]);
        assert!(some.contains("no other is bounded under all stabilizers"), "{some}");
        assert!(some.contains("1 of 2 are bounded without"), "{some}");
        assert!(note(&[&[grows, held], &[held, held]]).contains("Common walls: 1 only"));
        let untouched = Some(f64::NAN);
        assert!(note(&[&[grows, untouched], &[grows, untouched]]).contains("touches its wall"));
        let alone = of(&["popc"], &[&[grows], &[grows]]).note().unwrap();
        assert!(alone.contains("none is bounded under all"), "{alone}");
        assert!(of(&["none"], &[&[held]]).note().unwrap().contains("no stabilizer takes part"));
        let wall: &[Option<f64>] = &[grows, held];
        assert_eq!(of(&names, &[wall; FEW]).note(), None);
    }

    #[test]
    fn a_saturation_is_told_beside_the_other_remarks() {
        let saturated = Some("a limit".to_owned());
        let note = |wall: [Option<f64>; 2], count: usize| {
            let told = of(&["none", "popc"], &vec![&wall[..]; count]);
            TradeOff { saturated: saturated.clone(), ..told }.note().unwrap()
        };
        assert_eq!(note([None, Some(0.5)], FEW), "Note: a limit");
        let both = note([None, Some(0.5)], 1);
        assert!(both.starts_with("Common walls: 1 only") && both.ends_with(". Note: a limit"));
    }

    #[test]
    fn equal_rows_are_drawn_once() {
        let walls: [&[Option<f64>]; 2] = [&[Some(0.5); 3], &[None, Some(0.5), Some(0.5)]];
        let drawn = of(&["slow", "popc", "lolc-spring"], &walls).drawn();
        let drawn: Vec<_> = drawn.iter().map(|(name, share, _)| (&name[..], *share)).collect();
        assert_eq!(drawn, [("slow", 50.0), ("popc = lolc-spring", 100.0)]);
    }
}
