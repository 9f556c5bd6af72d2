//! Simulation: loops built from files, stabilizers by name, and their runs tick by tick.

pub(crate) mod aligned;
pub(crate) mod basis;
pub(crate) mod building;
pub(crate) mod criterion;
pub(crate) mod ensemble;
pub(crate) mod equilibrium;
pub mod family;
pub(crate) mod hand;
pub(crate) mod instructions;
pub(crate) mod load;
pub(crate) mod models;
pub(crate) mod own;
pub(crate) mod place;
pub(crate) mod rollout;
pub(crate) mod row;
pub(crate) mod stabilizing;
pub(crate) mod teleoperation;
pub(crate) mod tick;

pub(crate) use aligned::{Aligned, F64x8};
pub(crate) use building::{AnyStabilizer, Assembly, Fitted, Port, Scenes, Space, in_space};
pub(crate) use criterion::Criterion;
pub use instructions::Instructions;
pub use load::Subject;
pub(crate) use rollout::Rollout;
pub(crate) use row::Row;
pub(crate) use stabilizing::Stabilizing;
pub(crate) use tick::Tick;
