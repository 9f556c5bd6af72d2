//! Tables of scene files as dictionaries of Python.

use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};

use crate::errors;

/// The deepest nesting that is read: scene files have four levels, and a dictionary that holds itself has no end.
const DEEPEST: u32 = 64;

/// The table that a dictionary is.
pub(super) fn read(table: &Bound<'_, PyDict>) -> PyResult<toml::Value> {
    tree(table, "", DEEPEST)
}

/// The table of a dictionary; `path` leads to it, and `left` more may lie within each other.
fn tree(table: &Bound<'_, PyDict>, path: &str, left: u32) -> PyResult<toml::Value> {
    let mut found = toml::Table::new();
    for (key, inner) in table {
        let key: String = key.extract().map_err(|_| {
            errors::input(format!(
                "a key of `{path}` is no string\n  = use the names of scene files"
            ))
        })?;
        let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        if inner.is_none() {
            return Err(errors::input(format!(
                "`{path}` is None, which no scene holds\n  = leave the key out, or give a value"
            )));
        }
        found.insert(key, leaf(&inner, &path, left)?);
    }
    Ok(toml::Value::Table(found))
}

/// The value of TOML that a value of Python is.
fn leaf(inner: &Bound<'_, PyAny>, path: &str, left: u32) -> PyResult<toml::Value> {
    if let Some(value) = plain(inner, path, left, leaf)? {
        return Ok(value);
    }
    // Scalars and arrays of NumPy give numbers and lists by `tolist`; what that returns is not asked for it again.
    match inner.call_method0("tolist") {
        Ok(told) => of_numpy(&told, path, left),
        Err(_) => Err(no_value(inner, path)),
    }
}

/// The value of TOML that a scalar or an array of NumPy told.
fn of_numpy(told: &Bound<'_, PyAny>, path: &str, left: u32) -> PyResult<toml::Value> {
    plain(told, path, left, of_numpy)?.ok_or_else(|| no_value(told, path))
}

/// Reader of the items of a list.
type Within = fn(&Bound<'_, PyAny>, &str, u32) -> PyResult<toml::Value>;

/// The value of TOML that a value of Python's own types is; none of other types.
fn plain(
    inner: &Bound<'_, PyAny>,
    path: &str,
    left: u32,
    within: Within,
) -> PyResult<Option<toml::Value>> {
    let deeper = || left.checked_sub(1).ok_or_else(|| too_deep(path));
    if let Ok(table) = inner.cast::<PyDict>() {
        return tree(table, path, deeper()?).map(Some);
    }
    if let Ok(truth) = inner.cast::<PyBool>() {
        return Ok(Some(truth.is_true().into()));
    }
    if let Ok(text) = inner.cast::<PyString>() {
        return Ok(Some(text.to_string().into()));
    }
    if inner.is_instance_of::<PyInt>() {
        let whole: i64 = inner.extract().map_err(|_| too_large(inner, path))?;
        return Ok(Some(whole.into()));
    }
    if inner.is_instance_of::<PyFloat>() {
        return Ok(Some(inner.extract::<f64>()?.into()));
    }
    if inner.is_instance_of::<PyList>() || inner.is_instance_of::<PyTuple>() {
        let left = deeper()?;
        let items = inner.try_iter()?.map(|item| within(&item?, path, left));
        return Ok(Some(toml::Value::Array(items.collect::<PyResult<_>>()?)));
    }
    Ok(None)
}

/// The error of a value that no scene holds.
fn no_value(inner: &Bound<'_, PyAny>, path: &str) -> PyErr {
    let kind =
        inner.get_type().name().map_or_else(|_| "something else".into(), |it| it.to_string());
    errors::input(format!(
        "`{path}` is {kind}, which no scene holds\n  = give a number, a string, a list or a dictionary"
    ))
}

/// The error of a whole number that TOML does not hold.
fn too_large(inner: &Bound<'_, PyAny>, path: &str) -> PyErr {
    errors::input(format!("`{path}` is {inner}, which is no number of 64 bits\n  = give a float"))
}

/// The error of dictionaries and lists without an end.
fn too_deep(path: &str) -> PyErr {
    let shown: String = path.chars().take(60).collect();
    errors::input(format!(
        "`{shown}` is more than {DEEPEST} dictionaries and lists deep\n  = give tables as scene files have them, none of which \
         holds itself"
    ))
}

/// The value of Python that a value of TOML is.
pub(super) fn shown<'py>(py: Python<'py>, tree: &toml::Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match tree {
        toml::Value::String(text) => PyString::new(py, text).into_any(),
        toml::Value::Integer(whole) => whole.into_pyobject(py)?.into_any(),
        toml::Value::Float(number) => PyFloat::new(py, *number).into_any(),
        toml::Value::Boolean(truth) => PyBool::new(py, *truth).to_owned().into_any(),
        toml::Value::Datetime(time) => PyString::new(py, &time.to_string()).into_any(),
        toml::Value::Array(items) => {
            let items: Vec<_> =
                items.iter().map(|item| shown(py, item)).collect::<PyResult<_>>()?;
            PyList::new(py, items)?.into_any()
        }
        toml::Value::Table(table) => {
            let found = PyDict::new(py);
            for (key, inner) in table {
                found.set_item(key, shown(py, inner)?)?;
            }
            found.into_any()
        }
    })
}
