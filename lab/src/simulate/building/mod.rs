//! The way from a scene to its loop: parts chosen at run time, out of the adaptors that a program chains by type.

mod assembly;
mod body;
mod fitted;
mod integrator;
mod on;
mod plant;
mod port;
mod scenes;
mod seen;
mod space;
mod stabilizer;
mod wrapper;

pub use assembly::Assembly;
pub use fitted::Fitted;
pub use plant::AnyPlant;
pub use port::Port;
pub use scenes::Scenes;
pub(crate) use seen::Seen;
pub use space::Space;
pub(crate) use space::in_space;
pub use stabilizer::AnyStabilizer;
pub use wrapper::AnyWrapper;
