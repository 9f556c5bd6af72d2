//! One stabilizer, or one term of a candidate, for translation and one for rotation.

use lyapunov_core::{
    Correction, LyapunovCandidate, ParameterError, PortSample, Scalar, Screw, Signal, Snapshot,
    Spatial, Stabilizer,
};
use nalgebra::SVector;

use crate::per_axis::mean;
use crate::{LimitCredit, StabilizerExt};

/// A pair on the port of a rigid body: one for translation, one for rotation.
///
/// **Of two stabilizers** it is a stabilizer with two sums: no energy that translation absorbed pays for what rotation
/// gives away, and each has a damping limit of its own ([`PartLimits`](crate::PartLimits)). Arms that keep the two apart
/// do so because a wrench may carry energy from one to the other, as a wall that is met with an edge does; then this
/// pair may act without need, and [`DirectedDamping::within`](crate::DirectedDamping::within) keeps one sum.
///
/// The correction joins both as [`PerAxis`](crate::PerAxis) does: `observed_energy` is the smaller, `shortfall` the
/// sum. `alpha` is what the two dissipate together over `v² + ω²`, metres and radians counted alike: above 0 where
/// either acts, and in no unit. [`apart`](Self::apart) gives the two corrections themselves.
///
/// **Of two candidates** it is a candidate, the sum of both: the credit of a device with two dampings is
/// `PerPart::of(Dissipation::of(b)?, Dissipation::of(c)?)`.
///
/// ```
/// use lyapunov_core::{PortEnergy, HeldTick, Screw, Stabilizer, WorldAxes};
/// use lyapunov_stabilizers::{BodyInertia, PartLimits, PerPart, Popc};
/// use nalgebra::Vector3;
/// let limits = PartLimits::of_body(0.5, BodyInertia { mass: 0.4, moment: 2e-4 }, 1e-3)?;
/// let mut popc = PerPart::of(
///     Popc::new(PortEnergy, limits.translation),
///     Popc::new(PortEnergy, limits.rotation),
/// );
/// let twist = Screw::<f64, WorldAxes>::new(Vector3::x() * 0.1, Vector3::z() * 3.0);
/// let applied = Screw::new(Vector3::x() * 2.0, Vector3::z() * -0.01); // +0.2 mJ, −0.03 mJ
/// let displacement = Screw::new(Vector3::x() * 1e-4, Vector3::z() * 3e-3);
/// let sample = HeldTick { period: 1e-3, position: twist, velocity: twist, displacement, applied }.sample();
/// let effort = popc.stabilize(&sample, Screw::new(Vector3::zeros(), Vector3::zeros())).effort;
/// assert!(effort.translation.x == 0.0 && effort.rotation.z > 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerPart<A, B> {
    translation: A,
    rotation: B,
}

impl<A, B> PerPart<A, B> {
    /// The pair for `translation` and for `rotation`.
    pub fn of(translation: A, rotation: B) -> Self {
        Self { translation, rotation }
    }

    /// What stands for translation.
    pub fn translation(&self) -> &A {
        &self.translation
    }

    /// The part of translation, to be changed between ticks.
    pub fn translation_mut(&mut self) -> &mut A {
        &mut self.translation
    }

    /// The part of rotation, to be changed between ticks.
    pub fn rotation_mut(&mut self) -> &mut B {
        &mut self.rotation
    }

    /// The part of rotation.
    pub fn rotation(&self) -> &B {
        &self.rotation
    }

    /// One tick of both stabilizers: the corrections of translation and of rotation, not joined into one wrench.
    #[inline]
    pub fn apart<V: Spatial>(
        &mut self,
        sample: &PortSample<V>,
        effort: V,
    ) -> [Correction<SVector<V::Scalar, 3>>; 2]
    where
        A: Stabilizer<SVector<V::Scalar, 3>>,
        B: Stabilizer<SVector<V::Scalar, 3>>,
    {
        let wrench = effort.screw();
        let [translation, rotation] = parts(sample);
        [
            self.translation.stabilize(&translation, wrench.translation),
            self.rotation.stabilize(&rotation, wrench.rotation),
        ]
    }
}

/// Translation and rotation of a sample.
#[inline]
fn parts<V: Spatial>(sample: &PortSample<V>) -> [PortSample<SVector<V::Scalar, 3>>; 2] {
    [
        sample.map(sample.period, |signal| signal.screw().translation),
        sample.map(sample.period, |signal| signal.screw().rotation),
    ]
}

impl<A, B> StabilizerExt for PerPart<A, B> {}

/// Limit of the credit of each part: both together keep twice that.
impl<T: Scalar, A: LimitCredit<T>, B: LimitCredit<T>> LimitCredit<T> for PerPart<A, B> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        self.translation.limit_credit(most);
        self.rotation.limit_credit(most);
    }
}

impl<V, A, B> Stabilizer<V> for PerPart<A, B>
where
    V: Spatial,
    A: Stabilizer<SVector<V::Scalar, 3>>,
    B: Stabilizer<SVector<V::Scalar, 3>>,
{
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let twist = sample.velocity.screw();
        let corrections = self.apart(sample, effort);
        let [first, second] = corrections;
        let zero = V::Scalar::of(0.0);
        let (mut burnt, mut square) = (zero, zero);
        for (correction, velocity) in corrections.iter().zip([twist.translation, twist.rotation]) {
            // A sample that is not accepted dissipates nothing, and its velocity may be anything.
            let own = velocity.inner(velocity) * sample.period;
            square += V::Scalar::choose(correction.accepted, own, zero);
            burnt += V::Scalar::choose(correction.accepted, correction.alpha * own, zero);
        }
        Correction {
            effort: V::of_screw(Screw::new(first.effort, second.effort)),
            observed_energy: first.observed_energy.smaller(second.observed_energy),
            alpha: mean(burnt, square, first.alpha.larger(second.alpha)),
            shortfall: (first.shortfall + second.shortfall).smaller(V::Scalar::largest()),
            accepted: first.accepted & second.accepted,
        }
    }
}

impl<V, A, B> LyapunovCandidate<V> for PerPart<A, B>
where
    V: Spatial,
    A: LyapunovCandidate<SVector<V::Scalar, 3>>,
    B: LyapunovCandidate<SVector<V::Scalar, 3>>,
{
    #[inline]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let [translation, rotation] = parts(sample);
        self.translation.decrease(&translation) + self.rotation.decrease(&rotation)
    }
}

impl<A: Snapshot, B: Snapshot> Snapshot for PerPart<A, B> {
    /// That of translation, and that of rotation.
    type State = (A::State, B::State);

    fn state(&self) -> Self::State {
        (self.translation.state(), self.rotation.state())
    }

    fn restored(self, (translation, rotation): Self::State) -> Result<Self, ParameterError> {
        let translation = self.translation.restored(translation)?;
        Ok(Self { translation, rotation: self.rotation.restored(rotation)? })
    }
}
