//! Band of an energy-bounded axis: the forces that may come next.

use lyapunov_core::Scalar;

use crate::hypotenuse::hypotenuse;

/// The forces that an axis may go to from the force it had, over a displacement.
pub trait Band<T: Scalar> {
    /// The least and the most, N.
    fn ends(&self, force: T, moved: T) -> (T, T);

    /// The damping over the period that it relies on, `b / T`, N/m.
    fn burns(&self) -> T;

    /// `c` of the stored energy `F² / (2 c)`, N/m.
    fn release(&self) -> T;
}

/// The published band of [`EnergyBounding`](crate::EnergyBounding): of the slopes `γmin ≤ β ≤ min(c1, γmax)`, in forces.
#[derive(Clone, Copy, Debug)]
pub struct PublishedBand<T> {
    /// `c1`, N/m.
    pub(super) rise: T,
    /// `c2`, N/m.
    pub(super) release: T,
    /// `β ≥ −fall`, N/m.
    pub(super) fall: T,
    pub(super) burns: T,
}

impl<T: Scalar> Band<T> for PublishedBand<T> {
    #[inline(always)]
    fn ends(&self, force: T, moved: T) -> (T, T) {
        let zero = T::of(0.0);
        let given = self.release * moved;
        let size = hypotenuse(force, given);
        let risen = force + self.rise * moved;
        let fallen = force - self.fall * moved;
        let inwards = moved.above(zero);
        let least = (given - size).larger(T::choose(inwards, fallen, risen));
        let most = (given + size).smaller(T::choose(inwards, risen, fallen));
        let moving = inwards | moved.below(zero);
        (T::choose(moving, least, force), T::choose(moving, most, force))
    }

    #[inline(always)]
    fn burns(&self) -> T {
        self.burns
    }

    #[inline(always)]
    fn release(&self) -> T {
        self.release
    }
}

/// The band of [`EnergyBounding::tight`](crate::EnergyBounding::tight): `|F(k)| ≤ |F(k−1) + c Δx|`, the largest for which
/// `F² / (2 c)` is a storage.
#[derive(Clone, Copy, Debug)]
pub struct TightBand<T> {
    /// `c`, N/m.
    pub(super) slope: T,
}

impl<T: Scalar> Band<T> for TightBand<T> {
    #[inline(always)]
    fn ends(&self, force: T, moved: T) -> (T, T) {
        let size = (force + self.slope * moved).magnitude();
        let moving = moved.magnitude().above(T::of(0.0));
        (T::choose(moving, -size, force), T::choose(moving, size, force))
    }

    #[inline(always)]
    fn burns(&self) -> T {
        self.slope * T::of(0.5)
    }

    #[inline(always)]
    fn release(&self) -> T {
        self.slope
    }
}
