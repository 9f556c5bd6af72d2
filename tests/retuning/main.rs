//! State and parameters of stabilizers between ticks: stored, restored, changed.

mod changes;
mod readings;
mod refused;
mod snapshots;
mod support;
