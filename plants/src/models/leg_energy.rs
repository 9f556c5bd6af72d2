//! Energy of a leg that virtual springs hold in a posture.

use lyapunov_core::{LyapunovFunction, ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use super::trigonometry::{sin, versine};
use crate::ProstheticLeg;

/// The energy of a leg, of the ground under it and of the virtual springs by which a controller holds its posture, less
/// the work of the constant [`holding`](ProstheticLeg::holding) torques, J:
///
/// ```text
/// V = ½ q̇ᵀ M q̇ + ½ k max(0, p)² + U(q) − U(posture) − G(posture) · δ + ½ (k₁ δ₁² + k₂ δ₂²)
/// ```
///
/// The flow is `q̇` and the apparent mass `M(q)`. `V` is positive away from rest if the springs are stiffer than the
/// pull of gravity on the limbs; [`laws::lyapunov_function`](lyapunov_core::laws::lyapunov_function) checks it for the
/// states visited. Without delay, under `u = G(posture) − K δ − D q̇`, `V̇ = −q̇ᵀ D q̇` less what the ground
/// dissipates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LegEnergy<T> {
    leg: ProstheticLeg<T>,
    stiffness: [T; 2],
}

impl<T: Scalar> LegEnergy<T> {
    /// The energy of `leg` with springs of `stiffness` at hip and knee, N·m/rad.
    ///
    /// # Errors
    /// A `stiffness` not above 0 and finite.
    pub fn new(leg: ProstheticLeg<T>, stiffness: [T; 2]) -> Result<Self, ParameterError> {
        for spring in stiffness {
            Requirement::Positive.check("stiffness", spring)?;
        }
        Ok(Self { leg, stiffness })
    }
}

impl<T: Scalar> LyapunovFunction<SVector<T, 4>> for LegEnergy<T> {
    #[inline]
    fn value(&self, state: SVector<T, 4>) -> T {
        let [hip, knee, first, second] = state.data.0[0];
        let apart = [hip, knee];
        let [k1, k2] = self.stiffness;
        let depth = self.leg.foot(apart).depth.larger(T::of(0.0));
        let pressed = self.leg.ground.stiffness * depth * depth;
        let springs = k1 * hip * hip + k2 * knee * knee;
        let tilts = ProstheticLeg::tilts(apart);
        let raised = |limb: usize| {
            let ([sine, cosine], tilt) = (self.leg.upright[limb], tilts[limb]);
            self.leg.arm.weights[limb] * (cosine * versine(tilt) + sine * (sin(tilt) - tilt))
        };
        let elbow = self.leg.angles(apart)[1];
        let kinetic = self.leg.arm.kinetic(elbow, [first, second]);
        kinetic + (raised(0) + raised(1)) + T::of(0.5) * (pressed + springs)
    }

    #[inline]
    fn gradient(&self, state: SVector<T, 4>) -> SVector<T, 4> {
        let [hip, knee, first, second] = state.data.0[0];
        let (apart, rates) = ([hip, knee], [first, second]);
        let foot = self.leg.foot(apart);
        let load = self.leg.ground.stiffness * foot.depth.larger(T::of(0.0));
        let angles = self.leg.angles(apart);
        let (pull, held) = (self.leg.arm.gravity(angles), self.leg.holding());
        let torque = |joint: usize| {
            self.stiffness[joint] * apart[joint] + (pull[joint] - held[joint])
                - foot.upwards[joint] * load
        };
        let momenta = self.leg.arm.momenta(angles[1], rates);
        let knee = torque(1) + self.leg.arm.kinetic_by_elbow(angles[1], rates);
        SVector::from([torque(0), knee, momenta[0], momenta[1]])
    }
}
