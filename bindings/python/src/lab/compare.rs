//! Comparison of stabilizers.

use std::sync::Arc;

use lyapunov::ParameterError;
use lyapunov_lab::compare::{Column, CompareError, Comparison, Entrants, csv, document};
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::{Space, in_space, in_space_of, scene as lab};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyMapping;

use super::columns::{Columns, Kinds};
use super::run::{about, in_f64};
use super::work::{Fault, Watched, wait_asking};
use super::{Scene, Told};
use crate::axes::Axes;
use crate::blocks::{Asker, PythonStabilizer, Raised};
use crate::errors;

/// An entrant written in Python: its name, and what makes it for a scene.
type Own = (String, Arc<Py<PyAny>>);

/// Stabilizers side by side on the same scenes, with the columns of docs/compare.md. Of several scenes those that do not fit are left
/// out, with the reasons in the JSON.
#[pyfunction]
#[pyo3(signature = (scenes, stabilizers=None, own=None, by=None, progress=None))]
pub(crate) fn compare(
    py: Python<'_>,
    scenes: Vec<Bound<'_, Scene>>,
    stabilizers: Option<&str>,
    own: Option<&Bound<'_, PyAny>>,
    by: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    if scenes.is_empty() {
        return Err(errors::input("there is no scene\n  = give one or more"));
    }
    let scenes: Vec<Scene> = scenes.iter().map(|scene| scene.get().clone()).collect();
    let names = match stabilizers {
        Some(names) => names.parse().map_err(errors::input)?,
        None => StabilizerNames::standard(),
    };
    let column: Option<Column> = by.map(str::parse).transpose().map_err(errors::input)?;
    let entrants = own.map_or_else(|| Ok(Vec::new()), |own| makers(own, &names))?;
    let each = |scene: &Scene| (scene.scene.ticks() + 1) * (names.len() + entrants.len()) as u64;
    let total = scenes.iter().map(each).sum();
    wait_asking(py, progress, total, move |watched| {
        let (mut comparisons, mut left_out) = (Vec::new(), Vec::new());
        for scene in &scenes {
            match compared(scene, &names, &entrants, watched) {
                Ok(one) => comparisons.push(one),
                Err(Fault::Input(reason)) if scenes.len() > 1 => left_out.push(reason),
                Err(fault) => return Err(fault),
            }
        }
        if comparisons.is_empty() {
            return Err(Fault::input(left_out.join("\n")));
        }
        if let Some(column) = column {
            comparisons.iter_mut().for_each(|one| one.sort_by(column));
        }
        let text: Vec<String> = comparisons.iter().map(Comparison::to_string).collect();
        Ok(Told {
            json: document(&comparisons, &left_out),
            text: text.join("\n"),
            figures: comparisons.iter().map(|one| one.figure().to_svg()).collect(),
            columns: scored(&csv(&comparisons))?.into(),
            ..Told::default()
        })
    })
}

/// Makers of stabilizers written in Python, by their names.
fn makers(given: &Bound<'_, PyAny>, names: &StabilizerNames) -> PyResult<Vec<Own>> {
    let Ok(mapping) = given.cast::<PyMapping>() else {
        return Err(PyTypeError::new_err(format!(
            "own is {}; give a dictionary of what makes a stabilizer, such as its class, by name",
            given.get_type().name()?
        )));
    };
    let mut entrants: Vec<Own> = Vec::new();
    for item in mapping.items()? {
        let (name, make): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let Ok(name) = name.extract::<String>() else {
            return Err(PyTypeError::new_err(format!(
                "a name in own is {}, of the type {}; give your own a name, a str",
                name.repr()?,
                name.get_type().name()?
            )));
        };
        if name.trim().is_empty() {
            return Err(errors::input("a name in own is empty\n  = give your own a name"));
        }
        if names.iter().any(|known| known.name() == name) {
            return Err(errors::input(format!(
                "`{name}` is a stabilizer of the family that takes part\n  = give your own another name"
            )));
        }
        if !make.is_callable() {
            return Err(PyTypeError::new_err(format!(
                "own[{name:?}] is {}, which cannot be called; give what makes a fresh stabilizer for each run, such as its class",
                make.get_type().name()?
            )));
        }
        if !takes_one(&make)? {
            return Err(PyTypeError::new_err(format!(
                "own[{name:?}] cannot be called with one argument, the scene of each run; give lambda scene: …, or let it take the scene"
            )));
        }
        entrants.push((name, Arc::new(make.unbind())));
    }
    Ok(entrants)
}

/// Whether `make` may be called with one argument; one whose signature nobody knows may.
fn takes_one(make: &Bound<'_, PyAny>) -> PyResult<bool> {
    let py = make.py();
    let signature = py.import("inspect")?.call_method1("signature", (make,));
    Ok(signature.is_err() || signature?.call_method1("bind", (py.None(),)).is_ok())
}

/// The heading of a column as words on an axis, with its unit.
#[pyfunction]
pub(crate) fn label_of(column: &str) -> PyResult<String> {
    column.parse().map(Column::label).map_err(errors::input)
}

/// The columns of a table of scores, and of the names of scenes in front of it.
pub(super) fn scored(csv: &str) -> PyResult<Columns> {
    let of_scores = Column::ALL.into_iter().filter(|column| column.is_words());
    let words: Vec<&str> = std::iter::once("scene").chain(of_scores.map(Column::key)).collect();
    let kinds = Kinds {
        words: &words,
        judgements: &[Column::BrokeIt.key()],
        wholes: &[Column::StateBytes.key()],
        truths: &[],
    };
    Columns::of_csv(csv, kinds)
}

fn compared(
    Scene { scene, name }: &Scene,
    names: &StabilizerNames,
    own: &[Own],
    watched: &Watched,
) -> Result<Comparison, Fault> {
    if own.is_empty() {
        return in_space!(scene, V => meet(name, scene, Entrants::<V>::of(names.on(scene)), watched));
    }
    in_f64(scene, name)?;
    let raised = Raised::default();
    let asker = |who: &str| Asker {
        about: about(who, name),
        raised: raised.clone(),
        stopped: watched.stop(),
    };
    let met = in_space_of!(f64, scene, V => {
        let entrants = Entrants::of(names.on(scene));
        let entrants = own.iter().fold(entrants, |entrants, own| {
            entered::<V>(entrants, own, name, asker(&own.0))
        });
        meet(name, scene, entrants, watched)
    });
    raised.check()?;
    met
}

/// The entrants, and one of its own on the scene that reports call `on`.
fn entered<V: Space + Axes>(
    entrants: Entrants<V>,
    (name, make): &Own,
    on: &str,
    run: Asker,
) -> Entrants<V> {
    let (make, on) = (Arc::clone(make), on.to_owned());
    entrants.with(name.clone(), move |scene| {
        let scene = Scene { scene: scene.clone(), name: on.clone() };
        Ok::<_, ParameterError>(fresh(&make, scene, &run))
    })
}

/// A stabilizer of its own for a run of the scene.
fn fresh(make: &Py<PyAny>, scene: Scene, run: &Asker) -> PythonStabilizer {
    if run.is_over() {
        return PythonStabilizer::none(run.clone());
    }
    let made = Python::try_attach(|py| {
        let made = make.bind(py).call1((scene,))?;
        PythonStabilizer::check(&made, "what own made")?;
        PythonStabilizer::of(&made, run.clone())
    });
    match made {
        Some(Ok(made)) => made,
        Some(Err(error)) => {
            run.keep(error);
            PythonStabilizer::none(run.clone())
        }
        None => PythonStabilizer::none(run.clone()),
    }
}

fn meet<V: Space>(
    name: &str,
    scene: &lab::Scene,
    entrants: Entrants<V>,
    watched: &Watched,
) -> Result<Comparison, Fault> {
    Comparison::watched(name, scene, &entrants, &|ticks| watched.add(ticks)).map_err(|error| {
        match error {
            CompareError::Stopped => Fault::Stopped,
            error => Fault::input(error),
        }
    })
}
