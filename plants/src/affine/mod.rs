//! Plants that are affine in their input, with the port through which the input feeds a Lyapunov function.

mod affine_plant;
mod control_affine;
mod decay;
mod decrease_of;
mod measured_plant;
mod quadratic_form;
mod state_feedback;
mod with_flow;
mod with_state;

pub use affine_plant::AffinePlant;
pub use control_affine::ControlAffine;
pub use decay::Decay;
pub use decrease_of::decrease_of;
pub use measured_plant::MeasuredPlant;
pub use quadratic_form::QuadraticForm;
pub use state_feedback::StateFeedback;
pub use with_flow::WithFlow;
pub use with_state::WithState;
