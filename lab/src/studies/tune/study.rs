//! Tuning of one stabilizer on one scene.

use std::fmt;
use std::ops::{ControlFlow, Range};

use lyapunov::ParameterError;
use rayon::prelude::*;

use super::cost::costs;
use super::objective::{Objective, Term};
use super::search::Search;
use super::setting::Setting;
use super::trial::Trial;
use crate::files::Scene;
use crate::files::scene::Conflict;
use crate::simulate::Criterion;
use crate::simulate::ensemble::{Ensemble, Moves};
use crate::simulate::family::{StabilizerName, StabilizerNames};
use crate::studies::chance::is_uneven;

/// Reason why a stabilizer is not tuned.
#[derive(Clone, Debug, PartialEq)]
pub enum TuneError {
    /// The objective has a term that the scene has no number for.
    Objective {
        /// The term.
        term: Term,
        /// What the scene lacks.
        lacks: &'static str,
        /// The terms that it has a number for.
        others: Vec<Term>,
    },
    /// A stabilizer for one dimension on a scene in a space.
    Axes(Conflict),
    /// A moved number that the scene does not allow.
    Member(Conflict),
    /// None of these stabilizers has a number to tune.
    NoNumbers(StabilizerNames),
    /// A number out of the range of the scalar.
    Parameter(ParameterError),
    /// The caller stopped it.
    Stopped,
}

impl fmt::Display for TuneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Objective { term, lacks, others } => {
                write!(
                    f,
                    "the objective `{}` needs {lacks}, which the scene has not\n  = ",
                    term.name()
                )?;
                match &others.iter().map(|other| other.name()).collect::<Vec<_>>()[..] {
                    [] => write!(f, "there is no objective for it: compare its stabilizers"),
                    names => write!(f, "take another objective: {}", names.join(", ")),
                }
            }
            Self::Axes(conflict) => {
                write!(f, "{}\n  = {}", conflict.problem(), conflict.remedy())
            }
            Self::Member(conflict) => write!(f, "a scene of the ensemble is none: {conflict}"),
            Self::NoNumbers(names) => write!(
                f,
                "nothing to tune: no number of {names} has a range to search here\n  \
                 = name a stabilizer with numbers, such as popc; docs/family.md lists them"
            ),
            Self::Parameter(error) => error.fmt(f),
            Self::Stopped => f.write_str("tuning was stopped"),
        }
    }
}

impl std::error::Error for TuneError {}

impl From<Conflict> for TuneError {
    fn from(conflict: Conflict) -> Self {
        Self::Member(conflict)
    }
}

/// Callback that learns how many more runs are done, and says whether to go on.
pub type Watch<'a> = dyn Fn(u64) -> ControlFlow<()> + Sync + 'a;

/// Conditions of a tuning, the same for every stabilizer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// The goal.
    pub objective: Objective,
    /// Trials of each stabilizer, besides that of its default.
    pub trials: u32,
    /// Runs of each trial: the members of the ensemble that tuning sees.
    pub runs: u32,
    /// Seed of the ensemble.
    pub seed: u64,
    /// The share by which the numbers of the scene move in it.
    pub moves: Moves,
}

impl Default for Tuning {
    fn default() -> Self {
        let objective = Objective::default();
        Self { objective, trials: 48, runs: 16, seed: 1, moves: Moves::default() }
    }
}

/// The most runs that a thread takes at once: two groups of lanes, of which one computes while the other waits.
const SHARE: usize = 16;

/// Members that tuning never sees, for each that it does.
const JUDGES: u64 = 2;

/// Number of the first member that tuning never sees: more than it ever does.
const UNSEEN: u64 = 1 << 32;

/// A stabilizer as the scene sets it and as it was tuned.
#[derive(Clone, Debug)]
pub struct Tuned {
    /// The stabilizer.
    pub name: StabilizerName,
    /// The numbers that were tuned: as the scene sets them, then tuned.
    pub settings: [Setting; 2],
    /// The scene with the tuned stabilizer, ready to run.
    pub scene: Scene,
    /// Runs of each setting on the members that tuning never saw.
    pub judged: [Trial; 2],
    /// The best trial on the members that tuning saw.
    pub seen: Trial,
}

impl Tuning {
    /// The number of runs that a stabilizer takes at most, with judging.
    pub fn rollouts(&self) -> u64 {
        let (trials, runs) = (u64::from(self.trials), u64::from(self.runs));
        runs * (trials + 1) + 2 * runs * JUDGES
    }

    /// The moves that the runs of the `tuned` stabilizers, which share a scene, made.
    pub(super) fn moved(&self, tuned: &[Tuned]) -> Moves {
        tuned.first().map_or(self.moves, |one| self.moves.of(&one.scene))
    }

    /// Checks that one of `names` has a number to tune on `scene`.
    ///
    /// # Errors
    /// [`TuneError::NoNumbers`].
    pub fn check(names: &StabilizerNames, scene: &Scene) -> Result<(), TuneError> {
        let searched = |name: &StabilizerName| {
            name.parameters(scene).iter().any(|parameter| parameter.search.is_some())
        };
        match names.iter().any(searched) {
            true => Ok(()),
            false => Err(TuneError::NoNumbers(names.clone())),
        }
    }

    /// Tunes `name` on `scene`.
    ///
    /// # Errors
    /// A scene that the objective, the ensemble or the stabilizer does not fit; an end asked for by `watch`.
    pub fn of(
        &self,
        scene: &Scene,
        name: StabilizerName,
        watch: &Watch<'_>,
    ) -> Result<Tuned, TuneError> {
        self.fits(scene)?;
        name.check_axes(scene).map_err(TuneError::Axes)?;
        let default = Setting::of(scene, name);
        let runs = u64::from(self.runs);
        let run = |settings: &[Setting]| self.trials(scene, settings, 0..runs, watch);
        let mut best = (default.clone(), run(std::slice::from_ref(&default))?.remove(0));
        let mut search = Search::from(default.place(), self.trials as usize);
        while let Some(places) = search.next(&best.0.place()) {
            let settings: Vec<Setting> = places.iter().map(|place| default.at(place)).collect();
            let trials = run(&settings)?;
            for (setting, trial) in settings.into_iter().zip(trials) {
                if trial.is_better_than(&best.1) {
                    best = (setting, trial);
                }
            }
        }
        let (tuned, seen) = best;
        let settings = [default, tuned];
        let unseen = UNSEEN..UNSEEN + JUDGES * runs;
        let mut judged = self.trials(scene, &settings, unseen, watch)?;
        let judged = [judged.remove(0), judged.remove(0)];
        let [default, tuned] = settings;
        let ready = tuned.on(scene)?;
        Ok(Tuned { name, settings: [default, tuned], scene: ready, judged, seen })
    }

    /// The runs of each of `settings` on these `members` of the ensemble, all at once.
    fn trials(
        &self,
        scene: &Scene,
        settings: &[Setting],
        members: Range<u64>,
        watch: &Watch<'_>,
    ) -> Result<Vec<Trial>, TuneError> {
        let (ensemble, runs) =
            (Ensemble { seed: self.seed, moves: self.moves }, members.clone().count());
        let told: Vec<Option<Scene>> = settings.iter().map(|it| it.on(scene).ok()).collect();
        let each = told
            .iter()
            .flatten()
            .flat_map(|told| members.clone().map(move |member| (told, member)));
        let pairs: Vec<(&Scene, u64)> = each.collect();
        let share = pairs.len().div_ceil(rayon::current_num_threads()).clamp(1, SHARE);
        let some = |pairs: &[(&Scene, u64)]| {
            let member = |(told, member): &(&Scene, u64)| ensemble.member(told, *member);
            let scenes: Vec<Scene> = pairs.iter().map(member).collect::<Result<_, _>>()?;
            let told: Vec<Scene> = pairs.iter().map(|(told, _)| (*told).clone()).collect();
            costs(&scenes, &told, &self.objective, watch)
        };
        let ran: Result<Vec<Vec<_>>, TuneError> = pairs.par_chunks(share).map(some).collect();
        let mut ran = ran?.into_iter().flatten();
        let trial = |told: &Option<Scene>| match told {
            Some(_) => Trial::of(ran.by_ref().take(runs).collect()),
            None => Trial::refused(runs),
        };
        Ok(told.iter().map(trial).collect())
    }

    /// Refuses a scene that the objective says nothing about.
    fn fits(&self, scene: &Scene) -> Result<(), TuneError> {
        let has_rest = Criterion::of(scene).place().is_some();
        let has_wall = scene.environment.surface_stiffness().is_some();
        let needs = |term| match term {
            Term::Settling => (has_rest, "a place where the motion comes to rest"),
            Term::ForceError | Term::Stiffness => (has_wall, "a wall or a solid"),
        };
        let Some(term) = self.objective.terms().find(|term| !needs(*term).0) else {
            return Ok(());
        };
        let others = Term::ALL.into_iter().filter(|other| needs(*other).0).collect();
        Err(TuneError::Objective { term, lacks: needs(term).1, others })
    }
}

impl Tuned {
    /// The change of the mean cost from the setting of the scene to the tuned one, on the runs that tuning never saw.
    pub fn change(&self) -> Change {
        let [default, tuned] = &self.judged;
        Change::between(default, tuned)
    }

    /// The text of the scene with the tuned stabilizer, TOML with every default in place.
    ///
    /// # Errors
    /// None: every scene that was read can be written.
    pub fn text(&self) -> Result<String, toml::ser::Error> {
        toml::to_string(&self.scene)
    }

    /// The best of `all` with which every judged run stayed bounded, else the one with the most bounded runs.
    pub fn best(all: &[Self]) -> Option<&Self> {
        all.iter().reduce(
            |best, one| {
                if one.judged[1].is_better_than(&best.judged[1]) { one } else { best }
            },
        )
    }

    /// The others of `all` whose judged runs are not worse than this one's by more than chance explains.
    pub(super) fn level(&self, all: &[Self]) -> Vec<StabilizerName> {
        let others = all.iter().filter(|other| other.name != self.name);
        let level =
            |other: &&Self| Change::between(&self.judged[1], &other.judged[1]) != Change::Worse;
        others.filter(level).map(|other| other.name).collect()
    }
}

/// Comparison of a tuned setting with the scene's, on the runs that tuning never saw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// More runs stay bounded than chance explains; or no fewer do, at a cost whose 95 % interval lies below.
    Better,
    /// Fewer runs stay bounded than chance explains; or no more do, at a cost whose 95 % interval lies above.
    Worse,
    /// Neither: it may be chance, or what the cost gains the bounded runs may lose.
    Undecided,
}

impl Change {
    fn between(default: &Trial, tuned: &Trial) -> Self {
        let more = tuned.bounded_only_here(default);
        let fewer = default.bounded_only_here(tuned);
        if is_uneven(more, fewer) {
            return if more > fewer { Self::Better } else { Self::Worse };
        }
        match tuned.change_from(default) {
            Some((change, half)) if change + half < 0.0 && more >= fewer => Self::Better,
            Some((change, half)) if change - half > 0.0 && more <= fewer => Self::Worse,
            _ => Self::Undecided,
        }
    }

    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Better => "better",
            Self::Worse => "worse",
            Self::Undecided => "no difference",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::trial::Outcome;
    use super::*;

    /// A trial of runs at `costs`, and of more of them that grow.
    fn trial(costs: &[f64], grow: usize) -> Trial {
        let bounded = costs.iter().copied().map(Outcome::Settles);
        Trial::of(bounded.chain(std::iter::repeat_n(Outcome::Grows, grow)).collect())
    }

    #[test]
    fn a_difference_in_bounded_runs_counts_from_six_runs_on() {
        for (runs, change) in [(1, Change::Undecided), (5, Change::Undecided), (6, Change::Better)]
        {
            assert_eq!(
                Change::between(&trial(&[], 8), &trial(&[1.0; 8][..runs], 8 - runs)),
                change
            );
        }
        // A cost that rises in the two runs that are bounded in both does not matter then.
        let (none, all) = (trial(&[1.0, 1.1], 6), trial(&[3.0; 8], 0));
        assert_eq!(Change::between(&none, &all), Change::Better);
        assert_eq!(Change::between(&all, &none), Change::Worse);
    }

    /// The mean of the changes is -1.5 and its error 0.5, so the interval with the factor of one degree of freedom, 12.7, holds 0,
    /// though that with the normal one, 1.96, would not. Of four such changes the error is 1 / sqrt 12 and the factor 3.18.
    #[test]
    fn a_change_of_two_runs_is_less_than_one_of_four() {
        let (before, after) = ([5.0; 4], [4.0, 3.0, 4.0, 3.0]);
        let of = |runs: usize| [trial(&before[..runs], 0), trial(&after[..runs], 0)];
        let ([few, fewer], [some, less]) = (of(2), of(4));
        assert_eq!(Change::between(&few, &fewer), Change::Undecided);
        assert_eq!(Change::between(&some, &less), Change::Better);
        assert_eq!(Change::between(&less, &some), Change::Worse);
        assert_eq!(Change::between(&trial(&[2.0], 0), &trial(&[1.0], 0)), Change::Undecided);
    }

    /// Cheaper where both are bounded, and one run fewer is: neither better nor worse.
    #[test]
    fn what_costs_a_bounded_run_is_not_better_for_its_cost() {
        let (all, cheap) = (trial(&[5.0, 5.0, 5.0, 5.0, 5.0], 0), trial(&[3.9, 4.0, 4.1, 4.0], 1));
        assert_eq!(Change::between(&all, &cheap), Change::Undecided);
        assert_eq!(Change::between(&cheap, &all), Change::Undecided);
    }
}
