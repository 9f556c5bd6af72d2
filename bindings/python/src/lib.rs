//! The Python package `lyapunov`: blocks of a loop of one's own, batches of loops, and the lab.

mod axes;
mod batch;
mod blocks;
mod command;
mod errors;
mod lab;

use pyo3::prelude::*;

/// Blocks, batches and the lab of lyapunov, compiled.
#[pymodule]
mod _lyapunov {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::batch::{Batch, Corrections, closed_loop, replay};
    #[pymodule_export]
    use crate::blocks::{Correction, Observer, Readings, Sample, Stabilizer, damping_limit};

    #[pymodule_export]
    use crate::command::command;
    #[pymodule_export]
    use crate::lab::{
        Scene, Told, accuracy, bound, compare, ensemble, explain, map, map_merge, map_shard,
        observe, run, shard_head, tune,
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        crate::errors::add(module)
    }
}
