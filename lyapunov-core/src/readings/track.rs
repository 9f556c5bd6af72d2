//! Places that a device tells, and the positions made of them.

use num_traits::Zero;

use crate::exact_sum::exact_sums;
use crate::{
    Angle, Axes, ParameterError, Pose, Requirement, Scalar, Screw, Signal, Snapshot, WithPose,
    WorldAxes,
};

/// Place that a device measures: a position along axes ([`Positions`]), or a pose in space ([`Poses`]).
///
/// [`Readings`](crate::Readings) ask for the position in the port's sample, counted from the last one that was accepted,
/// and for the motions that no device makes.
pub trait Track<V: Signal>: Copy {
    /// The place in one reading: a position, or a pose.
    type Place: Copy;

    /// The fastest motion.
    type Speed: Copy;

    /// The place of a tick without a reading.
    fn nowhere() -> Self::Place;

    /// The speed that sets no limit.
    fn unlimited() -> Self::Speed;

    /// The same speed, checked.
    ///
    /// # Errors
    /// A speed that is not above 0; infinity sets no limit.
    fn checked(speed: Self::Speed) -> Result<Self::Speed, ParameterError>;

    /// Mask of the lanes in which `displacement` takes more than `speed` over `time` s.
    fn too_far(speed: Self::Speed, displacement: V, time: V::Scalar)
    -> <V::Scalar as Scalar>::Mask;

    /// The position of `place`, which is not finite if the place is not, counted from the position `last` where one is
    /// `known`; and the track with this position.
    fn lead(self, place: Self::Place, last: V, known: <V::Scalar as Scalar>::Mask) -> (V, Self);

    /// `Ok(())` if a stored position `last`, all of whose axes are finite, is one to count from.
    ///
    /// # Errors
    /// A [`ParameterError`] that says why it is not.
    fn counted_from(last: V) -> Result<(), ParameterError>;

    /// `yes` where `mask` is true, else `no`.
    fn choose(mask: <V::Scalar as Scalar>::Mask, yes: Self, no: Self) -> Self;
}

/// Readings of positions whose differences are displacements; speeds are in m/s, over all axes together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Positions;

impl<V: Signal> Track<V> for Positions {
    type Place = V;

    type Speed = V::Scalar;

    fn nowhere() -> V {
        V::splat(V::Scalar::of(f64::NAN))
    }

    fn unlimited() -> V::Scalar {
        V::Scalar::of(f64::INFINITY)
    }

    fn checked(speed: V::Scalar) -> Result<V::Scalar, ParameterError> {
        Requirement::AboveZero.check("fastest motion", speed)
    }

    #[inline(always)]
    fn too_far(speed: V::Scalar, displacement: V, time: V::Scalar) -> <V::Scalar as Scalar>::Mask {
        let reach = speed * time;
        displacement.inner(displacement).above(reach * reach)
    }

    #[inline(always)]
    fn lead(self, place: V, _last: V, _known: <V::Scalar as Scalar>::Mask) -> (V, Self) {
        (place, self)
    }

    fn counted_from(_last: V) -> Result<(), ParameterError> {
        Ok(())
    }

    #[inline(always)]
    fn choose(_mask: <V::Scalar as Scalar>::Mask, yes: Self, _no: Self) -> Self {
        yes
    }
}

/// Readings of poses, which have no differences: the position is the sum of the displacements from one accepted pose to
/// the next, with what the sum rounds away carried along ([`PoseTrack`](crate::PoseTrack)), and the pose beside it.
///
/// Speeds are a [`PartSpeeds`]. See [`Readings::of_poses`](crate::Readings::of_poses).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Poses<T, F = WorldAxes> {
    /// Rounding errors of the sum so far, which the next step carries.
    left: Screw<T, F>,
}

/// Fastest motion of a rigid body, part by part, so that m/s and rad/s share no number.
///
/// ```
/// use lyapunov_core::{PartSpeeds, Readings, WithPose};
/// let hand = PartSpeeds { translation: 2.0, rotation: 20.0 };
/// let readings = Readings::<WithPose<f64>>::every(1e-3)?.of_poses().no_faster_than(hand)?;
/// assert_eq!(readings.fastest(), hand);
/// let frozen = PartSpeeds { rotation: 0.0, ..hand };
/// assert_eq!(readings.no_faster_than(frozen).unwrap_err().parameter, "fastest rotation");
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartSpeeds<T> {
    /// Of the reference point, m/s; infinity: no limit.
    pub translation: T,
    /// Of the rotation, rad/s; infinity: no limit. A displacement turns by no more than π, so a limit acts only while
    /// its product with the time since the last accepted pose is below π.
    pub rotation: T,
}

impl<T: Angle, F: Axes> Poses<T, F> {
    pub(crate) fn new() -> Self {
        Self { left: Screw::zero() }
    }

    /// The position of `pose`, counted from `last`, and the track with it.
    #[inline]
    pub(crate) fn step(
        self,
        last: &WithPose<T, F>,
        pose: &Pose<T>,
        known: bool,
    ) -> (WithPose<T, F>, Self) {
        // From a pose to itself leads nothing, or, if it is not sound, a NaN.
        let from = if known { &last.pose } else { pose };
        let way = Screw::between(from, pose) + self.left;
        let step = Screw::choose(pose.is_turned(), way, Screw::splat(T::of(f64::NAN)));
        let (screw, left) = exact_sums(last.screw, step);
        (WithPose { screw, pose: *pose }, Self { left })
    }
}

impl<T: Angle, F: Axes> Track<WithPose<T, F>> for Poses<T, F> {
    type Place = Pose<T>;

    type Speed = PartSpeeds<T>;

    fn nowhere() -> Pose<T> {
        Pose::splat(T::of(f64::NAN))
    }

    fn unlimited() -> PartSpeeds<T> {
        let endless = T::of(f64::INFINITY);
        PartSpeeds { translation: endless, rotation: endless }
    }

    fn checked(speed: PartSpeeds<T>) -> Result<PartSpeeds<T>, ParameterError> {
        Requirement::AboveZero.check("fastest translation", speed.translation)?;
        Requirement::AboveZero.check("fastest rotation", speed.rotation)?;
        Ok(speed)
    }

    #[inline]
    fn too_far(speed: PartSpeeds<T>, displacement: WithPose<T, F>, time: T) -> bool {
        let Screw { translation, rotation, .. } = displacement.screw;
        let PartSpeeds { translation: moving, rotation: turning } = speed;
        <Positions as Track<_>>::too_far(moving, translation, time)
            | <Positions as Track<_>>::too_far(turning, rotation, time)
    }

    #[inline]
    fn lead(self, pose: Pose<T>, last: WithPose<T, F>, known: bool) -> (WithPose<T, F>, Self) {
        self.step(&last, &pose, known)
    }

    fn counted_from(last: WithPose<T, F>) -> Result<(), ParameterError> {
        last.pose.counted_from()
    }

    #[inline]
    fn choose(mask: bool, yes: Self, no: Self) -> Self {
        Self { left: Screw::choose(mask, yes.left, no.left) }
    }
}

impl<T: Angle, F: Axes> Snapshot for Poses<T, F> {
    /// Rounding errors of the sum so far, which the next step carries.
    type State = Screw<T, F>;

    fn state(&self) -> Screw<T, F> {
        self.left
    }

    fn restored(self, left: Screw<T, F>) -> Result<Self, ParameterError> {
        Ok(Self { left: Requirement::Finite.check_axes("stored rounding", left)? })
    }
}
