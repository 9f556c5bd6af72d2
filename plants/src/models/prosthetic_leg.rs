//! Prosthetic leg on a test stand.

use lyapunov_core::{ParameterError, Requirement, Scalar};
use nalgebra::SVector;

use super::trigonometry::{cos, sin, versine};
use crate::{ControlAffine, RigidLink, TwoLinkArm};

/// Ground under a foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground<T> {
    /// `k`, stiffness, N/m.
    pub stiffness: T,
    /// `d`, damping by the rate of penetration, s/m.
    pub damping: T,
    /// `s`, drag of sliding: `s` times the load per m/s.
    pub drag: T,
}

/// A test stand for leg prostheses, in two joints: a thigh driven at the hip and a shank driven at the knee, in the
/// plane of walking, over ground.
///
/// ```text
/// M(q) q̈ + c(q, q̇) + G(q) = u + Jᵀ F            as a TwoLinkArm, q = posture + state
/// N = k p max(0, 1 + d ṗ) for a penetration p > 0 of the foot, else 0;  F = (−s N ẋ, N)
/// ```
///
/// The state is `(δ₁, δ₂, q̇₁, q̇₂)` in rad and rad/s: the deflections of hip and knee from a `posture` in which the
/// foot just touches. `u` are torques at hip and knee, N·m; [`holding`](Self::holding) gives those that keep the
/// posture. The contact is that of Hunt and Crossley (Journal of Applied Mechanics 42, 1975) with an exponent of 1.
/// Stands of this kind move the hip up and down as well (Richter, Simon, Smith and Samorezov, Applied Mathematical
/// Modelling 39, 2015).
///
/// Left out: the hip's own motion, which is fixed here; ankle, heel and toe: the foot is a point; the belt of a
/// treadmill; dry friction, of joints and of the sole; motors, gears and their compliance; the prosthesis' own knee and
/// its damper; and the gait. It is no model of a particular stand, and its figures are the user's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProstheticLeg<T> {
    pub(super) arm: TwoLinkArm<T>,
    pub(super) ground: Ground<T>,
    lengths: [T; 2],
    posture: [T; 2],
    /// Sine and cosine of each limb's angle from straight down, in the posture.
    pub(super) upright: [[T; 2]; 2],
}

/// Depth of a foot and its motion per rate of the joints.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot<T> {
    /// Penetration into the ground, m; below 0 above it.
    pub(super) depth: T,
    /// Sideways velocity per rate of each joint, m.
    sideways: [T; 2],
    /// Upward velocity per rate of each joint, m.
    pub(super) upwards: [T; 2],
}

impl<T: Scalar> ProstheticLeg<T> {
    /// A leg of `thigh` and `shank` whose foot touches the `ground` where hip and knee stand at `posture`, rad, from
    /// straight down and from the thigh.
    ///
    /// # Errors
    /// A limb that no [`TwoLinkArm`] can be made of; a `posture` that is not finite; a `stiffness`, `damping` or
    /// `drag` of the ground below 0, infinite or NaN.
    pub fn new(
        thigh: RigidLink<T>,
        shank: RigidLink<T>,
        posture: [T; 2],
        ground: Ground<T>,
    ) -> Result<Self, ParameterError> {
        let arm = TwoLinkArm::new(thigh, shank)?;
        for angle in posture {
            Requirement::Finite.check("posture", angle)?;
        }
        Requirement::NonNegative.check("stiffness", ground.stiffness)?;
        Requirement::NonNegative.check("damping", ground.damping)?;
        Requirement::NonNegative.check("drag", ground.drag)?;
        let [hip, knee] = posture;
        let upright = [hip, hip + knee].map(|angle| [sin(angle), cos(angle)]);
        Ok(Self { arm, ground, lengths: [thigh.length, shank.length], posture, upright })
    }

    /// The torques that hold the posture against gravity, N·m.
    pub fn holding(&self) -> SVector<T, 2> {
        SVector::from(self.arm.gravity(self.posture))
    }

    /// The least eigenvalue of `M(q)` over all postures, kg·m² ([`TwoLinkArm::least_inertia`]).
    pub fn least_inertia(&self) -> T {
        self.arm.least_inertia()
    }

    /// The penetration of the foot into the ground, m; below 0 in the air.
    #[inline]
    pub fn depth(&self, state: SVector<T, 4>) -> T {
        self.foot([state[0], state[1]]).depth
    }

    #[inline]
    pub(super) fn angles(&self, apart: [T; 2]) -> [T; 2] {
        [self.posture[0] + apart[0], self.posture[1] + apart[1]]
    }

    /// The angles of the limbs from straight down, less those of the posture.
    #[inline]
    pub(super) fn tilts(apart: [T; 2]) -> [T; 2] {
        [apart[0], apart[0] + apart[1]]
    }

    #[inline]
    pub(super) fn foot(&self, apart: [T; 2]) -> Foot<T> {
        let [hip, knee] = self.angles(apart);
        let [thigh, shank] = self.lengths;
        let limbs = [hip, hip + knee];
        let [thigh_over, shank_over] = [thigh * cos(limbs[0]), shank * cos(limbs[1])];
        let [thigh_up, shank_up] = [thigh * sin(limbs[0]), shank * sin(limbs[1])];
        // Each limb's end rises by length (cos before − cos now), a difference in which the cosines would cancel.
        let tilts = Self::tilts(apart);
        let rise = |limb: usize| {
            let [sine, cosine] = self.upright[limb];
            self.lengths[limb] * (cosine * versine(tilts[limb]) + sine * sin(tilts[limb]))
        };
        Foot {
            depth: -(rise(0) + rise(1)),
            sideways: [thigh_over + shank_over, shank_over],
            upwards: [thigh_up + shank_up, shank_up],
        }
    }

    /// The torques of the ground on the joints, N·m.
    #[inline]
    fn pushed(&self, foot: Foot<T>, rates: [T; 2]) -> [T; 2] {
        let along = |way: [T; 2]| way[0] * rates[0] + way[1] * rates[1];
        let zero = T::of(0.0);
        let Ground { stiffness, damping, drag } = self.ground;
        let growing = (T::of(1.0) - damping * along(foot.upwards)).larger(zero);
        let load = stiffness * foot.depth.larger(zero) * growing;
        let dragged = load * drag * along(foot.sideways);
        let torque = |joint: usize| foot.upwards[joint] * load - foot.sideways[joint] * dragged;
        [torque(0), torque(1)]
    }
}

impl<T: Scalar> ControlAffine<T, 4, 2> for ProstheticLeg<T> {
    #[inline]
    fn drift(&self, state: SVector<T, 4>) -> SVector<T, 4> {
        let [hip, knee, first, second] = state.data.0[0];
        let (apart, rates) = ([hip, knee], [first, second]);
        let pushed = self.pushed(self.foot(apart), rates);
        let [a, b] = self.arm.acceleration(self.angles(apart), rates, pushed);
        SVector::from([first, second, a, b])
    }

    #[inline]
    fn input_fields(&self, state: SVector<T, 4>) -> [SVector<T, 4>; 2] {
        self.arm.fields(self.angles([state[0], state[1]])[1])
    }
}
