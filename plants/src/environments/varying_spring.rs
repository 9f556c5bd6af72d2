//! Spring of varying stiffness.

use lyapunov_core::{OnePort, ParameterError, PortSample, Signal, Snapshot};

use crate::environments::oscillation::Oscillation;
use crate::{ForceLaw, Kinematics, Spring, Time};

/// A [`Spring`] whose stiffness oscillates, two-sided:
/// `f = (stiffness + amplitude sin(2π frequency t(n))) (x − position)`.
///
/// A spring that is stretched while soft and released while stiff gives more than it took: it is active without any
/// sampling error.
///
/// `t(n) = n / rate`, with `n` the earlier calls of this environment, none at the first. Time is never summed: the
/// phase is `2π · (frequency · (n / rate))` in `f64`, whatever the scalar. An adaptor that keeps calls from the spring
/// keeps it from changing.
///
/// An amplitude of 0 is the spring alone, to the last bit.
///
/// ```
/// use lyapunov_core::{PortSample, OnePort};
/// use lyapunov_plants::{Spring, VaryingSpring};
/// let mut spring: VaryingSpring<f64> = VaryingSpring::new(Spring::new(100.0)?, 50.0, 25.0, 100.0)?;
/// let still = PortSample::starting(0.01, 0.02, 0.0);
/// for force in [2.0_f64, 3.0, 2.0, 1.0] {
///     assert!((spring.respond(&still) - force).abs() < 1e-12);
/// }
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VaryingSpring<V: Signal> {
    spring: Spring<V>,
    change: Oscillation<V::Scalar>,
}

impl<V: Signal> VaryingSpring<V> {
    /// `spring`, with a stiffness that oscillates by `amplitude` N/m at `frequency` Hz, called `rate` times in a
    /// second.
    ///
    /// # Errors
    /// `amplitude` infinite or NaN; `frequency` below 0, infinite or NaN; `rate` not above 0 and finite; a frequency so
    /// high that the phase or the rate of change of the stiffness is out of range.
    pub fn new(
        spring: Spring<V>,
        amplitude: V::Scalar,
        frequency: V::Scalar,
        rate: V::Scalar,
    ) -> Result<Self, ParameterError> {
        Ok(Self { spring, change: Oscillation::new(amplitude, frequency, rate)? })
    }

    /// The spring with its stiffness at `time`.
    #[inline]
    fn at(&self, time: Time<V::Scalar>) -> Spring<V> {
        self.spring.stiffened(self.change.value(time))
    }
}

impl<V: Signal> ForceLaw<V> for VaryingSpring<V> {
    #[inline(always)]
    fn force(&self, motion: &Kinematics<V>) -> V {
        self.at(motion.time).force(motion)
    }

    fn stored(&self, motion: &Kinematics<V>) -> V::Scalar {
        self.at(motion.time).stored(motion)
    }
}

impl<V: Signal> OnePort<V> for VaryingSpring<V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let time = self.change.tick();
        self.force(&Kinematics { time, ..Kinematics::of(sample) })
    }
}

impl<V: Signal> Snapshot for VaryingSpring<V> {
    /// The number of calls, which is its time.
    type State = u64;

    fn state(&self) -> u64 {
        self.change.calls()
    }

    fn restored(self, calls: u64) -> Result<Self, ParameterError> {
        Ok(Self { change: self.change.after(calls), ..self })
    }
}
