//! Exceptions.

use lyapunov::ParameterError;
use lyapunov_lab::scene::Diagnostic;
use numpy::{PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyType;
use pyo3::{PyTypeInfo, create_exception};

use crate::words;

create_exception!(
    lyapunov,
    InputError,
    PyValueError,
    "Input that is wrong; the message names it, its value and the remedy, in the words of the command."
);
create_exception!(
    lyapunov,
    SceneError,
    InputError,
    "A scene that cannot be read.\n\nAttributes: `name` of the file, `message`, `key`, `value`, `line` and `column` (from 1) and \
     `remedies`, a list; those that do not apply are None."
);

/// The exception of a fault in a scene, with its parts as attributes.
pub(crate) fn scene(py: Python<'_>, fault: &Diagnostic) -> PyErr {
    // An exception is shown under its own name, which says that it is an error.
    let text = fault.to_string();
    let text = words::of_python(text.strip_prefix("error: ").unwrap_or(&text));
    let error = SceneError::new_err(text);
    let told = || -> PyResult<()> {
        let value = error.value(py);
        value.setattr("name", fault.name())?;
        value.setattr("message", fault.message())?;
        value.setattr("key", fault.key())?;
        value.setattr("value", fault.value())?;
        value.setattr("line", fault.line())?;
        value.setattr("column", fault.column())?;
        let help = fault.help().iter().map(|it| words::of_python(it));
        value.setattr("remedies", help.collect::<Vec<_>>())
    };
    told().map_or_else(|failed| failed, |()| error)
}

/// Parameters of the library that arguments here have shorter names for.
const ARGUMENTS: [(&str, &str); 15] = [
    ("barrier decay", "decay"),
    ("correction rate", "rate"),
    ("damping cap", "cap"),
    ("damping limit", "limit"),
    ("device damping", "damping"),
    ("energy-bounding c1", "c1"),
    ("energy-bounding c2", "c2"),
    ("fastest motion", "no_faster_than"),
    ("filter cutoff", "cutoff"),
    ("most stored credit", "credit"),
    ("tank ceiling", "ceiling"),
    ("tank floor", "floor"),
    ("tank power", "power"),
    ("tank start", "start"),
    ("velocity threshold", "velocity"),
];

/// The exception of a rejected parameter, by the name that the argument has.
pub(crate) fn parameter(error: ParameterError) -> PyErr {
    let named = ARGUMENTS.iter().find(|(parameter, _)| *parameter == error.parameter);
    let parameter = named.map_or(error.parameter, |(_, argument)| *argument);
    InputError::new_err(ParameterError { parameter, ..error }.to_string())
}

/// The exception of wrong input in words.
pub(crate) fn input(error: impl std::fmt::Display) -> PyErr {
    InputError::new_err(words::of_python(&error.to_string()))
}

/// Words for a value in an error: an array with its type and shape, or its class.
pub(crate) fn kind(value: &Bound<'_, PyAny>) -> String {
    match value.cast::<PyUntypedArray>() {
        Ok(array) => format!("an array of {} of shape {:?}", array.dtype(), array.shape()),
        Err(_) => {
            value.get_type().name().map_or_else(|_| "something else".into(), |it| it.to_string())
        }
    }
}

/// Checks that the argument `name` is an object with a `method`; `wanted` says what else to give.
pub(crate) fn with_method(
    object: &Bound<'_, PyAny>,
    name: &str,
    method: &str,
    wanted: &str,
) -> PyResult<()> {
    if let Ok(class) = object.cast::<PyType>() {
        let class = class.name()?;
        return Err(PyTypeError::new_err(format!(
            "{name} is the class {class}; give an object of it"
        )));
    }
    if object.hasattr(method)? {
        return Ok(());
    }
    Err(PyTypeError::new_err(format!("{name} is {}; give {wanted}", kind(object))))
}

/// The object of a class of this package that the argument `name` is.
#[inline]
pub(crate) fn of_class<'a, 'py, T: PyTypeInfo>(
    value: &'a Bound<'py, PyAny>,
    name: &str,
) -> PyResult<&'a Bound<'py, T>> {
    value.cast::<T>().map_err(|_| {
        let class = T::type_object(value.py()).to_string();
        PyTypeError::new_err(format!("{name} is {}; give an object of {class}", kind(value)))
    })
}

/// The exception of a fault of the package itself.
pub(crate) fn internal(error: impl std::fmt::Display) -> PyErr {
    PyRuntimeError::new_err(error.to_string())
}

/// Adds the exceptions to the module.
pub(crate) fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("InputError", InputError::type_object(py))?;
    module.add("SceneError", SceneError::type_object(py))
}
