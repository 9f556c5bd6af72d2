//! Trajectories: values that follow time, such as a hand's rest or a load.

mod clock;
mod constant;
mod first_axis;
mod pulse;
mod ramp;
mod samples;
mod sine;
mod step;
mod trajectory;

pub use clock::tick_of;
pub use constant::Constant;
pub use first_axis::FirstAxis;
pub use pulse::Pulse;
pub use ramp::{Ramp, RampParts};
pub use samples::Samples;
pub use sine::Sine;
pub use step::Step;
pub use trajectory::Trajectory;
