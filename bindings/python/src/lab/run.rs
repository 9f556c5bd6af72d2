//! One run of a scene.

use std::ops::ControlFlow;
use std::sync::Arc;

use lyapunov_lab::explain::Hint;
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::run::Curves;
use lyapunov_lab::{Rollout, Space, Summary, in_space, in_space_of, row_numbers, scene as lab};
use pyo3::prelude::*;

use super::rows::Rows;
use super::work::{Fault, Watched, wait_asking};
use super::{Scene, Told};
use crate::axes::Axes;
use crate::blocks::{Asker, PythonStabilizer, Raised, Stabilizer};
use crate::errors;
use crate::number;

/// Ticks between two looks at whether to go on.
const BREATH: u64 = 1 << 12;

/// Who stabilizes a run.
enum By {
    /// The table of the scene.
    Scene,
    Name(StabilizerName),
    /// An object with a method `stabilize(sample, effort)`.
    Python(Py<PyAny>),
}

/// One run: its summary, and the rows of docs/contract.md if they are asked for.
#[pyfunction]
#[pyo3(signature = (scene, stabilizer=None, rows=true, progress=None))]
pub(crate) fn run(
    py: Python<'_>,
    scene: &Bound<'_, Scene>,
    stabilizer: Option<&Bound<'_, PyAny>>,
    #[pyo3(from_py_with = number::rows)] rows: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    let Scene { scene, name } = scene.get().clone();
    let by = match stabilizer {
        None => By::Scene,
        Some(given) => match given.extract::<String>() {
            Ok(name) => By::Name(name.parse().map_err(errors::input)?),
            Err(_) => {
                PythonStabilizer::check(given, "stabilizer")?;
                By::Python(given.clone().unbind())
            }
        },
    };
    wait_asking(py, progress, scene.ticks(), move |watched| {
        let rows = Rows::of(&scene, rows)?;
        told(&scene, &name, &by, rows, watched)
    })
}

fn told(
    scene: &lab::Scene,
    name: &str,
    by: &By,
    rows: Rows,
    watched: &Watched,
) -> Result<Told, Fault> {
    match by {
        By::Scene => {
            in_space!(scene, Own => {
                let rollout = Rollout::<Own>::of(scene).map_err(Fault::input)?;
                drain(scene, name, rollout, rows, watched)
            })
        }
        By::Name(who) => {
            who.check_axes(scene).map_err(Fault::input)?;
            // The summary tells the table that ran.
            let told = who.written_in(scene, &[]).map_err(Fault::input)?;
            in_space!(scene, Own => {
                let rollout = Rollout::<Own>::under(scene, *who).map_err(Fault::input)?;
                drain(&told, name, rollout, rows, watched)
            })
        }
        By::Python(object) => {
            in_f64(scene, name)?;
            let who = Python::try_attach(|py| who(object.bind(py))).ok_or(Fault::Stopped)??;
            let (raised, stopped) = (Raised::default(), watched.stop());
            let run = Asker { about: about(&who, name), raised, stopped };
            let told = in_space_of!(f64, scene, V => {
                drain(scene, name, foreign::<V>(scene, object, who, &run)?, rows, watched)
            });
            run.raised.check()?;
            told
        }
    }
}

/// The stabilizer `who` on the scene called `name`, for errors.
pub(super) fn about(who: &str, name: &str) -> Arc<str> {
    format!("the stabilizer {who} on the scene {name}").into()
}

/// Checks that a stabilizer written in Python can run in `scene`, called `name`.
pub(super) fn in_f64(scene: &lab::Scene, name: &str) -> Result<(), Fault> {
    match scene.scalar {
        lab::Scalar::F64 => Ok(()),
        lab::Scalar::F32 => Err(Fault::input(format_args!(
            "{name}: a stabilizer written in Python runs in f64\n  = leave `scalar` out of the scene"
        ))),
    }
}

/// The loop of `scene` under an object of Python, which reports call by what it is.
fn foreign<V: Space + Axes>(
    scene: &lab::Scene,
    object: &Py<PyAny>,
    who: String,
    run: &Asker,
) -> Result<Rollout<V>, Fault> {
    let made = Python::try_attach(|py| PythonStabilizer::of(object.bind(py), run.clone()));
    let made = made.ok_or(Fault::Stopped)??;
    Ok(Rollout::stabilized_by(scene, made).map_err(Fault::input)?.called(who))
}

/// The name of an object in reports: a block with its numbers, or its class.
fn who(object: &Bound<'_, PyAny>) -> PyResult<String> {
    match object.cast::<Stabilizer>() {
        Ok(block) => Ok(block.repr()?.to_string()),
        Err(_) => Ok(object.get_type().name()?.to_string()),
    }
}

/// All that a rollout tells.
fn drain<V: Space>(
    scene: &lab::Scene,
    name: &str,
    rollout: Rollout<V>,
    mut rows: Rows,
    watched: &Watched,
) -> Result<Told, Fault> {
    let (mut summary, mut curves) = (Summary::under(scene, &rollout), Curves::new(scene));
    for tick in rollout {
        // The first tick is at 0 s, and is not counted in the total.
        let done = if summary.rows == 0 { 0 } else { BREATH };
        if summary.rows.is_multiple_of(BREATH) && watched.add(done) == ControlFlow::Break(()) {
            return Err(Fault::Stopped);
        }
        rows.add(row_numbers(&tick));
        summary.add(&tick);
        curves.add(&tick, &summary);
    }
    Ok(Told {
        json: summary.to_json(name),
        text: format!("{name}\n{summary}\n{}", Hint::of(&summary)),
        figures: vec![curves.figure(name, &summary).to_svg()],
        columns: rows.columns().into(),
        ..Told::default()
    })
}
