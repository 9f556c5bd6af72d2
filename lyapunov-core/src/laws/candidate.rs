//! The laws of a Lyapunov candidate.

use crate::laws::{Law, Tick, Violation};
use crate::{Drive, LyapunovCandidate, Scalar, Signal};

/// Checks that `candidate` keeps the laws [`Finite`](Law::Finite), [`Repeatable`](Law::Repeatable),
/// [`NothingForNothing`](Law::NothingForNothing) and [`Recovers`](Law::Recovers) over `samples`.
///
/// # Errors
/// The first law that is broken.
pub fn candidate<V: Signal, C: LyapunovCandidate<V> + Clone>(
    candidate: &C,
    samples: impl IntoIterator<Item = (Drive<V>, V)>,
) -> Result<(), Violation> {
    let (mut one, mut other) = (candidate.clone(), candidate.clone());
    for (tick, (drive, _)) in samples.into_iter().enumerate() {
        let now = Tick(tick);
        let decrease = one.decrease(&drive);
        now.finite(Law::Finite, decrease)?;
        now.same(Law::Repeatable, decrease, other.decrease(&drive))?;

        let mut resting = one.clone();
        let still = Drive::starting(drive.period, drive.position, V::zero());
        resting.decrease(&still);
        let credited = resting.decrease(&still);
        now.same(Law::NothingForNothing, credited, V::Scalar::of(0.0))?;

        let mut shaken = one.clone();
        let nan = V::splat(V::Scalar::of(f64::NAN));
        shaken.decrease(&Drive::new(drive.period, nan, nan, nan, nan));
        now.finite(Law::Recovers, shaken.decrease(&drive))?;
    }
    Ok(())
}
