//! DC motor with an inductance.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use crate::ControlAffine;

/// Parts of a DC motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorParts<T> {
    /// `J`, inertia of the rotor and its load, kg·m².
    pub inertia: T,
    /// `b`, viscous friction, N·m·s/rad.
    pub friction: T,
    /// `K`, torque constant, N·m/A, and back-voltage constant, V·s/rad.
    pub torque_constant: T,
    /// `R`, resistance, Ω.
    pub resistance: T,
    /// `L`, inductance, H.
    pub inductance: T,
}

/// A DC motor under a voltage: `θ̇ = ω`, `J ω̇ = K i − b ω`, `L di/dt = u − R i − K ω`.
///
/// The state is `(θ, ω, i)` in rad, rad/s and A, `u` in V (Franklin, Powell and Emami-Naeini, Feedback Control of
/// Dynamic Systems, section 2.3). A position loop `u = −k θ` is stable, by Routh's criterion, if
/// `k K J L < (b L + J R) (b R + K²)`: the current lags, and with too high a gain the loop is unstable.
///
/// ```
/// use lyapunov_plants::{DcMotor, MotorParts};
/// let parts = MotorParts { inertia: 1e-5, friction: 1e-6, torque_constant: 0.03, resistance: 2.0, inductance: 1e-3 };
/// let motor = DcMotor::new(parts)?;
/// assert!(motor.critical_gain() > 0.0_f64);
/// assert!(DcMotor::new(MotorParts { inductance: 0.0, ..parts }).is_err());
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DcMotor<T> {
    parts: MotorParts<T>,
}

impl<T: Scalar> DcMotor<T> {
    /// The motor made of `parts`.
    ///
    /// # Errors
    /// `inertia`, `torque_constant`, `resistance` or `inductance` not above 0 and finite; `friction` below 0,
    /// infinite or NaN.
    pub fn new(parts: MotorParts<T>) -> Result<Self, ParameterError> {
        Requirement::Positive.check("inertia", parts.inertia)?;
        Requirement::NonNegative.check("friction", parts.friction)?;
        Requirement::Positive.check("torque constant", parts.torque_constant)?;
        Requirement::Positive.check("resistance", parts.resistance)?;
        Requirement::Positive.check("inductance", parts.inductance)?;
        Ok(Self { parts })
    }

    /// The parts it is made of.
    pub fn parts(&self) -> MotorParts<T> {
        self.parts
    }

    /// The gain from which on a position loop is unstable, V/rad, without a sampling period or delay.
    pub fn critical_gain(&self) -> T {
        let MotorParts { inertia, friction, torque_constant, resistance, inductance } = self.parts;
        // Divided before it is multiplied: three small numbers in one product are 0 in `f32`.
        let slow = friction / inertia + resistance / inductance;
        slow * (friction * resistance / torque_constant + torque_constant)
    }
}

impl<T: Scalar> ControlAffine<T, 3, 1> for DcMotor<T> {
    #[inline]
    fn drift(&self, state: SVector<T, 3>) -> SVector<T, 3> {
        let [_, rate, current] = state.data.0[0];
        let MotorParts { inertia, friction, torque_constant, resistance, inductance } = self.parts;
        SVector::from([
            rate,
            (torque_constant * current - friction * rate) / inertia,
            -(resistance * current + torque_constant * rate) / inductance,
        ])
    }

    #[inline]
    fn input_fields(&self, _state: SVector<T, 3>) -> [SVector<T, 3>; 1] {
        [SVector::from([T::of(0.0), T::of(0.0), T::of(1.0) / self.parts.inductance])]
    }
}
