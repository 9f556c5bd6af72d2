//! Bodies with linear motion, open to forces that act within a period.

use lyapunov_core::Scalar;
use nalgebra::SMatrix;

use crate::OperatedBody;

/// A body on the operator's spring whose masses move linearly on one axis: `ż = A z − e f / m`.
///
/// `z` lists the deflection from the rest and the velocity of each mass in turn, `S` entries in all, the device last;
/// `e` selects the device's velocity, `m` is its mass and `f` the effort. A force that acts on the device within a
/// period needs this equation, not only the body's map over the whole period.
pub trait Linear<T: Scalar, const S: usize>: OperatedBody<T> + Copy {
    /// `A` of a body made of `parts`, computed in the `number` of each: 1/s, and 1/s² per unit of deflection.
    fn rate<R: Scalar>(parts: &Self::Parts, number: impl Fn(T) -> R) -> SMatrix<R, S, S>;

    /// The mass on which the effort acts, kg.
    fn device_mass(parts: &Self::Parts) -> T;

    /// The rest of the operator's spring, m.
    fn rest(&self) -> T;

    /// Position and velocity of each mass, the device last.
    fn state(&self) -> [T; S];

    /// Sets the masses to `state`, in the order of [`state`](Self::state), in the lanes of `of`; the others keep theirs
    /// to the bit.
    fn place(&mut self, of: T::Mask, state: [T; S]);
}
