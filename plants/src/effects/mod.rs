//! Effects on a port: adaptors that own it.

/// Access to the port inside an adaptor: `lends_port!([P, V: Signal] Delay<P, V>)`.
macro_rules! lends_port {
    ([$($parameters:tt)*] $adaptor:ty) => {
        impl<$($parameters)*> $adaptor {
            /// The port inside.
            #[inline(always)]
            pub fn port(&self) -> &P {
                &self.port
            }

            /// The port inside, to be changed between ticks.
            #[inline]
            pub fn port_mut(&mut self) -> &mut P {
                &mut self.port
            }
        }
    };
}

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
