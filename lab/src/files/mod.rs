//! What files say: scenes, models of plants, teleoperators, and the scenes that ship.

pub mod models;
pub mod scene;
pub(crate) mod shipped;
pub mod teleoperation;
