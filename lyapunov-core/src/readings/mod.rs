//! Readings: what a device tells tick by tick, and the memory that makes port samples of it.

mod checked_sample;
mod clock;
mod memory;
mod reading;
mod track;

pub use checked_sample::CheckedSample;
pub use clock::{Clocked, Steady};
pub use reading::{MovingReading, Reading};
pub use track::{PartSpeeds, Poses, Positions, Track};

use crate::{
    Angle, Axes, Differenced, LowPassed, Mask, ParameterError, Requirement, Scalar, Signal,
    Snapshot, VelocityEstimator, Windowed, WithPose,
};
use memory::{Heard, Memory};

/// Velocities measured by the device: those of [`MovingReading`]s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Measured;

/// Memory of a port: readings of a device in, port samples out.
///
/// It keeps the last position, the efforts applied since then and, with a clock, the last time. So the **first** reading
/// displaces nothing wherever the device stands (a position of 0 remembered by hand, with the arm at 0.3 m, is a
/// velocity of 300 m/s on the first tick, and 54 J of credit for a damper of 0.6 N·s/m), and no tick is booked with the
/// effort of another.
///
/// ```
/// use lyapunov_core::{Reading, Readings};
/// let mut readings = Readings::every(1e-3)?.no_faster_than(2.0)?;
/// let first = readings.read(Reading { position: 0.3_f64, applied: 0.0 });
/// assert_eq!((first.sample.displacement, first.sample.velocity), (0.0, 0.0));
/// let moved = readings.read(Reading { position: 0.301, applied: 5.0 });
/// assert!((moved.sample.work - 5e-3).abs() < 1e-12); // 5 N over 1 mm
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
///
/// **A reading that is not accepted** ([`CheckedSample::accepted`]) has a position that is not finite, or one farther
/// away than the fastest motion leads ([`no_faster_than`](Self::no_faster_than)), or an effort that is not finite; so is
/// a tick without a reading ([`missed`](Self::missed)). Its sample stands still at the last position (0 before the first
/// one), over the time of this tick, and has a work of NaN: a stabilizer of held work rejects it and books nothing.
///
/// **The next accepted reading spans the gap**: its period is all the time since the accepted one before, its
/// displacement leads from there, and its work is that of the efforts meanwhile: exactly `f Δx` if one effort was
/// held, and with several the least of `f Δx` over all of them, axis by axis. That is a lower bound where the motion did
/// not turn round within the gap. An effort that is not finite counts as one of those before it. The velocity of such a
/// sample is, axis by axis, the smaller in magnitude of the estimate and the mean over the gap, and 0 where their
/// directions differ, so that no damper is credited with more than the mean motion dissipated.
///
/// **Velocities** are differences of positions, or estimated by [`low_passed`](Self::low_passed),
/// [`windowed`](Self::windowed) or an [estimator of your own](Self::estimated_by), or [`measured`](Self::measured). One
/// that is not finite is 0.
///
/// **Time** is one period a call ([`Steady`]), or that of a clock that the caller reads
/// ([`clocked`](Self::clocked), whose page says what becomes of NaN and of clocks that stand or run backwards).
///
/// Every choice is a select, so lanes with gaps of their own give the bits of their scalar runs. A guard (`guarded`) does
/// the same for a whole port, in which no time passes meanwhile; behind readings it would count the time of a gap twice.
/// Put the stabilizer outside of a hold: one inside is told the sum over the held ticks, NaN with them, and loses it.
#[derive(Clone, Copy, Debug)]
pub struct Readings<V: Signal, E = Differenced, C = Steady, P: Track<V> = Positions> {
    period: V::Scalar,
    fastest: P::Speed,
    memory: Memory<V>,
    velocity: E,
    clock: C,
    track: P,
}

impl<V: Signal> Readings<V> {
    /// The memory of a port that is read every `period` seconds, with velocities by differences.
    ///
    /// # Errors
    /// `period` not above 0 and finite.
    pub fn every(period: V::Scalar) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        let fastest = <Positions as Track<V>>::unlimited();
        let (memory, track) = (Memory::empty(), Positions);
        Ok(Self { period, fastest, memory, velocity: Differenced, clock: Steady, track })
    }
}

impl<T: Angle, F: Axes, E, C> Readings<WithPose<T, F>, E, C> {
    /// The readings of poses in place of positions: whatever holds for positions holds for them.
    ///
    /// The position of a sample is the sum of the displacements ([`Screw::between`](crate::Screw::between)) from one
    /// accepted pose to the next, with the pose beside it ([`WithPose`]). A pose that is not finite, or whose
    /// quaternion is 0, is rejected. Fastest motions are set after this, one for each part ([`PartSpeeds`]).
    ///
    /// ```
    /// use lyapunov_core::{PartSpeeds, Pose, Reading, Readings, WithPose};
    /// use nalgebra::{Isometry3, Vector3};
    /// let fastest = PartSpeeds { translation: 2.0, rotation: 20.0 }; // m/s, rad/s
    /// let mut readings = Readings::every(1e-3)?.of_poses().no_faster_than(fastest)?;
    /// let mut read = |angle: f64| {
    ///     let pose = Pose::from(Isometry3::rotation(Vector3::z() * angle));
    ///     readings.read(Reading { position: pose, applied: WithPose::<f64>::default() })
    /// };
    /// assert!(read(3.13).accepted && read(3.14).accepted);
    /// let past = read(3.15).sample; // half a turn is nothing special
    /// assert!((past.velocity.screw.rotation.z - 10.0).abs() < 1e-9);
    /// assert!(read(3.18).jumped); // 30 rad/s
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    #[must_use]
    pub fn of_poses(self) -> Readings<WithPose<T, F>, E, C, Poses<T, F>> {
        let Self { period, memory, velocity, clock, .. } = self;
        let fastest = <Poses<T, F> as Track<WithPose<T, F>>>::unlimited();
        Readings { period, fastest, memory, velocity, clock, track: Poses::new() }
    }
}

impl<V: Signal, E, C, P: Track<V>> Readings<V, E, C, P> {
    /// The same readings, of which those are rejected that only a motion faster than `speed` could reach: m/s, and of
    /// [poses](Self::of_poses) a [`PartSpeeds`].
    ///
    /// A motion by `Δx` since the last accepted reading is too fast if `|Δx| > speed · t`, with `t` the time since
    /// then, or a period if that is more. So a jump that stays is accepted after `|Δx| / speed` seconds, as a motion
    /// over that gap: [`restart`](Self::restart) if it was none. A first reading is taken as it is: after an absurd one
    /// the true ones are rejected for as long, so restart there too.
    ///
    /// # Errors
    /// `speed` not above 0; infinity sets no limit.
    ///
    /// ```
    /// use lyapunov_core::{Reading, Readings};
    /// let mut readings = Readings::every(1e-3)?.no_faster_than(2.0)?; // 2 mm a tick
    /// readings.read(Reading { position: 0.3_f64, applied: 0.0 });
    /// let lost = readings.read(Reading { position: 0.0, applied: 5.0 });
    /// assert!(lost.jumped && !lost.accepted && lost.sample.position == 0.3);
    /// let found = readings.read(Reading { position: 0.301, applied: 5.0 });
    /// assert!(found.accepted && found.late && found.sample.period == 2e-3);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    pub fn no_faster_than(mut self, speed: P::Speed) -> Result<Self, ParameterError> {
        self.set_fastest(speed)?;
        Ok(self)
    }

    /// The fastest motion that is accepted.
    pub fn fastest(&self) -> P::Speed {
        self.fastest
    }

    /// Changes the fastest motion between two ticks, as [`no_faster_than`](Self::no_faster_than).
    ///
    /// # Errors
    /// `speed` not above 0; the old one stays.
    pub fn set_fastest(&mut self, speed: P::Speed) -> Result<(), ParameterError> {
        self.fastest = P::checked(speed)?;
        Ok(())
    }

    /// The same readings with velocities through a low pass of `cutoff`, Hz ([`LowPassed`]).
    ///
    /// # Errors
    /// `cutoff` not above 0 and finite, or too large for the scalar.
    pub fn low_passed(
        self,
        cutoff: V::Scalar,
    ) -> Result<Readings<V, LowPassed<V>, C, P>, ParameterError> {
        Ok(self.estimated_by(LowPassed::new(cutoff)?))
    }

    /// The same readings with velocities over up to `ticks` readings, as long as positions lie within `band`, m, of a
    /// line ([`Windowed`]); `N` is the capacity. For a steady period: under a clock that jitters, each velocity errs by as much as
    /// the last period does.
    ///
    /// # Errors
    /// `ticks` is 0 or above `N`; `band` below 0, infinite or NaN.
    pub fn windowed<const N: usize>(
        self,
        ticks: u32,
        band: V::Scalar,
    ) -> Result<Readings<V, Windowed<V, N>, C, P>, ParameterError> {
        Ok(self.estimated_by(Windowed::new(ticks, band)?))
    }

    /// The same readings with velocities by an estimator of your own.
    #[must_use]
    pub fn estimated_by<F: VelocityEstimator<V>>(self, estimator: F) -> Readings<V, F, C, P> {
        let Self { period, fastest, memory, clock, track, .. } = self;
        Readings { period, fastest, memory, velocity: estimator, clock, track }
    }

    /// The same readings with velocities that the device measures.
    ///
    /// ```
    /// use lyapunov_core::{MovingReading, Readings};
    /// let mut readings = Readings::every(1e-3)?.measured();
    /// let first = readings.read_moving(MovingReading { position: 0.3_f64, velocity: 0.1, applied: 0.0 });
    /// assert_eq!((first.sample.displacement, first.sample.velocity), (0.0, 0.1));
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    #[must_use]
    pub fn measured(self) -> Readings<V, Measured, C, P> {
        let Self { period, fastest, memory, clock, track, .. } = self;
        Readings { period, fastest, memory, velocity: Measured, clock, track }
    }

    /// The period, s: with a clock the one that readings are meant to have.
    pub fn period(&self) -> V::Scalar {
        self.period
    }

    /// Changes the period, s, between two ticks: the reading after it is at the new one.
    ///
    /// Held work does not change with it, and an estimator of velocities is told of it as of a missed tick: a [`Windowed`] one
    /// begins anew, since its positions are counted in ticks. A `DampingLimit` made of a mass does: make it anew.
    ///
    /// # Errors
    /// `period` not above 0 and finite; the old one stays.
    pub fn set_period(&mut self, period: V::Scalar) -> Result<(), ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        self.memory.space_anew(period.above(self.period) | period.below(self.period));
        self.period = period;
        Ok(())
    }

    /// The last accepted position, m; 0 before the first.
    pub fn position(&self) -> V {
        self.memory.position()
    }

    /// Forgets the position: the next reading displaces nothing, as the first.
    ///
    /// For a device that was moved without being read, or whose encoder was set. What crossed the port between the last
    /// reading and the next is not booked.
    ///
    /// ```
    /// use lyapunov_core::{Reading, Readings};
    /// let mut readings = Readings::every(1e-3)?;
    /// readings.read(Reading { position: 0.3_f64, applied: 0.0 });
    /// readings.restart(); // the encoder was set to 0
    /// let next = readings.read(Reading { position: 0.0, applied: 5.0 }).sample;
    /// assert_eq!((next.displacement, next.work), (0.0, 0.0));
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    pub fn restart(&mut self) {
        self.memory.restart();
    }
}

impl<V: Signal, E, P: Track<V>> Readings<V, E, Steady, P> {
    /// The same readings, at the times of a clock ([`Clocked`]).
    ///
    /// ```
    /// use lyapunov_core::{Reading, Readings};
    /// let mut readings = Readings::every(1e-3)?.clocked();
    /// readings.read_at(7.000, Reading { position: 0.3_f64, applied: 0.0 });
    /// let late = readings.read_at(7.004, Reading { position: 0.302, applied: 5.0 });
    /// assert!(late.late && (late.sample.period - 4e-3_f64).abs() < 1e-12);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    #[must_use]
    pub fn clocked(self) -> Readings<V, E, Clocked, P> {
        let Self { period, fastest, memory, velocity, track, .. } = self;
        Readings { period, fastest, memory, velocity, clock: Clocked::default(), track }
    }
}

impl<V: Signal, E: VelocityEstimator<V>, C, P: Track<V>> Readings<V, E, C, P> {
    /// The sample of `reading`, or of none, after `elapsed` seconds.
    #[inline(always)]
    fn hear(
        &mut self,
        elapsed: V::Scalar,
        timed: bool,
        reading: Reading<V, P::Place>,
    ) -> CheckedSample<V> {
        let heard = self.look(elapsed, reading);
        if heard.first.any() {
            self.velocity.restart(heard.first);
        }
        // A tick that was called and had no reading was told to the estimator then.
        let skipped = elapsed.above(one_and_a_half(self.period)) | self.memory.spaced_anew();
        if skipped.any() {
            self.velocity.interrupt(skipped);
        }
        let velocity = self.velocity.velocity(&heard.motion());
        self.memory.close(heard, velocity, timed)
    }
}

impl<V: Signal, E, C, P: Track<V>> Readings<V, E, C, P> {
    /// Looks at a reading, and follows its track if it is accepted.
    #[inline(always)]
    fn look(&mut self, elapsed: V::Scalar, reading: Reading<V, P::Place>) -> Heard<V> {
        let (position, track) = self.memory.lead(self.track, reading.position);
        let reading = Reading { position, applied: reading.applied };
        let heard = self.memory.hear::<P>(elapsed, self.period, self.fastest, reading);
        self.track = P::choose(heard.accepted, track, self.track);
        heard
    }
}

impl<V: Signal, C, P: Track<V>> Readings<V, Measured, C, P> {
    #[inline(always)]
    fn hear_moving(
        &mut self,
        elapsed: V::Scalar,
        timed: bool,
        reading: MovingReading<V, P::Place>,
    ) -> CheckedSample<V> {
        let MovingReading { position, velocity, applied } = reading;
        let heard = self.look(elapsed, Reading { position, applied });
        self.memory.close(heard, velocity, timed)
    }
}

/// The memory of a loop that goes on, at the period that it had. After a pause of unknown length [`restart`](Readings::restart)
/// what was restored.
impl<V, E, C, P> Snapshot for Readings<V, E, C, P>
where
    V: Signal,
    E: Snapshot,
    C: Snapshot,
    P: Track<V> + Snapshot,
{
    /// The memory, the estimator's, the clock's and the track's.
    type State = ((V::Scalar, V, V::Scalar, V, V), E::State, C::State, P::State);

    fn state(&self) -> Self::State {
        (self.memory.state(), self.velocity.state(), self.clock.state(), self.track.state())
    }

    fn restored(
        self,
        (memory, velocity, clock, track): Self::State,
    ) -> Result<Self, ParameterError> {
        let memory = self.memory.restored(memory)?;
        memory.goes_on::<P>()?;
        Ok(Self {
            memory,
            velocity: self.velocity.restored(velocity)?,
            clock: self.clock.restored(clock)?,
            track: self.track.restored(track)?,
            ..self
        })
    }
}

/// One and a half periods: more is a missed tick, less is jitter.
#[inline(always)]
fn one_and_a_half<T: Scalar>(period: T) -> T {
    T::of(1.5) * period
}
