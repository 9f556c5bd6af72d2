//! What acts on a port: adaptors that own it.

mod adapt;
mod delay;
mod difference;
mod encoder;
mod guard;
mod hold;
mod saturation;

pub use adapt::Adapt;
pub use delay::Delay;
pub use difference::Difference;
pub use encoder::Encoder;
pub use guard::{Fallback, Guard};
pub use hold::Hold;
pub use saturation::Saturation;
