//! The command `lyapunov`.

use std::ffi::OsString;
use std::io::Write;

use lyapunov_cli::Bench;
use pyo3::prelude::*;

/// Interrupts the command that runs in another thread, and ends the process.
#[pyfunction]
pub(crate) fn interrupt(py: Python<'_>) {
    py.detach(lyapunov_cli::interrupt);
}

/// Runs the command that `words` ask for, the first of them the program's name; returns its exit status.
#[pyfunction]
pub(crate) fn command(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| {
        let status = Bench::new().told(words);
        // Nobody else flushes what Rust has written here.
        let _ = std::io::stdout().flush();
        status
    })
}
