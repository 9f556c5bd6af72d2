//! Equations of motion for integrators, and what some integrators ask of them beside the acceleration.

mod assembled;
mod coordinates;
mod coupled_oscillators;
mod implicit_mechanics;
mod joined;
mod linear_dynamics;
mod oscillator;
mod rubbing_oscillator;
mod switching;
mod walled_oscillator;

pub use assembled::Assembled;
pub use coordinates::Coordinates;
pub use coupled_oscillators::CoupledOscillators;
pub use implicit_mechanics::ImplicitMechanics;
pub use joined::Joined;
pub use linear_dynamics::LinearDynamics;
pub use oscillator::Oscillator;
pub use rubbing_oscillator::{Rubbing, RubbingOscillator};
pub use switching::Switching;
pub use walled_oscillator::{Walled, WalledOscillator};
