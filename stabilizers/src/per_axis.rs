//! One stabilizer per axis.

use lyapunov_core::{Correction, Mask, ParameterError, PortSample, Scalar, Snapshot, Stabilizer};
use nalgebra::SVector;

use crate::{LimitCredit, StabilizerExt};

/// One stabilizer per axis of a port, each with an observed energy and a damping of its own.
///
/// A single stabilizer on several axes has one sum: the energy that one axis absorbs pays for the energy that another
/// gives away, and `+1 mJ` on x hides `−0.9 mJ` on y. That is sound for the port as a whole, whose energy is the sum,
/// and it injects the least damping; but an axis that runs away stays undetected until the stored credit of the others
/// is spent. Here no axis pays for another, which is right where every axis has a motor of its own and energy cannot
/// pass between them; where it can, through a surface that is not along an axis, the controller may act without need.
///
/// The correction of a tick joins those of all axes. `effort` is theirs, axis by axis. `observed_energy` is the
/// smallest of theirs, so that it is below 0 where any axis is in debt. `shortfall` is the sum of theirs. `alpha` is
/// the damping that would dissipate on the whole motion as much as theirs together, `Σ αᵢ vᵢ² / Σ vᵢ²`, and never more
/// than the largest of them. `accepted` is true where every axis accepted; an axis whose sample is not sound gives no
/// effort, the others do. [`axes`](Self::axes) lends the stabilizers.
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DampingLimit, PerAxis, Popc};
/// use nalgebra::Vector2;
/// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let (velocity, displacement) = (Vector2::new(0.1, 0.1), Vector2::new(1e-4, 1e-4));
/// let applied = Vector2::new(10.0, -9.0); // +1 mJ on x, −0.9 mJ on y
/// let sample = HeldTick { period: 1e-3, position: Vector2::zeros(), velocity, displacement, applied }.sample();
/// let effort = Vector2::new(0.5, 0.5);
/// let mut one_sum = popc;
/// assert_eq!(one_sum.stabilize(&sample, effort).alpha, 0.0);
/// let correction = PerAxis::of([popc; 2]).stabilize(&sample, effort);
/// assert!(correction.observed_energy < 0.0 && correction.effort.x == 0.5 && correction.effort.y > 0.5);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PerAxis<S, const N: usize> {
    axes: [S; N],
}

impl<S, const N: usize> PerAxis<S, N> {
    /// The stabilizers of the axes, in their order.
    pub fn of(axes: [S; N]) -> Self {
        Self { axes }
    }

    /// The stabilizers of the axes.
    pub fn axes(&self) -> &[S; N] {
        &self.axes
    }

    /// The stabilizers of the axes, to be changed between ticks.
    pub fn axes_mut(&mut self) -> &mut [S; N] {
        &mut self.axes
    }
}

impl<S, const N: usize> StabilizerExt for PerAxis<S, N> {}

/// Limit of the credit of each axis: each keeps `most`, all together N times that.
impl<T: Scalar, S: LimitCredit<T>, const N: usize> LimitCredit<T> for PerAxis<S, N> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        for axis in &mut self.axes {
            axis.limit_credit(most);
        }
    }
}

impl<T: Scalar, S: Stabilizer<T>, const N: usize> Stabilizer<SVector<T, N>> for PerAxis<S, N> {
    #[inline]
    fn stabilize(
        &mut self,
        sample: &PortSample<SVector<T, N>>,
        effort: SVector<T, N>,
    ) -> Correction<SVector<T, N>> {
        let mut out = SVector::zeros();
        let (mut burnt, mut square) = (T::zero(), T::zero());
        let (mut sum, mut most) = (T::largest(), T::zero());
        let (mut shortfall, mut accepted) = (T::zero(), Mask::of(true));
        for (axis, stabilizer) in self.axes.iter_mut().enumerate() {
            let sample = sample.map(sample.period, |axes| axes[axis]);
            let correction = stabilizer.stabilize(&sample, effort[axis]);
            out[axis] = correction.effort;
            // A sample that is not accepted dissipates nothing, and its velocity may be anything.
            let moving = T::choose(correction.accepted, sample.velocity, T::zero());
            let own = moving * moving * sample.period;
            square += T::choose(correction.accepted, own, T::zero());
            burnt += T::choose(correction.accepted, correction.alpha * own, T::zero());
            (sum, most) = (sum.smaller(correction.observed_energy), most.larger(correction.alpha));
            shortfall = (shortfall + correction.shortfall).smaller(T::largest());
            accepted = accepted & correction.accepted;
        }
        let alpha = mean(burnt, square, most);
        Correction { effort: out, observed_energy: sum, alpha, shortfall, accepted }
    }
}

/// Damping `burnt / square`, rounded up as the axes' dampings are, and no more than the `most` of them.
#[inline]
pub(crate) fn mean<T: Scalar>(burnt: T, square: T, most: T) -> T {
    let margin = T::of(1.0) - T::of(4.0) * T::epsilon();
    let mean = burnt / (square * margin).larger(T::smallest_normal());
    let moving = square.above(T::smallest_normal());
    T::choose(moving & mean.finite(), mean, T::zero()).smaller(most)
}

impl<S: Snapshot + Clone, const N: usize> Snapshot for PerAxis<S, N> {
    type State = SVector<S::State, N>;

    fn state(&self) -> Self::State {
        SVector::from_fn(|axis, _| self.axes[axis].state())
    }

    fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
        let mut axes = self.axes;
        for (axis, state) in axes.iter_mut().zip(state.iter()) {
            *axis = axis.clone().restored(*state)?;
        }
        Ok(Self { axes })
    }
}
