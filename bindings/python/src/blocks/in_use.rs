//! Use of a block by one call at a time.

use pyo3::PyClass;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::False;

use crate::errors::kind;

/// The block, for a call that changes it.
#[inline]
pub(crate) fn taken<'py, B: PyClass<Frozen = False>>(
    block: &Bound<'py, B>,
) -> PyResult<PyRefMut<'py, B>> {
    block.try_borrow_mut().map_err(|_| in_use(block))
}

/// The block, for a call that looks at it.
#[inline]
pub(crate) fn seen<'py, B: PyClass>(block: &Bound<'py, B>) -> PyResult<PyRef<'py, B>> {
    block.try_borrow().map_err(|_| in_use(block))
}

/// The error of a block that another call uses.
#[cold]
fn in_use<B>(block: &Bound<'_, B>) -> PyErr {
    let name = kind(block.as_any());
    PyRuntimeError::new_err(format!(
        "this {name} is in use by another call; make a {name} for each loop"
    ))
}
