//! What acts on a port: adaptors that own it.

mod adapt;
mod adaptive_window;
mod delay;
mod difference;
mod dropout;
mod encoder;
mod fallback;
mod guard;
mod hold;
mod low_pass;
mod noise;
mod retold;
mod saturation;

pub use adapt::Adapt;
pub use adaptive_window::AdaptiveWindow;
pub use delay::Delay;
pub use difference::Difference;
pub use dropout::Dropout;
pub use encoder::Encoder;
pub use fallback::Fallback;
pub use guard::Guard;
pub use hold::Hold;
pub use low_pass::LowPass;
pub use noise::Noise;
pub use saturation::Saturation;
