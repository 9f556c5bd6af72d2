//! Force law of an environment: its force and its stored energy as functions of the motion.

use lyapunov_core::{OnePort, PortSample, Scalar, Signal};

/// A time, known in `f64` whatever the scalar of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Time<T> {
    /// Seconds, alike in every lane.
    Seconds(f64),
    /// A count of calls, at the time `number / rate`: no sum of periods drifts.
    Calls {
        /// Number of earlier calls.
        number: u64,
        /// Calls per second, Hz.
        rate: T,
    },
}

impl<T: Scalar> Time<T> {
    /// The time in lane `lane`, s.
    #[inline]
    pub fn seconds(self, lane: usize) -> f64 {
        match self {
            Self::Seconds(seconds) => seconds,
            Self::Calls { number, rate } => number as f64 / rate.lane(lane),
        }
    }
}

/// Motion of a point at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics<V: Signal> {
    /// Time of the instant.
    pub time: Time<V::Scalar>,
    /// Position, m.
    pub position: V,
    /// Velocity, m/s.
    pub velocity: V,
    /// Acceleration, m/s².
    pub acceleration: V,
}

impl<V: Signal> Kinematics<V> {
    /// Motion at `position` m with `velocity` m/s, not accelerated, at time 0.
    #[inline(always)]
    pub fn at(position: V, velocity: V) -> Self {
        Self { time: Time::Seconds(0.0), position, velocity, acceleration: V::zero() }
    }

    /// The motion in a sample, for a law that needs neither time nor acceleration.
    #[inline(always)]
    pub(super) fn of(sample: &PortSample<V>) -> Self {
        Self::at(sample.position, sample.velocity)
    }
}

/// The surface of a one-sided environment on a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<V> {
    /// Its position, m: contact is strictly beyond.
    pub position: V,
    /// Its velocity, m/s.
    pub velocity: V,
}

/// An environment whose force is a law of the motion, in continuous time.
///
/// The law is complete: [`respond`](OnePort::respond) samples [`force`](Self::force) and adds only what a sampled loop
/// has to remember, such as the calls that count time. Where nothing moves the environment and its damper dissipates
/// nothing, force and energy belong together as `∫ f v dt = S(end) − S(start)`.
///
/// ```
/// use lyapunov_core::{PortSample, OnePort};
/// use lyapunov_plants::{ForceLaw, Kinematics, Wall};
/// let mut wall = Wall::new(1000.0_f64, 2.0)?.at(0.01);
/// let motion = Kinematics::at(0.015, 0.1);
/// assert!((wall.force(&motion) - 5.2).abs() < 1e-12);
/// assert!((wall.stored(&motion) - 0.0125).abs() < 1e-12);
/// assert_eq!(wall.force(&motion), wall.respond(&PortSample::starting(1e-3, 0.015, 0.1)));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub trait ForceLaw<V: Signal>: OnePort<V> {
    /// The force on this motion, N, positive against motion into the environment.
    fn force(&self, motion: &Kinematics<V>) -> V;

    /// The energy `S` stored in spring and mass, J.
    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar;

    /// The surface at `time`; none for an environment that also pulls or has more than one axis.
    fn surface(&self, time: Time<V::Scalar>) -> Option<Surface<V>> {
        let _ = time;
        None
    }
}
