//! The law of a snapshot.

use super::stabilizer::alike;
use crate::laws::{Law, Tick, Violation, quantity};
use crate::{Mask, PortSample, Scalar, Signal, Snapshot, Stabilizer};

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
    Tick::each(samples, |now, sample, effort| {
        resumes(now, stabilizer, &mut running, sample, effort)
    })
}

fn resumes<V: Signal, S: Stabilizer<V> + Snapshot + Clone>(
    now: Tick,
    fresh: &S,
    running: &mut S,
    sample: &PortSample<V>,
    effort: V,
) -> Result<(), Violation> {
    let Ok(mut restored) = fresh.clone().restored(running.state()) else {
        let taken = <V::Scalar as Scalar>::Mask::of(false);
        return now.told(quantity::RESTORED).holds::<V::Scalar>(Law::Resumes, taken);
    };
    let (one, other) = (running.stabilize(sample, effort), restored.stabilize(sample, effort));
    alike(now, Law::Resumes, &one, &other)?;
    let remembered = <V::Scalar as Scalar>::Mask::of(running.state() == restored.state());
    now.told(quantity::NEXT_STATE).holds::<V::Scalar>(Law::Resumes, remembered)
}
