//! Bodies whose motion is linear and open to what acts inside of a period.

use lyapunov_core::Scalar;
use nalgebra::SMatrix;

use crate::OperatedBody;

/// A tethered body whose masses move linearly on one axis: `ż = A z − e f / m`.
///
/// `z` lists the deflection from the rest and the velocity of each mass in turn, `S` entries in all, the device
/// last; `e` is the device's velocity, `m` its mass and `f` the effort. What acts on the device inside of a period
/// needs this and not only the body's map over the whole of it.
pub trait Linear<T: Scalar, const S: usize>: OperatedBody<T> + Copy {
    /// `A` of a body made of `parts`, in lane `lane`: 1/s, and 1/s² per unit of deflection.
    fn rate(parts: &Self::Parts, lane: usize) -> SMatrix<f64, S, S>;

    /// The mass on which the effort acts, in lane `lane`, kg.
    fn device_mass(parts: &Self::Parts, lane: usize) -> f64;

    /// Where the operator's spring rests, m.
    fn rest(&self) -> T;

    /// Position and velocity of each mass, the device last.
    fn state(&self) -> [T; S];

    /// Puts the masses at `state`, listed as [`state`](Self::state) lists them, in the lanes of `of`; the others keep
    /// theirs to the bit.
    fn place(&mut self, of: T::Mask, state: [T; S]);
}
