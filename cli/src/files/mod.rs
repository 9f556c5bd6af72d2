//! Files that a command writes: whole or not at all, not while another process writes there, and never over what it reads.

mod beside;
mod inputs;
mod lock;
mod output;
mod outputs;
mod sidecar;

pub(crate) use beside::sweep_locked;
pub(crate) use inputs::Inputs;
pub(crate) use lock::FolderLock;
pub(crate) use output::Output;
pub(crate) use outputs::Outputs;
pub(crate) use sidecar::Sidecar;

use std::sync::atomic::{AtomicBool, Ordering};

static KEPT: AtomicBool = AtomicBool::new(false);

/// Whether a file of this process has its name.
pub(crate) fn is_any_kept() -> bool {
    KEPT.load(Ordering::Relaxed)
}
