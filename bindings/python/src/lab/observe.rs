//! Observation of a recorded log.

use std::io::{BufReader, Cursor, Read};
use std::ops::ControlFlow;
use std::path::PathBuf;

use lyapunov_lab::observe::{
    self as lab, Asked, Candidate, Columns as LogColumns, Scale, Settings,
};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::columns::{Columns, Kinds};
use super::work::{Fault, Watched, wait};
use super::{Scene, Told};
use crate::errors;
use crate::{number, whole, words};

/// The columns of stabilizers on the recorded motion that do not hold numbers.
const REPLAYED: Kinds<'_> = Kinds {
    words: &["stabilizer"],
    wholes: &["ticks", "active_ticks", "rejected"],
    truths: &[],
    judgements: &[],
};

/// The name of a log in memory.
const IN_MEMORY: &str = "log";

/// A recorded log.
enum Source {
    File(PathBuf),
    /// Comma-separated values in memory.
    Text(Vec<u8>),
}

impl Source {
    /// The log that `given` is, and its name: the path of a file, or bytes.
    fn of(given: &Bound<'_, PyAny>) -> PyResult<(Self, String)> {
        if let Ok(text) = given.cast::<PyBytes>() {
            return Ok((Self::Text(text.as_bytes().to_vec()), IN_MEMORY.to_owned()));
        }
        let path: PathBuf = given.extract()?;
        let name = path.display().to_string();
        Ok((Self::File(path), name))
    }

    fn size(&self) -> u64 {
        match self {
            Self::File(path) => std::fs::metadata(path).map_or(0, |it| it.len()),
            Self::Text(text) => text.len() as u64,
        }
    }

    fn opened(self, name: &str) -> Result<Box<dyn Read>, Fault> {
        match self {
            Self::File(path) => {
                let file = lab::opened(&path);
                let file = file.map_err(|error| Fault::input(format_args!("{name}: {error}")))?;
                Ok(Box::new(BufReader::new(file)))
            }
            Self::Text(text) => Ok(Box::new(Cursor::new(text))),
        }
    }
}

/// When a recorded device generated energy, and what stabilizers would have done.
#[pyfunction]
#[pyo3(signature = (log, columns=None, scale=Vec::new(), candidate="spring", damping=None, surface=None, contact=None,
    stabilizers=None, scene=None, late=0, progress=None))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn observe(
    py: Python<'_>,
    log: &Bound<'_, PyAny>,
    columns: Option<&str>,
    scale: Vec<String>,
    candidate: &str,
    #[pyo3(from_py_with = number::damping_if_any)] damping: Option<f64>,
    #[pyo3(from_py_with = number::surface_if_any)] surface: Option<f64>,
    #[pyo3(from_py_with = number::contact_if_any)] contact: Option<f64>,
    stabilizers: Option<&str>,
    scene: Option<&Bound<'_, Scene>>,
    #[pyo3(from_py_with = whole::late)] late: u32,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Told> {
    let columns = columns.map_or_else(|| Ok(LogColumns::default()), str::parse);
    let scales = scale.iter().map(|text| text.parse::<Scale>());
    let asked = asked(stabilizers, scene)?;
    let settings = Settings {
        columns: columns.map_err(errors::input)?,
        scales: scales.collect::<Result<_, _>>().map_err(errors::input)?,
        candidate: Candidate::named(candidate, damping, surface).map_err(errors::input)?,
        contact,
        late,
    };
    let (source, name) = Source::of(log)?;
    let is_file = matches!(source, Source::File(_));
    let told = move |text: String| if is_file { text } else { words::of_rows(&text, IN_MEMORY) };
    wait(py, progress, source.size(), move |watched| {
        let log = Heeding { inner: source.opened(&name)?, watched };
        let observed = match &asked {
            Some(asked) => lab::replay(log, &name, &settings, asked),
            None => lab::observe(log, &name, &settings),
        };
        if watched.go_on() == ControlFlow::Break(()) {
            return Err(Fault::Stopped);
        }
        let observed = observed.map_err(|error| Fault::Input(told(error.to_string())))?;
        let replay = observed.report.replay.as_ref();
        let further = replay.map(|replay| Columns::of_csv(&replay.csv(), REPLAYED)).transpose()?;
        Ok(Told {
            json: observed.report.to_json(),
            text: told(format!("{}\n", observed.report)),
            figures: [Some(observed.figure()), observed.would_have()]
                .into_iter()
                .flatten()
                .map(|figure| figure.to_svg())
                .collect(),
            columns: Columns::of_csv(&observed.csv(), Kinds::default())?.into(),
            further: further.unwrap_or_default().into(),
            ..Told::default()
        })
    })
}

/// The stabilizers to replay the log with, and the scene that sets their numbers.
fn asked(names: Option<&str>, scene: Option<&Bound<'_, Scene>>) -> PyResult<Option<Asked>> {
    match (names, scene) {
        (None, None) => Ok(None),
        (Some(names), Some(scene)) => {
            let stabilizers = names.parse().map_err(errors::input)?;
            let Scene { scene, name } = scene.get().clone();
            Ok(Some(Asked { stabilizers, scene, name }))
        }
        _ => Err(errors::input(
            "stabilizers and scene go together: mass, servo period, delay and environment of the scene set their numbers",
        )),
    }
}

/// A log that counts what is read of it, and ends at an interrupt.
struct Heeding<'a, R> {
    inner: R,
    watched: &'a Watched,
}

impl<R: Read> Read for Heeding<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let read = self.inner.read(buffer)?;
        match self.watched.add(read as u64) {
            ControlFlow::Continue(()) => Ok(read),
            ControlFlow::Break(()) => Err(std::io::Error::other("interrupted")),
        }
    }
}
