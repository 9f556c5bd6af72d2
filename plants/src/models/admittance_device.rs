//! Admittance device, which measures a force and moves.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use crate::{ControlAffine, QuadraticForm};

/// A device that moves exactly as commanded, held by a hand that is a spring: `ẋ = u`, `q̇ = f`, `f = −k x`.
///
/// The state is `(x, q)`: the device's distance from the hand's rest, m, and the impulse of the hand's force, N·s; `u`
/// is the velocity in m/s. A feedback `u = q / m` renders a free mass `m`, in admittance causality: a force goes in and
/// a motion comes out (Adams and Hannaford 1999). Without delay the loop keeps its energy `½ k x² + ½ q² / m`; with
/// delay it gains. The flow of the port is `k x`, the force on the hand's spring. The stabilizer's "damper" is a
/// mobility in m/(N·s), which gives a velocity proportional to that force. The apparent mass is `1 / k`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AdmittanceDevice<T> {
    stiffness: T,
}

impl<T: Scalar> AdmittanceDevice<T> {
    /// A device in a hand of `stiffness` N/m.
    ///
    /// # Errors
    /// `stiffness` not above 0 and finite, or its inverse out of the scalar's range.
    pub fn new(stiffness: T) -> Result<Self, ParameterError> {
        let stiffness = Requirement::Positive.check("stiffness", stiffness)?;
        let compliance = T::of(1.0) / stiffness;
        Requirement::InRange.require("stiffness", stiffness, compliance.finite())?;
        Ok(Self { stiffness })
    }

    /// `1 / k`, m/N: the apparent mass of the port, for its damping limit.
    pub fn compliance(&self) -> T {
        T::of(1.0) / self.stiffness
    }

    /// `½ k x² + ½ q² / m`, J: the energy stored by the hand's spring and that of the rendered `mass`, kg.
    ///
    /// # Errors
    /// `mass` not above 0 and finite, or its inverse out of the scalar's range.
    pub fn energy(&self, mass: T) -> Result<QuadraticForm<T, 2>, ParameterError> {
        let mass = Requirement::Positive.check("mass", mass)?;
        let zero = T::of(0.0);
        QuadraticForm::new([
            SVector::from([self.stiffness, zero]),
            SVector::from([zero, T::of(1.0) / mass]),
        ])
    }
}

impl<T: Scalar> ControlAffine<T, 2, 1> for AdmittanceDevice<T> {
    #[inline]
    fn drift(&self, state: SVector<T, 2>) -> SVector<T, 2> {
        let [place, _] = state.data.0[0];
        SVector::from([T::of(0.0), -(self.stiffness * place)])
    }

    #[inline]
    fn input_fields(&self, _state: SVector<T, 2>) -> [SVector<T, 2>; 1] {
        [SVector::from([T::of(1.0), T::of(0.0)])]
    }
}
