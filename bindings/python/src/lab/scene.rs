//! Scene.

use std::path::PathBuf;

use lyapunov_lab::scene as lab;
use lyapunov_lab::scenes::text_of;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};

use crate::errors;

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
            let text = toml::to_string(&tree(table, "")?).map_err(errors::input)?;
            return Self::read(py, &text, name);
        }
        let path: PathBuf = source
            .extract()
            .map_err(|_| PyTypeError::new_err("a scene is a dictionary, or the path of a file"))?;
        let scene = lab::Scene::load(&path).map_err(|fault| errors::scene(py, &fault))?;
        Ok(Self { scene, name: name.unwrap_or_else(|| path.display().to_string()) })
    }

    /// The scene that a text in TOML tells.
    #[staticmethod]
    #[pyo3(signature = (text, *, name="scene".to_owned()))]
    fn parse(py: Python<'_>, text: &str, name: String) -> PyResult<Self> {
        Self::read(py, text, name)
    }

    /// One of the scenes that ship, as in `lyapunov scenes`.
    #[staticmethod]
    fn shipped(py: Python<'_>, name: &str) -> PyResult<Self> {
        let text = text_of(name).map_err(errors::input)?;
        Self::read(py, text, name.to_owned())
    }

    /// The scene in TOML, with all its numbers.
    fn to_toml(&self) -> PyResult<String> {
        toml::to_string(&self.scene).map_err(errors::internal)
    }

    /// The scene as a dictionary, with all its numbers.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let tree = toml::Value::try_from(&self.scene).map_err(errors::internal)?;
        value(py, &tree)
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

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let this = slf.get();
        let again = slf.get_type().getattr("_restored")?;
        (again, (this.to_toml()?, this.name.clone())).into_pyobject(slf.py()).map(Bound::into_any)
    }

    #[staticmethod]
    fn _restored(py: Python<'_>, text: &str, name: String) -> PyResult<Self> {
        Self::read(py, text, name)
    }

    fn __repr__(&self) -> String {
        format!("<Scene {:?}: {} ticks>", self.name, self.scene.ticks())
    }
}

impl Scene {
    fn read(py: Python<'_>, text: &str, name: String) -> PyResult<Self> {
        let scene = lab::Scene::parse(text, &name).map_err(|fault| errors::scene(py, &fault))?;
        Ok(Self { scene, name })
    }
}

/// The table of a dictionary; `path` is the one that leads to it.
fn tree(table: &Bound<'_, PyDict>, path: &str) -> PyResult<toml::Value> {
    let mut found = toml::Table::new();
    for (key, inner) in table {
        let key: String = key.extract().map_err(|_| {
            errors::input(format!(
                "a key of `{path}` is no string\n  = use the names of scene files"
            ))
        })?;
        let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        if !inner.is_none() {
            found.insert(key, leaf(&inner, &path)?);
        }
    }
    Ok(toml::Value::Table(found))
}

/// The value of TOML that a value of Python is.
fn leaf(inner: &Bound<'_, PyAny>, path: &str) -> PyResult<toml::Value> {
    if let Ok(table) = inner.cast::<PyDict>() {
        return tree(table, path);
    }
    if let Ok(truth) = inner.cast::<PyBool>() {
        return Ok(truth.is_true().into());
    }
    if let Ok(text) = inner.cast::<PyString>() {
        return Ok(text.to_string().into());
    }
    if inner.is_instance_of::<PyInt>() {
        let whole: i64 = inner.extract()?;
        return Ok(whole.into());
    }
    if inner.is_instance_of::<PyFloat>() {
        return Ok(inner.extract::<f64>()?.into());
    }
    if inner.is_instance_of::<PyList>() || inner.is_instance_of::<PyTuple>() {
        let items = inner.try_iter()?.map(|item| leaf(&item?, path));
        return Ok(toml::Value::Array(items.collect::<PyResult<_>>()?));
    }
    // Scalars and arrays of NumPy tell themselves as numbers and lists.
    match inner.call_method0("tolist") {
        Ok(plain) => leaf(&plain, path),
        Err(_) => Err(errors::input(format!(
            "`{path}` is {}, which no scene holds\n  = give a number, a string, a list or a dictionary",
            inner.get_type().name()?
        ))),
    }
}

/// The value of Python that a value of TOML is.
fn value<'py>(py: Python<'py>, tree: &toml::Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match tree {
        toml::Value::String(text) => PyString::new(py, text).into_any(),
        toml::Value::Integer(whole) => whole.into_pyobject(py)?.into_any(),
        toml::Value::Float(number) => PyFloat::new(py, *number).into_any(),
        toml::Value::Boolean(truth) => PyBool::new(py, *truth).to_owned().into_any(),
        toml::Value::Datetime(time) => PyString::new(py, &time.to_string()).into_any(),
        toml::Value::Array(items) => {
            let items: Vec<_> =
                items.iter().map(|item| value(py, item)).collect::<PyResult<_>>()?;
            PyList::new(py, items)?.into_any()
        }
        toml::Value::Table(table) => {
            let found = PyDict::new(py);
            for (key, inner) in table {
                found.set_item(key, value(py, inner)?)?;
            }
            found.into_any()
        }
    })
}
