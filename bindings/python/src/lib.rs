//! The Python package `lyapunov`: blocks of a loop of one's own, batches of loops, and the lab.

mod axes;
mod batch;
mod blocks;
mod command;
mod errors;
mod lab;
mod number;
mod stored;
mod whole;
mod words;

use pyo3::prelude::*;

/// Blocks, batches and the lab of lyapunov, compiled.
#[pymodule]
mod _lyapunov {
    use numpy::PyArrayMethods;
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::batch::closed_loop::closed_loop;
    #[pymodule_export]
    use crate::batch::replay::replay;
    #[pymodule_export]
    use crate::batch::{Batch, Corrections};
    #[pymodule_export]
    use crate::blocks::{Correction, Observer, Readings, Sample, Stabilizer, damping_limit};
    #[pymodule_export]
    use crate::command::{command, interrupt};
    #[pymodule_export]
    use crate::lab::accuracy::accuracy;
    #[pymodule_export]
    use crate::lab::bound::bound;
    #[pymodule_export]
    use crate::lab::compare::{compare, label_of};
    #[pymodule_export]
    use crate::lab::ensemble::ensemble;
    #[pymodule_export]
    use crate::lab::explain::explain;
    #[pymodule_export]
    use crate::lab::map::map;
    #[pymodule_export]
    use crate::lab::observe::observe;
    #[pymodule_export]
    use crate::lab::run::run;
    #[pymodule_export]
    use crate::lab::scenes::scenes;
    #[pymodule_export]
    use crate::lab::tune::tune;
    #[pymodule_export]
    use crate::lab::units::unit_of;
    #[pymodule_export]
    use crate::lab::{MapMerge, Scene, Told, map_cells, map_shard, shard_head};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        // What is looked up in NumPy once is looked up here, and not within a call that may be interrupted.
        drop(numpy::PyArray1::<f64>::zeros(module.py(), 0, false).try_readonly());
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("debug_assertions", cfg!(debug_assertions))?;
        crate::errors::add(module)
    }
}
