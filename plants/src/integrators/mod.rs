//! One-step methods for equations of motion.

mod exact;
mod implicit_midpoint;
mod runge_kutta_4;
mod semi_implicit_euler;

pub use exact::Exact;
pub use implicit_midpoint::ImplicitMidpoint;
pub use runge_kutta_4::RungeKutta4;
pub use semi_implicit_euler::SemiImplicitEuler;
