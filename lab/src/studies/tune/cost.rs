//! Costs of runs, on lanes where those are alike.

use lyapunov::Signal;

use super::objective::{Objective, Term};
use super::study::{TuneError, Watch};
use crate::files::Scene;
use crate::measure::runs::{Instant, Judged, Meter, Metering, Ran, Runs};
use crate::measure::{ForceError, Settling, StiffnessFelt, Verdict};
use crate::simulate::Instructions;

/// Cost of a run that stays bounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cost {
    pub(super) value: f64,
    /// Whether it settles: one that does not costs its duration, which looks like a time of settling.
    pub(super) settles: bool,
}

/// The cost of the run of each of `scenes` under the stabilizer of its `told`, which knows the numbers of `told` only;
/// none where it grows or cannot be judged.
pub(super) fn costs(
    scenes: &[Scene],
    told: &[Scene],
    objective: &Objective,
    watch: &Watch<'_>,
) -> Result<Vec<Option<Cost>>, TuneError> {
    let tables: Vec<_> = told.iter().map(|told| told.stabilizer).collect();
    let instructions = Some(Instructions::best());
    let runs = Runs { scenes, told, tables: &tables, instructions };
    // Progress is counted in runs.
    let judged = runs.measured::<Terms>(&|| watch(0).is_continue());
    let judged = judged.map_err(|(_, error)| TuneError::Parameter(error))?;
    let judged = judged.ok_or(TuneError::Stopped)?;
    if watch(scenes.len() as u64).is_break() {
        return Err(TuneError::Stopped);
    }
    let cost = |(judged, scene): (&Judged<Read>, &Scene)| {
        let read = judged.reading.filter(|_| judged.verdict.is_bounded())?;
        let settles = judged.verdict == Verdict::Settles;
        let value = objective.of(Term::ALL.map(|term| match term {
            Term::Settling => {
                read.settling_time.filter(|_| settles).unwrap_or(scene.duration.get())
            }
            Term::ForceError => read.force_error.unwrap_or(0.0),
            Term::Stiffness => (100.0 - read.stiffness_percent.unwrap_or(0.0)).max(0.0),
        }));
        Some(Cost { value, settles })
    };
    Ok(judged.iter().zip(scenes).map(cost).collect())
}

/// The numbers that the terms of an objective are about.
struct Terms;

impl Metering for Terms {
    type Reading = Read;
    type Meter<V: Signal> = Meters<V>;
}

/// What was measured along a run, by [`Term`].
#[derive(Clone, Copy, Debug)]
struct Read {
    settling_time: Option<f64>,
    force_error: Option<f64>,
    stiffness_percent: Option<f64>,
}

struct Meters<V: Signal> {
    settling: Settling<V::Scalar>,
    force_error: ForceError<V>,
    stiffness_felt: StiffnessFelt<V::Scalar>,
}

impl<V: Signal> Meter<V> for Meters<V> {
    type Reading = Read;

    fn new(rate: f64, _damper: V::Scalar, (rest, band): (V::Scalar, V::Scalar)) -> Self {
        Self {
            settling: Settling::new(rest, band),
            force_error: ForceError::new(),
            stiffness_felt: StiffnessFelt::new(rate),
        }
    }

    #[inline(always)]
    fn add(&mut self, at: &Instant<V>) {
        let ([_, environment], [depth, against]) = (at.magnitudes, at.pressed);
        self.settling.add(at.coordinate);
        self.force_error.add(at.applied, at.ideal, environment, depth);
        self.stiffness_felt.add(against, environment, depth);
    }

    fn read(&self, lane: usize, ran: Ran) -> Read {
        let told = |value: f64| Some(value).filter(|value| value.is_finite());
        let felt = self.stiffness_felt.stiffness(lane).zip(ran.stiffness);
        Read {
            settling_time: self.settling.since(lane).map(|tick| tick / ran.rate),
            force_error: self.force_error.root_mean_square(lane).and_then(told),
            stiffness_percent: felt.and_then(|(felt, asked)| told(100.0 * felt / asked)),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;
    use crate::simulate::ensemble::{Ensemble, Moves};
    use crate::simulate::family::StabilizerName;
    use crate::studies::compare::{Score, score_under};

    /// Two groups of lanes, of which one is not full.
    const MEMBERS: u64 = 11;

    /// A hand that comes to rest in a wall.
    const PRESS: &str = "duration = 3.0\nservo_rate = 500.0\nenvironment_rate = 100.0\n\
        operator = { mass = 0.1, damping = 0.6, stiffness = 50.0, rest = 0.01 }\n\
        device = { mass = 0.2, damping = 0.01 }\ninitial.position = -0.004\n\
        effects.encoder.resolution = 1e-5\neffects.delay.ticks = 1\n\
        effects.noise = { deviation = 1e-6, seed = 7 }\n\
        environment.wall = { stiffness = 1000.0, damping = 2.0 }\n\
        stabilizer.popc.damping_cap = 0.1\n";

    fn on_lanes(scenes: &[Scene], objective: &str) -> Vec<Option<f64>> {
        let objective = objective.parse().unwrap();
        let costs = costs(scenes, scenes, &objective, &|_| ControlFlow::Continue(())).unwrap();
        costs.into_iter().map(|cost| cost.map(|it| it.value)).collect()
    }

    #[test]
    fn lanes_feel_what_single_runs_of_a_comparison_feel() {
        let scene = Scene::parse(PRESS, "press").unwrap();
        let ensemble = Ensemble { seed: 3, moves: Moves::default() };
        let members = (0..MEMBERS).map(|member| ensemble.member(&scene, member).unwrap());
        let members: Vec<Scene> = members.collect();
        let popc: StabilizerName = "popc".parse().unwrap();
        let alone =
            |scene: &Scene| score_under(scene, popc, &|_| ControlFlow::Continue(())).unwrap();
        let scores: Vec<_> = members.iter().map(alone).collect();
        assert!(scores.iter().any(|score| score.stiffness_percent.is_some()));
        let bounded = |score: &Score, cost: f64| score.verdict.is_bounded().then_some(cost);
        let errors = scores.iter().map(|it| bounded(it, it.force_error.unwrap_or(0.0)));
        assert_eq!(on_lanes(&members, "force-error"), errors.collect::<Vec<_>>());
        let lacking = |it: f64| (100.0 - it).max(0.0);
        let felt =
            scores.iter().map(|it| bounded(it, lacking(it.stiffness_percent.unwrap_or(0.0))));
        assert_eq!(on_lanes(&members, "stiffness"), felt.collect::<Vec<_>>());
    }
}
