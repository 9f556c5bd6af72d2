//! Watch over a run.

use std::ops::ControlFlow;

/// Callback that says whether to go on.
pub type GoOn<'a> = dyn Fn() -> bool + Sync + 'a;

/// Callback that learns from time to time how many more ticks are done, and says whether to go on.
pub type Watch<'a> = dyn Fn(u64) -> ControlFlow<()> + 'a;
