//! Candidates whose values a function of the caller gives.

use core::ffi::c_void;

use lyapunov::{
    LyapunovCandidate, ParameterError, PortSample, Requirement, Signal, Snapshot, StorageFunction,
};

use crate::number::Number;
use crate::port::{Port, SampleForm};

/// Candidate as a function in C: the decrease over a sample, J.
pub type Candidate<V> =
    Option<unsafe extern "C" fn(*mut c_void, *const SampleForm<V>) -> <V as Signal>::Scalar>;

/// Storage function in C: the energy at the sample's position and velocity, J.
pub type Energy<V> = Candidate<V>;

/// Candidate whose decrease was told before the tick, so that storage holds neither function nor context.
#[derive(Clone, Copy, Debug)]
pub struct Told<T> {
    /// The decrease, J.
    pub decrease: T,
}

impl<V: Port> LyapunovCandidate<V> for Told<V::Scalar> {
    #[inline(always)]
    fn decrease(&mut self, _sample: &PortSample<V>) -> V::Scalar {
        self.decrease
    }
}

impl<T: Number> Snapshot for Told<T> {
    type State = ();

    fn state(&self) {}

    fn restored(self, _state: ()) -> Result<Self, ParameterError> {
        Ok(self)
    }
}

/// Storage function whose value was told before the tick: `StorageFunction` itself does the rest.
#[derive(Clone, Copy, Debug)]
pub struct ToldEnergy<T> {
    /// The energy now, J.
    pub now: T,
    /// The last one that was finite, J.
    last: T,
}

impl<T: Number> ToldEnergy<T> {
    /// The candidate of a loop that starts with `energy`.
    pub fn starting(energy: T) -> Result<Self, ParameterError> {
        let last = Requirement::Finite.check("energy at the start", energy)?;
        Ok(Self { now: last, last })
    }
}

impl<V: Port> LyapunovCandidate<V> for ToldEnergy<V::Scalar> {
    #[inline(always)]
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let (now, zero) = (self.now, V::zero());
        let function = StorageFunction::starting(|_: V, _: V| now, zero, zero);
        // The last energy is finite: it was one that was kept, or checked.
        let Ok(mut function) = function.restored(self.last) else { return now };
        let decrease = function.decrease(sample);
        self.last = function.state();
        decrease
    }
}

impl<T: Number> Snapshot for ToldEnergy<T> {
    /// The last energy, J.
    type State = T;

    fn state(&self) -> T {
        self.last
    }

    fn restored(self, last: T) -> Result<Self, ParameterError> {
        Ok(Self { last: Requirement::Finite.check("stored energy", last)?, ..self })
    }
}
