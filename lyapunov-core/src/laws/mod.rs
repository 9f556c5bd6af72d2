//! Laws that every part must keep, with checks to run on parts of your own.
//!
//! The same functions check the parts of this workspace. Each feeds a part [`Samples`] (or any other samples) and
//! returns the first law that is broken, the tick and the number that broke it.
//!
//! ```
//! use lyapunov_core::{Correction, PortSample, Stabilizer, laws};
//! /// A damper that always acts.
//! #[derive(Clone)]
//! struct Damper(f64);
//! impl Stabilizer<f64> for Damper {
//!     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
//!         Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }.checked()
//!     }
//! }
//! laws::stabilizer(&Damper(2.0), laws::Samples::new(1e-3))?;
//! let broken = laws::stabilizer(&Damper(-2.0), laws::Samples::new(1e-3)).unwrap_err();
//! assert_eq!(broken.law, laws::Law::NoNegativeDamping);
//! # Ok::<(), laws::Violation>(())
//! ```

mod adaptor;
mod candidate;
mod decrease;
mod integrator;
mod ledger;
mod lyapunov_function;
mod one_port;
mod plant;
mod samples;
mod snapshot;
mod stabilizer;
mod velocity_estimator;

pub use adaptor::{Probe, adaptor};
pub use candidate::candidate;
pub use decrease::decrease;
pub use integrator::integrator;
pub use ledger::ledger;
pub use lyapunov_function::lyapunov_function;
pub use one_port::one_port;
pub use plant::plant;
pub use samples::Samples;
pub use snapshot::snapshot;
pub use stabilizer::{limiter, stabilizer};
pub use velocity_estimator::velocity_estimator;

use core::fmt;

use crate::{Mask, Scalar, Signal};

/// Property that every implementation of a trait must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Law {
    /// Finite numbers in give finite numbers out.
    Finite,
    /// Two copies that see the same do the same: all state is in the value.
    Repeatable,
    /// The reported damping and shortfall are not below 0.
    NoNegativeDamping,
    /// The correction feeds no power into the motion it sees: `(f_out − f_in) · v >= 0` up to rounding.
    Opposes,
    /// The corrected effort is between 0 and the uncorrected one, axis by axis and up to rounding.
    NoLarger,
    /// `L + α v² T + shortfall >= 0` up to rounding.
    Served,
    /// The correction is no more than the limit times the velocity.
    WithinLimit,
    /// The supplied energy is the stored, less the dissipated and the shortfall.
    Balances,
    /// A sample that is not finite gives a finite effort and is reported as not accepted.
    Rejects,
    /// After a sample that was not finite, the effort is finite again.
    Recovers,
    /// Where nothing moves and no effort is applied, nothing is credited.
    NothingForNothing,
    /// The sample reports the motion: displacements lead from position to position, the work is that of the effort
    /// over them, and the effort reported is the one applied.
    TellsTheTruth,
    /// An adaptor reports the correction of the port it owns.
    HandsOn,
    /// No lane depends on the values of the others.
    LaneByLane,
    /// The error falls with the step as the order says, towards the solution of the differential equation.
    Converges,
    /// `V(0) = 0`.
    ZeroAtRest,
    /// `V(x) > 0` away from rest.
    Positive,
    /// The gradient is the slope of `V`.
    Slope,
    /// The candidate's decreases sum to the difference of `V`.
    AddsUp,
    /// A value to which a state was restored goes on as the one it was taken from.
    Resumes,
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Finite => "finite numbers in must give finite numbers out",
            Self::Repeatable => "two copies that see the same must do the same",
            Self::NoNegativeDamping => "damping and shortfall must not be below 0",
            Self::Opposes => "the correction must not feed power into the motion",
            Self::NoLarger => "an effort that is limited must not grow or turn round",
            Self::Served => "sum, correction and shortfall together must not be below 0",
            Self::WithinLimit => "the correction must stay within its limit",
            Self::Balances => "supplied must be stored, dissipated and shortfall together",
            Self::Rejects => "a sample that is not finite must be rejected with a finite effort",
            Self::Recovers => "after a sample that is not finite, the next must be finite again",
            Self::NothingForNothing => "where nothing happens, nothing must be credited",
            Self::TellsTheTruth => "the sample must tell what moved and which effort was applied",
            Self::HandsOn => "an adaptor must hand on the correction of the port it owns",
            Self::LaneByLane => "a lane must not depend on the others",
            Self::Converges => "the error must fall with the step as the order says",
            Self::ZeroAtRest => "V must be 0 at rest",
            Self::Positive => "V must be above 0 away from rest",
            Self::Slope => "the gradient must be the slope of V",
            Self::AddsUp => "the decreases must sum to the difference of V",
            Self::Resumes => "a restored state must go on as the one it was taken from",
        })
    }
}

/// Breach of a law: which law, at which sample, with which number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// The law.
    pub law: Law,
    /// The sample, counted from 0.
    pub tick: usize,
    /// The number that breaks it.
    pub value: f64,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "sample {}: {}, but {:e} was found", self.tick, self.law, self.value)
    }
}

impl core::error::Error for Violation {}

/// Index of the tick that is being checked.
#[derive(Clone, Copy)]
struct Tick(usize);

impl Tick {
    /// Breaks `law` where `kept` is false, and reports that lane of `value`.
    fn require<T: Scalar>(self, law: Law, kept: T::Mask, value: T) -> Result<(), Violation> {
        match (0..T::LANES).find(|&lane| !kept.lane(lane)) {
            Some(lane) => Err(Violation { law, tick: self.0, value: value.lane(lane) }),
            None => Ok(()),
        }
    }

    fn finite<V: Signal>(self, law: Law, signal: V) -> Result<(), Violation> {
        self.require(law, signal.finite(), signal.sum())
    }

    /// Breaks `law` where `value` is below 0 by more than the rounding of terms as large as `size`.
    fn not_below_zero<T: Scalar>(self, law: Law, value: T, size: T) -> Result<(), Violation> {
        let rounding = T::of(16.0) * T::epsilon() * size + T::smallest_normal();
        self.require(law, !value.below(-rounding), value)
    }

    /// Breaks `law` where two signals that must be equal differ; two NaN are equal.
    fn same<V: Signal>(self, law: Law, one: V, other: V) -> Result<(), Violation> {
        let apart = one.zip(other, |a, b| {
            let zero = V::Scalar::of(0.0);
            let alike = !(a.below(b) | b.below(a)) & !(a.finite() & !b.finite());
            V::Scalar::choose(alike, zero, V::Scalar::of(1.0))
        });
        let zero = V::Scalar::of(0.0);
        self.require(law, !zero.below(apart.sum()), (one - other).sum())
    }
}
