//! Observers and energy meters, with their parameters.

use lyapunov::telemetry::{EnergyMeter, EnergySummary};
use lyapunov::{Held, Mask, Observer, ParameterError, Signal, Snapshot, accumulators::Plain};

use crate::check;
use crate::export::form;
use crate::kept::{Keep, Kind, NumberOf, Storage};
use crate::number::Number;
use crate::port::{CorrectionForm, SampleForm};
use crate::status::Code;
use crate::verbs::{copy, no_effort, open};

/// Observer of held work in one number.
pub type Observing<T, C> = Observer<C, Held, Plain<T>>;

/// One sample, booked.
///
/// # Safety
/// As [`init`](crate::verbs::init).
pub unsafe fn observe<K, C>(
    storage: *mut Storage<K>,
    sample: *const SampleForm<K::Port>,
    energy: *mut NumberOf<K>,
) -> u32
where
    K: Kind<Body = Observing<NumberOf<K>, C>>,
    C: lyapunov::LyapunovCandidate<K::Port>,
{
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word.
    let done = unsafe {
        check::pointer(energy).and_then(|()| {
            check::pointer(sample)?;
            let sample = sample.read().sample();
            let zero = no_effort::<K::Port>();
            let sum = open(storage)?.kept.lend(|body| body.observe(&sample, zero))?;
            energy.write(sum);
            Ok(())
        })
    };
    done.err().unwrap_or(Code::Ok) as u32
}

/// Meter with its memory as a value of its own.
#[derive(Clone, Copy, Debug)]
pub struct Meter<T>(pub EnergyMeter<T>);

impl<T: Number> Snapshot for Meter<T> {
    type State = <EnergyMeter<T> as Snapshot>::State;

    fn state(&self) -> Self::State {
        self.0.state()
    }

    fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
        Ok(Self(self.0.restored(state)?))
    }
}

form! {
    /// Summary of C.
    #[derive(Clone, Copy, Debug)]
    pub struct SummaryForm<T: Number> {
        /// Number of ticks.
        pub ticks: u64,
        /// Number of ticks with an injected damping above 0.
        pub active: T,
        /// Number of ticks whose sample was not accepted.
        pub rejected: T,
        /// The observed energy now, J.
        pub now: T,
        /// The least observed energy so far, J; below 0 it is the largest debt.
        pub least: T,
        /// The most observed energy so far, J.
        pub most: T,
        /// Energy that the injected damping was meant to dissipate, J.
        pub asked: T,
        /// Energy that flowed through the port into the environment, J; below 0 the port gave energy away.
        pub absorbed: T,
        /// The shortfall now, J.
        pub shortfall: T,
        /// The largest shortfall so far, J.
        pub largest_shortfall: T,
        /// 0: every byte is a field's, so that summaries can be compared by memcmp.
        pub fill: T::Fill,
    }
}

impl<T: Number> SummaryForm<T> {
    /// The form of a summary.
    pub fn of(summary: EnergySummary<T>) -> Self {
        let EnergySummary { ticks, active, rejected, now, least, most, .. } = summary;
        let EnergySummary { asked, absorbed, shortfall, largest_shortfall, .. } = summary;
        Self {
            ticks,
            active,
            rejected,
            now,
            least,
            most,
            asked,
            absorbed,
            shortfall,
            largest_shortfall,
            fill: T::Fill::default(),
        }
    }
}

/// Adds a tick to a meter. A correction with an energy that is not finite is left out: no block gives one.
///
/// # Safety
/// As [`init`](crate::verbs::init).
pub unsafe fn add<K: Kind<Body = Meter<NumberOf<K>>>>(
    storage: *mut Storage<K>,
    sample: *const SampleForm<K::Port>,
    correction: *const CorrectionForm<K::Port>,
) -> u32 {
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word.
    let done = unsafe {
        check::pointer(sample).and_then(|()| {
            check::pointer(correction)?;
            let (sample, correction) = (sample.read().sample(), correction.read().correction());
            // Each by itself: their sum may be beyond the range where neither is.
            let sound = correction.observed_energy.finite() & correction.shortfall.finite();
            let add = |meter: &mut Meter<_>| meter.0.add(&sample, &correction);
            let storage = open(storage)?;
            if sound.all() { storage.kept.lend(add) } else { Ok(()) }
        })
    };
    done.err().unwrap_or(Code::Ok) as u32
}

/// Writes the summary of a meter.
///
/// # Safety
/// As [`init`](crate::verbs::init).
pub unsafe fn summary<K: Kind<Body = Meter<NumberOf<K>>>>(
    storage: *const Storage<K>,
    summary: *mut SummaryForm<NumberOf<K>>,
) -> u32 {
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word.
    let done = unsafe {
        check::pointer(summary).and_then(|()| {
            let mut kept = copy(storage)?;
            summary.write(SummaryForm::of(kept.lend(|meter| meter.0.summary())?));
            Ok(())
        })
    };
    done.err().unwrap_or(Code::Ok) as u32
}
