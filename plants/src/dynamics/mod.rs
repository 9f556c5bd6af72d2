//! Equations of motion for integrators, and what some integrators require beyond the acceleration.

mod coordinates;
mod coupled_oscillators;
mod from_parts;
mod implicit_mechanics;
mod linear_dynamics;
mod oscillator;
mod stick_slip_oscillator;
mod switching;
mod two_mass_coordinates;
mod walled_oscillator;

pub use coordinates::Coordinates;
pub use coupled_oscillators::CoupledOscillators;
pub use from_parts::FromParts;
pub use implicit_mechanics::ImplicitMechanics;
pub use linear_dynamics::LinearDynamics;
pub use oscillator::Oscillator;
pub use stick_slip_oscillator::{StickSlipOscillator, StickSlipPhase};
pub use switching::Switching;
pub use two_mass_coordinates::TwoMassCoordinates;
pub use walled_oscillator::{WallPhase, WalledOscillator};
