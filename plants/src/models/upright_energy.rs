//! Energy of a pendulum that a virtual spring holds upright.

use lyapunov_core::{LyapunovFunction, ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use super::trigonometry::{sin, versine};
use crate::InvertedPendulum;

/// `V = ½ m l² θ̇² + ½ k θ² − m g l (1 − cos θ)`: the energy of a pendulum and of the virtual spring `k` by which a
/// controller holds it upright, J.
///
/// It is positive everywhere but at rest if `k >= m g l`. The flow is `θ̇`, the apparent mass `m l²`. Without delay,
/// under `u = −k θ − d θ̇`, `V̇ = −(b + d) θ̇²`; under any torque beside that of the spring it falls by what the torque
/// takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UprightEnergy<T> {
    pendulum: InvertedPendulum<T>,
    stiffness: T,
}

impl<T: Scalar> UprightEnergy<T> {
    /// The energy of `pendulum` on a spring of `stiffness`, N·m/rad.
    ///
    /// # Errors
    /// `stiffness` in some lane below that lane's `m g l`, infinite or NaN.
    pub fn new(pendulum: InvertedPendulum<T>, stiffness: T) -> Result<Self, ParameterError> {
        for lane in 0..T::LANES {
            let least = Requirement::AtLeast(pendulum.weight().lane(lane));
            least.check("stiffness", stiffness.lane(lane))?;
        }
        Ok(Self { pendulum, stiffness })
    }
}

impl<T: Scalar> LyapunovFunction<SVector<T, 2>> for UprightEnergy<T> {
    #[inline]
    fn value(&self, state: SVector<T, 2>) -> T {
        let [angle, rate] = state.data.0[0];
        let moving = self.pendulum.inertia() * rate * rate;
        let held = self.stiffness * angle * angle;
        T::of(0.5) * (moving + held) - self.pendulum.weight() * versine(angle)
    }

    #[inline]
    fn gradient(&self, state: SVector<T, 2>) -> SVector<T, 2> {
        let [angle, rate] = state.data.0[0];
        let torque = self.stiffness * angle - self.pendulum.weight() * sin(angle);
        SVector::from([torque, self.pendulum.inertia() * rate])
    }
}
