//! What is simulated: loops built from files, stabilizers by name, and their runs tick by tick.

pub mod building;
pub(crate) mod equilibrium;
pub mod family;
pub(crate) mod load;
pub mod models;
pub mod rollout;
pub mod row;
pub mod teleoperation;
pub mod tick;
