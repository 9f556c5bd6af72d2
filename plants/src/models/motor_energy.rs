//! Lyapunov function of a motor's position loop.

use lyapunov_core::{LyapunovFunction, ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use crate::{DcMotor, MotorParts};

/// `V = ½ k θ² + ½ J ω² + ½ L (i − i*)²` with the current `i* = −(k θ + d ω) / K` that would make a spring `k` and a
/// damper `d` on the shaft, J.
///
/// It is built by backstepping (Krstić, Kanellakopoulos and Kokotović, Nonlinear and Adaptive Control Design, 1995,
/// section 2.2): if `i = i*`, then `V̇ = −(b + d) ω²`. The flow is `i − i*`, which is not a velocity, and the apparent
/// mass is `L`. The stabilizer's "damper" is a resistance to currents other than `i*`, in Ω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorEnergy<T> {
    parts: MotorParts<T>,
    stiffness: T,
    by_angle: T,
    by_rate: T,
}

impl<T: Scalar> MotorEnergy<T> {
    /// The function of `motor` for a shaft's `stiffness`, N·m/rad, and `damping`, N·m·s/rad.
    ///
    /// # Errors
    /// `stiffness` not above 0 and finite; `damping` below 0, infinite or NaN; either so large that the current it asks for leaves
    /// the range of the scalar.
    pub fn new(motor: DcMotor<T>, stiffness: T, damping: T) -> Result<Self, ParameterError> {
        let stiffness = Requirement::Positive.check("stiffness", stiffness)?;
        let damping = Requirement::NonNegative.check("damping", damping)?;
        let parts = motor.parts();
        let by_angle = stiffness / parts.torque_constant;
        let by_rate = damping / parts.torque_constant;
        Requirement::InRange.require("stiffness", stiffness, by_angle.finite())?;
        Requirement::InRange.require("damping", damping, by_rate.finite())?;
        Ok(Self { parts, stiffness, by_angle, by_rate })
    }

    /// The deviation of the current, `i − i*`, A.
    #[inline]
    fn astray(&self, state: SVector<T, 3>) -> T {
        let [angle, rate, current] = state.data.0[0];
        current + self.by_angle * angle + self.by_rate * rate
    }
}

impl<T: Scalar> LyapunovFunction<SVector<T, 3>> for MotorEnergy<T> {
    #[inline]
    fn value(&self, state: SVector<T, 3>) -> T {
        let [angle, rate, _] = state.data.0[0];
        let astray = self.astray(state);
        let MotorParts { inertia, inductance, .. } = self.parts;
        let shaft = self.stiffness * angle * angle + inertia * rate * rate;
        T::of(0.5) * (shaft + inductance * astray * astray)
    }

    #[inline]
    fn gradient(&self, state: SVector<T, 3>) -> SVector<T, 3> {
        let [angle, rate, _] = state.data.0[0];
        let flux = self.parts.inductance * self.astray(state);
        SVector::from([
            self.stiffness * angle + flux * self.by_angle,
            self.parts.inertia * rate + flux * self.by_rate,
            flux,
        ])
    }
}
