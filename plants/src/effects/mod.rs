//! Effects on a port: adaptors that own it.

mod delay;
mod dropout;
mod encoder;
mod estimated;
mod fallback;
mod guard;
mod noise;
mod one_port_ext;
mod retold;
mod saturation;
mod scaled;
mod zero_order_hold;

pub use delay::Delay;
pub use dropout::Dropout;
pub use encoder::Encoder;
pub use estimated::{AdaptiveWindow, BackwardDifference, Estimated, LowPass};
pub use fallback::Fallback;
pub use guard::Guard;
pub use noise::Noise;
pub use one_port_ext::OnePortExt;
pub use saturation::Saturation;
pub use scaled::Scaled;
pub use zero_order_hold::ZeroOrderHold;
