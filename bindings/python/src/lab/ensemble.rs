//! Ensemble of scenes: each member run, on all cores.

use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::{Ensemble, Moves, Rollout, Summary, in_space, scene as lab};
use pyo3::prelude::*;
use rayon::prelude::*;

use super::columns::{Column, Columns, MOST_ROWS};
use super::work::{Fault, wait};
use super::{Scene, Told};
use crate::errors;
use crate::number;
use crate::whole;

/// The runs of `count` members of an ensemble, from number `first` on.
#[pyfunction]
#[pyo3(signature = (scene, first, count, seed, stabilizer=None, phase=None, mass=None, damping=None, stiffness=None,
    progress=None))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn ensemble(
    py: Python<'_>,
    scene: &Bound<'_, Scene>,
    first: u64,
    #[pyo3(from_py_with = whole::members)] count: u64,
    #[pyo3(from_py_with = whole::seed)] seed: u64,
    stabilizer: Option<&str>,
    #[pyo3(from_py_with = number::phase_if_any)] phase: Option<f64>,
    #[pyo3(from_py_with = number::mass_if_any)] mass: Option<f64>,
    #[pyo3(from_py_with = number::damping_if_any)] damping: Option<f64>,
    #[pyo3(from_py_with = number::stiffness_if_any)] stiffness: Option<f64>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    let who: Option<StabilizerName> =
        stabilizer.map(str::parse).transpose().map_err(errors::input)?;
    if let Some(who) = who {
        who.check_axes(&scene).map_err(errors::input)?;
    }
    let usual = Moves::default();
    let moves = Moves {
        phase: phase.unwrap_or(usual.phase),
        mass: mass.unwrap_or(usual.mass),
        damping: damping.unwrap_or(usual.damping),
        stiffness: stiffness.unwrap_or(usual.stiffness),
    };
    check(&moves)?;
    if count > MOST_ROWS {
        return Err(errors::input(format!(
            "members is {count}; a table has at most {MOST_ROWS} rows, one for each\n  = give fewer, or several calls with a \
             seed of their own"
        )));
    }
    let ensemble = Ensemble { seed, moves };
    wait(py, progress, count, move |watched| {
        let member = |number: u64| {
            if watched.go_on().is_break() {
                return Err(Fault::Stopped);
            }
            let member = ensemble.member(&scene, number);
            let member = member.map_err(|error| Fault::input(format_args!("{name}: {error}")))?;
            let summary = run(&member, who)?;
            // The next member asks whether to go on.
            let _ = watched.add(1);
            Ok(summary)
        };
        let runs = (first..first + count).into_par_iter().map(member);
        let runs = runs.collect::<Result<Vec<_>, Fault>>()?;
        Ok(Told { columns: columns(first, &runs).into(), ..Told::default() })
    })
}

/// Refuses moves that are no shares; that of the phase may be more than one period.
fn check(moves: &Moves) -> PyResult<()> {
    let shares = [
        ("phase", moves.phase, f64::MAX),
        ("mass", moves.mass, 1.0),
        ("damping", moves.damping, 1.0),
        ("stiffness", moves.stiffness, 1.0),
    ];
    shares.into_iter().try_for_each(|(name, share, most)| match (0.0..most).contains(&share) {
        true => Ok(()),
        false if most > 1.0 => Err(errors::input(format!(
            "{name} is {share:?}; it must be periods of the environment, 0 or more and finite"
        ))),
        false => Err(errors::input(format!(
            "{name} is {share:?}; it must be a share below 1, and 0 or more"
        ))),
    })
}

fn run(member: &lab::Scene, who: Option<StabilizerName>) -> Result<Summary, Fault> {
    in_space!(member, Axes => {
        let rollout = match who {
            Some(who) => Rollout::<Axes>::under(member, who),
            None => Rollout::<Axes>::of(member),
        };
        rollout.map(|rollout| Summary::of(member, rollout)).map_err(Fault::input)
    })
}

/// A row for each member.
fn columns(first: u64, runs: &[Summary]) -> Columns {
    let numbers = |name: &str, of: &dyn Fn(&Summary) -> Option<f64>| {
        let numbers = runs.iter().map(|run| of(run).unwrap_or(f64::NAN)).collect();
        (name.to_owned(), Column::Numbers(numbers))
    };
    let members = (first..).take(runs.len()).map(|number| number as i64).collect();
    let verdicts = runs.iter().map(|run| run.verdict().word()).collect();
    Columns(vec![
        ("member".to_owned(), Column::Wholes(members)),
        ("verdict".to_owned(), Column::Words(verdicts)),
        numbers("settling_time_s", &Summary::settling_time),
        numbers("peak_force_environment_n", &|run| Some(run.environment_peak)),
        numbers("peak_force_acting_n", &|run| Some(run.acting_peak)),
        numbers("energy_into_port_mj", &|run| Some(1e3 * run.absorbed)),
        numbers("observed_energy_least_mj", &|run| Some(1e3 * run.observed_energy_least)),
        numbers("energy_asked_for_mj", &Summary::millijoules_asked),
        numbers("shortfall_mj", &|run| Some(1e3 * run.shortfall)),
        numbers("active_percent", &Summary::active_percent),
    ])
}
