//! State and parameters of stabilizers between ticks: stored, restored, changed.

mod changes;
mod ports;
mod readings;
mod refused;
mod snapshots;
mod support;
