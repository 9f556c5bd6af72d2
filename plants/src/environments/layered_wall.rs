//! Wall of two layers.

use lyapunov_core::{Dissipation, InContact, ParameterError, Requirement, Scalar};

use crate::environments::one_sided::one_sided;
use crate::{ForceLaw, Kinematics, Surface, Time};

/// A one-sided wall of two layers: `f = max(0, s(p) + b v)` for a penetration `p = x − position > 0`, else 0, with
/// `s = k₁ p` up to `depth` and `s = k₁ depth + k₂ (p − depth)` beyond.
///
/// If `k₁ = k₂`, or if `depth` is 0 or out of reach, it is the [`Wall`](crate::Wall) of that one stiffness, to the last
/// bit.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::LayeredWall;
/// let mut skin = LayeredWall::new(0.01, [500.0, 5000.0], 0.0)?; // soft for 1 cm, then stiff
/// let at = |depth| PortSample::starting(1e-3, depth, 0.0);
/// let rise: f64 = skin.respond(&at(0.012)) - skin.respond(&at(0.010));
/// assert!((rise - 5000.0 * 0.002).abs() < 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayeredWall<T> {
    stiffness: [T; 2],
    depth: T,
    damper: Dissipation<T>,
    position: T,
}

impl<T: Scalar> LayeredWall<T> {
    /// A wall with its surface at the origin, of `stiffness` `[k₁, k₂]` N/m down to `depth` m and below, and of
    /// `damping` N·s/m.
    ///
    /// # Errors
    /// `depth`, a `stiffness` or `damping` below 0, infinite or NaN.
    pub fn new(depth: T, stiffness: [T; 2], damping: T) -> Result<Self, ParameterError> {
        let depth = Requirement::NonNegative.check("depth", depth)?;
        let [first, second] = stiffness;
        Requirement::NonNegative.check("stiffness", first)?;
        Requirement::NonNegative.check("stiffness", second)?;
        // Equal stiffnesses have no boundary of layers, and so no rounding at it.
        let layered = first.below(second) | second.below(first);
        let depth = T::choose(layered, depth, T::largest());
        Ok(Self { stiffness, depth, damper: Dissipation::of(damping)?, position: T::zero() })
    }

    /// The same wall with its surface at `position`, m.
    #[must_use]
    pub fn at(self, position: T) -> Self {
        Self { position, ..self }
    }

    /// The credit of the wall's own damper, `b v² T` strictly beyond the surface, as that of a
    /// [`Wall`](crate::Wall::dissipation).
    pub fn dissipation(&self) -> Dissipation<T, InContact<T>> {
        self.damper.gated(InContact { position: self.position })
    }
}

impl<T: Scalar> ForceLaw<T> for LayeredWall<T> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<T>) -> T {
        let depth = motion.position - self.position;
        let [first, second] = self.stiffness;
        let within = first * depth;
        let below = first * self.depth + second * (depth - self.depth);
        let spring = T::choose(depth.above(self.depth), below, within);
        one_sided(depth, spring + self.damper.damping() * motion.velocity)
    }

    fn stored(&self, motion: &Kinematics<T>) -> T {
        let (half, [first, second]) = (T::of(0.5), self.stiffness);
        let depth = (motion.position - self.position).larger(T::zero());
        let soft = depth.smaller(self.depth);
        let hard = depth - soft;
        half * first * soft * soft + first * soft * hard + half * second * hard * hard
    }

    fn surface(&self, _time: Time<T>) -> Option<Surface<T>> {
        Some(Surface { position: self.position, velocity: T::zero() })
    }
}
