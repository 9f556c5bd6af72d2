//! One-step methods.

mod adaptive;
mod dormand_prince_5;
mod dormand_prince_8;
mod embedded_pair;
mod event_locating;
mod exact;
mod implicit_midpoint;
mod runge_kutta_4;
mod runge_kutta_nystrom_4;
mod semi_implicit_euler;

pub use adaptive::Adaptive;
pub use dormand_prince_5::DormandPrince5;
pub use dormand_prince_8::DormandPrince8;
pub use embedded_pair::EmbeddedPair;
pub use event_locating::EventLocating;
pub use exact::Exact;
pub use implicit_midpoint::ImplicitMidpoint;
pub use runge_kutta_4::RungeKutta4;
pub use runge_kutta_nystrom_4::RungeKuttaNystrom4;
pub use semi_implicit_euler::SemiImplicitEuler;
