//! Numbers of the loop that both sides compute: a hand against a wall of 8 kN/m, called at a tenth of the servo rate.

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

/// The fastest motion that a reading is believed, m/s.
pub(crate) const FASTEST: f64 = 20.0;

/// Steps of an integrator per period.
pub(crate) const STEPS: u32 = 4;

/// The largest damping that may be injected, N·s/m.
pub(crate) const MOST: f64 = 150.0;
/// Damping of the device on which a force bound relies, N·s/m.
pub(crate) const BOUND_DAMPING: f64 = 0.2;
/// Stored credit at the start, J.
pub(crate) const BUDGET: f64 = 1e-3;
/// Largest energy of a tank, J.
pub(crate) const ROOM: f64 = 2e-3;
/// Largest power out of a tank, W.
pub(crate) const POWER: f64 = 0.1;
