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
/// The flow is `q̇` and the apparent mass `M(q)`. About the posture `V` is positive where the springs are stiffer than
/// the pull of gravity on the limbs, `diag(k₁, k₂) + ∂G/∂q` positive definite, which [`new`](Self::new) checks; farther
/// away [`laws::lyapunov_function`](lyapunov_core::laws::lyapunov_function) checks it for the states visited. Without
/// delay, under `u = G(posture) − K δ − D q̇`, `V̇ = −q̇ᵀ D q̇` less what the ground dissipates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LegEnergy<T> {
    leg: ProstheticLeg<T>,
    stiffness: [T; 2],
}

impl<T: Scalar> LegEnergy<T> {
    /// The energy of `leg` with springs of `stiffness` at hip and knee, N·m/rad.
    ///
    /// # Errors
    /// A `stiffness` not above 0 and finite; springs that in some lane do not hold the posture against gravity: the error
    /// has the softer one, and the number above which both hold it.
    pub fn new(leg: ProstheticLeg<T>, stiffness: [T; 2]) -> Result<Self, ParameterError> {
        for spring in stiffness {
            Requirement::Positive.check("stiffness", spring)?;
        }
        for lane in 0..T::LANES {
            let [[first, coupling], [_, second]] = slope_of_gravity(&leg, lane);
            let [hip, knee] = stiffness.map(|spring| spring.lane(lane));
            let both = (hip + first) * (knee + second) - coupling * coupling;
            if hip + first <= 0.0 || both <= 0.0 {
                let (middle, apart) = (0.5 * (first + second), 0.5 * (first - second));
                // Minus the least eigenvalue.
                let least = libm::hypot(apart, coupling) - middle;
                let (value, requirement) = (hip.min(knee), Requirement::AtLeast(least));
                return Err(ParameterError { parameter: "stiffness", value, requirement });
            }
        }
        Ok(Self { leg, stiffness })
    }
}

/// `∂G/∂q` in the posture, the second derivatives of the potential energy of both limbs, N·m/rad: each limb weighs
/// `w cos(angle)`, and the shank's angle is the sum of those of both joints.
fn slope_of_gravity<T: Scalar>(leg: &ProstheticLeg<T>, lane: usize) -> [[f64; 2]; 2] {
    let [thigh, shank] =
        [0, 1].map(|limb| (leg.arm.weights[limb] * leg.upright[limb][1]).lane(lane));
    [[thigh + shank, shank], [shank, shank]]
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
        let tilts = ProstheticLeg::tilts(apart);
        // Less what holds the posture: a difference in which the sines would cancel.
        let pull = |limb: usize| {
            let ([sine, cosine], tilt) = (self.leg.upright[limb], tilts[limb]);
            self.leg.arm.weights[limb] * (cosine * sin(tilt) - sine * versine(tilt))
        };
        let pulls = [pull(0) + pull(1), pull(1)];
        let torque = |joint: usize| {
            self.stiffness[joint] * apart[joint] + pulls[joint] - foot.upwards[joint] * load
        };
        let momenta = self.leg.arm.momenta(angles[1], rates);
        let knee = torque(1) + self.leg.arm.kinetic_by_elbow(angles[1], rates);
        SVector::from([torque(0), knee, momenta[0], momenta[1]])
    }
}
