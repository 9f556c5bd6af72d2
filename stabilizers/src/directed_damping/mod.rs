//! Dissipation along chosen directions.

mod along_direction;
mod axis_weights;
mod inertia_metric;

pub use along_direction::AlongDirection;
pub use axis_weights::AxisWeights;
pub use inertia_metric::InertiaMetric;

use lyapunov_core::{Correction, PortSample, Scalar, Signal, Snapshot, Stabilizer};

use crate::DampingLimit;
use crate::account::lends;

/// Metric of the directions in which damping acts: a symmetric matrix `M` with eigenvalues from 0 to 1.
pub trait Metric<V: Signal> {
    /// `M v`.
    fn apply(&self, velocity: V) -> V;
}

/// Stabilizer that dissipates in chosen directions: its correction is `β M v` instead of `α v`, and dissipates as much.
///
/// `β = (c · v) / (v · M v)`, up to a limit, with `c` the correction of the stabilizer inside. One observed energy for
/// the port as a whole says how much to dissipate; the metric says in which directions. [`InertiaMetric`] slows all
/// directions in proportion, [`AxisWeights`] weigh the axes (0 for a joint that must not feel the controller),
/// [`AlongDirection`] dissipates in one direction only. Where hardly anything moves in the chosen directions, the limit
/// keeps `β` finite, and the rest is reported as shortfall. `alpha` reports the damping that would dissipate as much on
/// the whole motion.
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{DirectedDamping, AlongDirection, DampingLimit, Popc};
/// use nalgebra::Vector2;
/// let limit = DampingLimit::of_mass(0.5, 0.2, 1e-3)?;
/// let normal = AlongDirection::new(Vector2::new(0.0, 2.0))?;
/// let mut popc = DirectedDamping::new(Popc::new(PortEnergy, limit), normal, limit);
/// let (velocity, displacement) = (Vector2::new(0.1, 0.1), Vector2::new(1e-4, 1e-4));
/// let sample = HeldTick {
///     period: 1e-3, position: Vector2::zeros(), velocity, displacement, applied: Vector2::new(-1.0, 0.0)
/// }.sample();
/// let correction = popc.stabilize(&sample, Vector2::zeros());
/// assert_eq!(correction.effort.x, 0.0);
/// let left: f64 = correction.effort.dot(&velocity) * 1e-3 + correction.observed_energy;
/// assert!(left.abs() < 1e-15); // the whole debt is served
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DirectedDamping<S, M, T> {
    stabilizer: S,
    metric: M,
    limit: DampingLimit<T>,
}

impl<S, M, T: Scalar> DirectedDamping<S, M, T> {
    /// `stabilizer` with its dissipation in the directions of `metric`, by at most `limit` in any direction.
    pub fn new(stabilizer: S, metric: M, limit: DampingLimit<T>) -> Self {
        Self { stabilizer, metric, limit }
    }
}

impl<V, S, M> Stabilizer<V> for DirectedDamping<S, M, V::Scalar>
where
    V: Signal,
    S: Stabilizer<V>,
    M: Metric<V>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, most) = (V::Scalar::of(0.0), self.limit.most());
        let inner = self.stabilizer.stabilize(sample, effort);
        let velocity = V::choose(inner.accepted, sample.velocity, V::zero());
        let power = V::choose(inner.accepted, inner.effort - effort, V::zero()).inner(velocity);
        let aimed = self.metric.apply(velocity);
        let square = aimed.inner(velocity);
        let asked = power / square.larger(V::Scalar::smallest_normal());
        let beta = V::Scalar::choose(
            square.above(V::Scalar::smallest_normal()),
            asked.smaller(most),
            zero,
        );
        let cut = inner.accepted & (beta * square).below(power);
        let whole = velocity.inner(velocity);
        let told = beta * square / whole.larger(V::Scalar::smallest_normal());
        let alpha = V::Scalar::choose(cut, told.smaller(inner.alpha), inner.alpha);
        let shortfall = (-(inner.observed_energy + alpha * (whole * sample.period))).larger(zero);
        let corrected = effort + aimed.scale(beta);
        Correction {
            effort: V::choose(inner.accepted, corrected, inner.effort),
            alpha,
            shortfall: V::Scalar::choose(cut, shortfall, inner.shortfall),
            ..inner
        }
        .checked()
    }
}

lends!(impl[S, M, T: Scalar] DirectedDamping<S, M, T>, of S, in T);

impl<S, M, T: Scalar> DirectedDamping<S, M, T> {
    /// The largest damping in any direction.
    pub fn limit(&self) -> DampingLimit<T> {
        self.limit
    }

    /// The metric.
    pub fn metric(&self) -> &M {
        &self.metric
    }

    /// Changes the metric between ticks; no sum changes.
    pub fn set_metric(&mut self, metric: M) {
        self.metric = metric;
    }

    /// Changes the limit between ticks, as [`Lolc::set_limit`](crate::Lolc::set_limit).
    pub fn set_limit(&mut self, limit: DampingLimit<T>) {
        self.limit = limit;
    }
}

lyapunov_core::snapshot! {
    impl[S: Snapshot, M, T: Scalar] DirectedDamping<S, M, T>, is stabilizer, of S::State
}
