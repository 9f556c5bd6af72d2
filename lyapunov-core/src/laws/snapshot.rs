//! The law of a snapshot.

use crate::laws::{Law, Tick, Violation};
use crate::{PortSample, Scalar, Signal, Snapshot, Stabilizer};

/// Check of a `stabilizer` over `samples`: the law [`Resumes`](Law::Resumes). At every sample its state is given to a
/// copy as it was at the start, which must do the same and remember the same.
///
/// ```
/// use lyapunov_core::{Correction, ParameterError, PortSample, Snapshot, Stabilizer, laws};
/// /// Acts on every other sample, and forgets to remember on which.
/// #[derive(Clone)]
/// struct Alternating(bool);
/// impl Stabilizer<f64> for Alternating {
///     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
///         self.0 = !self.0;
///         Correction::none(if self.0 { effort + sample.velocity } else { effort })
///     }
/// }
/// impl Snapshot for Alternating {
///     type State = ();
///     fn state(&self) {}
///     fn restored(self, _state: ()) -> Result<Self, ParameterError> {
///         Ok(self)
///     }
/// }
/// let broken = laws::snapshot(&Alternating(false), laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!(broken.law, laws::Law::Resumes);
/// ```
///
/// # Errors
/// The first sample after which the two differ.
pub fn snapshot<V: Signal, S: Stabilizer<V> + Snapshot + Clone>(
    stabilizer: &S,
    samples: impl IntoIterator<Item = (PortSample<V>, V)>,
) -> Result<(), Violation> {
    let mut running = stabilizer.clone();
    for (tick, (sample, effort)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let broken = |value: V::Scalar| Violation { law: Law::Resumes, tick, value: value.lane(0) };
        let restored = stabilizer.clone().restored(running.state());
        let mut restored = restored.map_err(|_| broken(effort.sum()))?;
        let (one, other) =
            (running.stabilize(&sample, effort), restored.stabilize(&sample, effort));
        now.same(Law::Resumes, one.effort, other.effort)?;
        now.same(Law::Resumes, one.observed_energy, other.observed_energy)?;
        now.same(Law::Resumes, one.alpha, other.alpha)?;
        now.same(Law::Resumes, one.shortfall, other.shortfall)?;
        if running.state() != restored.state() {
            return Err(broken(one.observed_energy));
        }
    }
    Ok(())
}
