//! The way from a scene to its loop: parts chosen at run time, out of the adaptors that a program chains by type.

mod assembly;
mod body;
mod integrator;
mod plant;
mod port;
mod seen;
mod space;
mod stabilizer;

pub use assembly::Assembly;
pub use plant::AnyPlant;
pub use port::Port;
pub(crate) use seen::Seen;
pub use space::Space;
pub(crate) use space::in_space;
pub use stabilizer::AnyStabilizer;
