//! Effects on a port: adaptors that own it.

mod adaptive_window;
mod backward_difference;
mod delay;
mod dropout;
mod encoder;
mod fallback;
mod guard;
mod low_pass;
mod noise;
mod one_port_ext;
mod retold;
mod saturation;
mod scaled;
mod zero_order_hold;

pub use adaptive_window::AdaptiveWindow;
pub use backward_difference::BackwardDifference;
pub use delay::Delay;
pub use dropout::Dropout;
pub use encoder::Encoder;
pub use fallback::Fallback;
pub use guard::Guard;
pub use low_pass::LowPass;
pub use noise::Noise;
pub use one_port_ext::OnePortExt;
pub use saturation::Saturation;
pub use scaled::Scaled;
pub use zero_order_hold::ZeroOrderHold;
