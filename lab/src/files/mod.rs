//! Files: scenes, models of plants, teleoperators, and the shipped scenes.

pub(crate) mod models;
pub mod scene;
pub(crate) mod shipped;
pub(crate) mod teleoperation;

pub(crate) use scene::Scene;
