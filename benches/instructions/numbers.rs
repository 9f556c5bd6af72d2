//! The loop that both sides compute: a hand against a wall of 8 kN/m, asked at a tenth of the rate of the servo.

pub(crate) const PERIOD: f64 = 1e-3;
pub(crate) const OPERATOR_MASS: f64 = 0.1;
pub(crate) const OPERATOR_DAMPING: f64 = 0.2;
pub(crate) const OPERATOR_STIFFNESS: f64 = 50.0;
pub(crate) const DEVICE_MASS: f64 = 0.2;
pub(crate) const DEVICE_DAMPING: f64 = 0.001;
pub(crate) const START: f64 = -0.004;
pub(crate) const STIFFNESS: f64 = 8000.0;
pub(crate) const DAMPING: f64 = 2.0;
pub(crate) const HOLD: u32 = 10;

/// Steps of an integrator per period.
pub(crate) const STEPS: u32 = 4;

/// The largest damping that may be injected, N·s/m.
pub(crate) const MOST: f64 = 150.0;
/// What a force bound takes the device's damping to be, N·s/m.
pub(crate) const BOUND_DAMPING: f64 = 0.2;
/// What is on an account at the start, J.
pub(crate) const BUDGET: f64 = 1e-3;
/// What a tank holds at most, J.
pub(crate) const ROOM: f64 = 2e-3;
/// What a tank hands out at most, W.
pub(crate) const POWER: f64 = 0.1;
