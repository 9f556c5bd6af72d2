//! Well-known control-affine plants, and Lyapunov functions for them.

mod admittance_device;
mod arm_energy;
mod dc_motor;
mod inverted_pendulum;
mod leg_energy;
mod motor_energy;
mod prosthetic_leg;
mod serial_arm;
mod trigonometry;
mod two_link_arm;
mod upright_energy;
mod van_der_pol;

pub use admittance_device::AdmittanceDevice;
pub use arm_energy::ArmEnergy;
pub use dc_motor::{DcMotor, MotorParts};
pub use inverted_pendulum::InvertedPendulum;
pub use leg_energy::LegEnergy;
pub use motor_energy::MotorEnergy;
pub use prosthetic_leg::{Ground, ProstheticLeg};
pub use serial_arm::{ArmLink, ArmPosture, SerialArm};
pub use two_link_arm::{RigidLink, TwoLinkArm};
pub use upright_energy::UprightEnergy;
pub use van_der_pol::VanDerPol;

/// Standard gravity, m/s² (General Conference on Weights and Measures, 1901).
const GRAVITY: f64 = 9.80665;
