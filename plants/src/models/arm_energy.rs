//! Energy of an arm and of the virtual springs that hold its joints.

use lyapunov_core::{LyapunovFunction, ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use super::trigonometry::versine;
use crate::TwoLinkArm;

/// `V = ½ q̇ᵀ M(q) q̇ + w₁ (1 − cos q₁) + w₂ (1 − cos(q₁ + q₂)) + ½ (k₁ q₁² + k₂ q₂²)`: the energy of an arm and of the
/// virtual springs by which a controller holds its joints where the arm hangs, J.
///
/// The flow is `q̇` in every posture, and the apparent mass is `M(q)`. With springs of 0 it is the arm's own energy,
/// which only torques change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmEnergy<T> {
    arm: TwoLinkArm<T>,
    stiffness: [T; 2],
}

impl<T: Scalar> ArmEnergy<T> {
    /// The energy of `arm` with springs of `stiffness` in its two joints, N·m/rad.
    ///
    /// # Errors
    /// A `stiffness` below 0, infinite or NaN.
    pub fn new(arm: TwoLinkArm<T>, stiffness: [T; 2]) -> Result<Self, ParameterError> {
        for spring in stiffness {
            Requirement::NonNegative.check("stiffness", spring)?;
        }
        Ok(Self { arm, stiffness })
    }
}

impl<T: Scalar> LyapunovFunction<SVector<T, 4>> for ArmEnergy<T> {
    #[inline]
    fn value(&self, state: SVector<T, 4>) -> T {
        let [shoulder, elbow, first, second] = state.data.0[0];
        let [k1, k2] = self.stiffness;
        let springs = T::of(0.5) * (k1 * shoulder * shoulder + k2 * elbow * elbow);
        let [upper, lower] = self.arm.weights;
        let raised = upper * versine(shoulder) + lower * versine(shoulder + elbow);
        self.arm.kinetic(elbow, [first, second]) + raised + springs
    }

    #[inline]
    fn gradient(&self, state: SVector<T, 4>) -> SVector<T, 4> {
        let [shoulder, elbow, first, second] = state.data.0[0];
        let rates = [first, second];
        let gravity = self.arm.gravity([shoulder, elbow]);
        let momenta = self.arm.momenta(elbow, rates);
        SVector::from([
            self.stiffness[0] * shoulder + gravity[0],
            self.stiffness[1] * elbow + gravity[1] + self.arm.kinetic_by_elbow(elbow, rates),
            momenta[0],
            momenta[1],
        ])
    }
}
