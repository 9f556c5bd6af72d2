//! Scene.

use std::io::{self, Cursor, ErrorKind, Read};
use std::path::{Path, PathBuf};

use lyapunov_lab::scene::{self as lab, Motion};
use lyapunov_lab::scenes::text_of;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use super::tables;
use crate::errors::{self, kind};
use crate::stored;

/// A checked scene: a simulated loop, its duration and its stabilizer, in SI units.
///
/// `Scene(source, *, name=None)`: `source` is the path of a scene file (TOML), or a dictionary with the same tables and
/// keys. What is wrong raises SceneError, which names the key, its place and the remedy; the place in a dictionary is that
/// in the TOML which it makes.
#[pyclass(module = "lyapunov", frozen, eq, skip_from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scene {
    pub(crate) scene: lab::Scene,
    /// What reports call it.
    #[pyo3(get)]
    pub(crate) name: String,
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (source, *, name=None))]
    fn new(source: &Bound<'_, PyAny>, name: Option<String>) -> PyResult<Self> {
        let py = source.py();
        if let Ok(table) = source.cast::<PyDict>() {
            let name = name.unwrap_or_else(|| "scene".to_owned());
            let text = toml::to_string(&tables::read(table)?).map_err(errors::input)?;
            return Self::read(py, &text, name);
        }
        let path: PathBuf = source.extract().map_err(|_| {
            let several = source.is_instance_of::<PyList>() || source.is_instance_of::<PyTuple>();
            let remedy =
                if several { "; give several one by one, as in compare(*scenes)" } else { "" };
            PyTypeError::new_err(format!(
                "a scene is a dictionary, or the path of a file, and not {}{remedy}",
                kind(source)
            ))
        })?;
        if path.to_str().is_some_and(is_toml) {
            return Err(errors::input(
                "this is the text of a scene, and not the path of its file\n  = give Scene.parse(text)",
            ));
        }
        let scene = lab::Scene::load(&path).map_err(|fault| errors::scene(py, &fault))?;
        Ok(Self { scene, name: name.unwrap_or_else(|| path.display().to_string()) })
    }

    /// The scene that a text in TOML tells.
    #[staticmethod]
    #[pyo3(signature = (text, *, name="scene".to_owned()))]
    fn parse(py: Python<'_>, text: &str, name: String) -> PyResult<Self> {
        Self::read(py, text, name)
    }

    /// One of the scenes that ship, which `lyapunov.scenes()` lists.
    #[staticmethod]
    fn shipped(py: Python<'_>, name: &str) -> PyResult<Self> {
        let text = text_of(name).map_err(errors::input)?;
        // What a scene that ships reads ships with it.
        let open = |path: &Path| match text_of(&path.to_string_lossy()) {
            Ok(text) => Ok(Box::new(text.as_bytes()) as Box<dyn Read>),
            Err(_) => Err(ErrorKind::NotFound.into()),
        };
        Self::beside(py, text, name.to_owned(), &open)
    }

    /// The scene in TOML, with all its numbers; a cap that it leaves out stays left out, as it follows the delay.
    fn to_toml(&self) -> PyResult<String> {
        toml::to_string(&self.scene.as_written()).map_err(errors::internal)
    }

    /// The scene as a dictionary, with the numbers of `to_toml`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let tree = toml::Value::try_from(self.scene.as_written()).map_err(errors::internal)?;
        tables::shown(py, &tree)
    }

    /// The number of servo ticks.
    #[getter]
    fn ticks(&self) -> u64 {
        self.scene.ticks()
    }

    /// The number of dimensions.
    #[getter]
    fn dimensions(&self) -> usize {
        self.scene.dimensions()
    }

    /// The mass that is sure to move with the port, kg: the device's, and the hand's where no link is between them.
    #[getter]
    fn mass(&self) -> f64 {
        self.scene.port_mass()
    }

    /// The servo period, s.
    #[getter]
    fn period(&self) -> f64 {
        self.scene.period()
    }

    /// The device's own damping, N·s/m.
    #[getter]
    fn damping(&self) -> f64 {
        self.scene.device.damping.get()
    }

    /// Whole servo ticks by which a force acts late.
    #[getter]
    fn delay(&self) -> u32 {
        self.scene.delay_ticks()
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let this = slf.get();
        let parts = (this.to_toml()?, this.name.clone(), this.motion());
        stored::again(slf, parts)
    }

    #[staticmethod]
    fn _restored(
        py: Python<'_>,
        text: &str,
        name: String,
        motion: Option<Vec<u8>>,
    ) -> PyResult<Self> {
        let open = |_: &Path| match &motion {
            Some(rows) => Ok(Box::new(Cursor::new(rows.clone())) as Box<dyn Read>),
            None => Err(ErrorKind::NotFound.into()),
        };
        Self::beside(py, text, name, &open)
    }

    fn __repr__(&self) -> String {
        format!("<Scene {:?}: {} ticks>", self.name, self.scene.ticks())
    }
}

/// Whether what should be a path is a text in TOML: lines, or a key with its value.
fn is_toml(path: &str) -> bool {
    path.contains('\n') || (path.contains(" = ") && !Path::new(path).exists())
}

impl Scene {
    fn beside(
        py: Python<'_>,
        text: &str,
        name: String,
        open: &dyn Fn(&Path) -> io::Result<Box<dyn Read>>,
    ) -> PyResult<Self> {
        let scene = lab::Scene::parse_beside(text, &name, open);
        Ok(Self { scene: scene.map_err(|fault| errors::scene(py, &fault))?, name })
    }

    /// The rows of its recorded motion, which need not be where the scene is read again.
    fn motion(&self) -> Option<Vec<u8>> {
        let Some(Motion::File { samples, .. }) = &self.scene.operator.motion else { return None };
        let rows = samples.iter().map(|(t, rest)| format!("{t:?},{rest:?}\n"));
        Some(format!("t,rest\n{}", rows.collect::<String>()).into_bytes())
    }

    fn read(py: Python<'_>, text: &str, name: String) -> PyResult<Self> {
        let scene = lab::Scene::parse(text, &name).map_err(|fault| errors::scene(py, &fault))?;
        Ok(Self { scene, name })
    }
}
