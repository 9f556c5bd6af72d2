//! Files: scenes, models of plants, teleoperators, recorded logs, and the shipped scenes.

pub(crate) mod log;
pub(crate) mod models;
pub mod scene;
pub(crate) mod shipped;
pub(crate) mod teleoperation;
mod unopened;

pub(crate) use scene::Scene;
