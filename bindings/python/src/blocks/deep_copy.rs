//! Deep copies of blocks that may hold a candidate written in Python, which may hold the block.

use pyo3::PyClass;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::False;
use pyo3::pyclass_init::PyClassInitializer;
use pyo3::types::PyDict;

use super::{seen, taken};

/// A block that may ask a candidate written in Python.
pub(super) trait Asking: PyClass<Frozen = False> + Into<PyClassInitializer<Self>> {
    /// A copy with the same memory, which asks the same candidate.
    fn copied(&self, py: Python<'_>) -> PyResult<Self>;

    /// The candidate, if it is written in Python.
    fn asked(&self) -> Option<&Py<PyAny>>;

    /// Takes another candidate in place of the one that it has.
    fn ask(&mut self, candidate: Py<PyAny>) -> PyResult<()>;
}

/// A copy of a block with a copy of its candidate.
pub(super) fn deep_copy<'py, B: Asking>(
    block: &Bound<'py, B>,
    memo: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, B>> {
    let py = block.py();
    let copy = Bound::new(py, seen(block)?.copied(py)?)?;
    // A candidate that holds the block then holds its copy.
    memo.set_item(block.as_ptr() as usize, &copy)?;
    let shared = seen(block)?.asked().map(|it| it.clone_ref(py));
    if let Some(shared) = shared {
        let own = py.import("copy")?.call_method1("deepcopy", (shared, memo))?;
        taken(&copy)?.ask(own.unbind())?;
    }
    Ok(copy)
}
