//! Port sample of a reading, and what was found in it.

use crate::scalar::same_lanes;
use crate::{PortSample, Scalar, Signal};

/// Port sample made of a reading, and what [`Readings`](crate::Readings) found in it, lane by lane.
///
/// ```
/// use lyapunov_core::{Reading, Readings};
/// let mut readings = Readings::every(1e-3)?;
/// readings.read(Reading { position: 0.3_f64, applied: 0.0 });
/// let bad = readings.read(Reading { position: f64::NAN, applied: 2.0 });
/// assert!(!bad.accepted && !bad.jumped);
/// assert!(bad.sample.position == 0.3 && bad.sample.velocity == 0.0 && bad.sample.work.is_nan());
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "PortSample<V>: serde::Serialize, <V::Scalar as Scalar>::Mask: serde::Serialize",
        deserialize = "PortSample<V>: serde::Deserialize<'de>, \
                       <V::Scalar as Scalar>::Mask: serde::Deserialize<'de>"
    ))
)]
pub struct CheckedSample<V: Signal> {
    /// The sample, for a controller and a stabilizer. Where the reading was not accepted it stands still at the last
    /// position, and its work is NaN, so that a stabilizer rejects it; over sampled work, which is made of effort and velocity, it
    /// books nothing.
    pub sample: PortSample<V>,
    /// Where the reading was accepted.
    pub accepted: <V::Scalar as Scalar>::Mask,
    /// Where the position was farther away than the fastest motion leads.
    pub jumped: <V::Scalar as Scalar>::Mask,
    /// Where more than one and a half periods went by since the last accepted reading: a tick was missed.
    pub late: <V::Scalar as Scalar>::Mask,
    /// Whether the time could be used; always true of a fixed period.
    pub timed: bool,
}

impl<V: Signal> PartialEq for CheckedSample<V> {
    fn eq(&self, other: &Self) -> bool {
        let same = same_lanes::<V::Scalar>;
        self.sample == other.sample
            && same(self.accepted, other.accepted)
            && same(self.jumped, other.jumped)
            && same(self.late, other.late)
            && self.timed == other.timed
    }
}
