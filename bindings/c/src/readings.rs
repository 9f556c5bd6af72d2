//! Readings in C: what a device tells, and the sample that becomes of it.

use lyapunov::CheckedSample;

use crate::check;
use crate::export::form;
use crate::kept::{Keep, Kind, NumberOf, Storage};
use crate::port::{Port, SampleForm};
use crate::status::Code;
use crate::verbs::has_tag;

form! {
    /// Sample of a reading, and what was found in it; in C `lyapunov_checked_sample_f64` and kin.
    #[derive(Clone, Copy, Debug)]
    pub struct CheckedForm<V: Port> {
        /// The sample, for your controller and a stabilizer. Of a reading that was not accepted it stands still, and its work
        /// is NaN, so that a stabilizer that reads the work rejects it; a sampled account does not read it: look at
        /// `accepted`.
        pub sample: SampleForm<V>,
        /// 1 if the reading was accepted, else 0.
        pub accepted: u32,
        /// 1 if the position was farther away than the fastest motion leads.
        pub jumped: u32,
        /// 1 if a tick was missed since the last accepted reading.
        pub late: u32,
        /// 1 if the time could be used; always 1 at a fixed period.
        pub timed: u32,
    }
}

impl<V: Port> CheckedForm<V> {
    /// The form of a checked sample.
    #[inline(always)]
    pub fn of(checked: &CheckedSample<V>) -> Self {
        Self {
            sample: SampleForm::of(&checked.sample),
            accepted: u32::from(checked.accepted),
            jumped: u32::from(checked.jumped),
            late: u32::from(checked.late),
            timed: u32::from(checked.timed),
        }
    }

    /// The form of a call that did nothing: a sample that every stabilizer rejects.
    fn refused() -> Self {
        let (nothing, none) = (V::splat(lyapunov::Scalar::of(f64::NAN)), lyapunov::Scalar::of(0.0));
        let zero = V::splat(none).form();
        let sample = SampleForm {
            period: none,
            position: zero,
            velocity: zero,
            displacement: zero,
            applied: zero,
            work: nothing.form(),
        };
        Self { sample, accepted: 0, jumped: 0, late: 0, timed: 0 }
    }
}

/// A reading through `read`; each of `given` is read first.
///
/// # Safety
/// As [`init`](crate::verbs::init).
#[inline(always)]
pub unsafe fn read<K: Kind, const N: usize>(
    storage: *mut Storage<K>,
    given: [<K::Port as Port>::Given; N],
    checked: *mut CheckedForm<K::Port>,
    read: impl FnOnce(&mut K::Body, [K::Port; N]) -> CheckedSample<K::Port>,
) -> u32 {
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word; all are read
    // before the storage is lent.
    unsafe {
        let (signals, others) = (given.map(K::Port::address), [storage.addr(), checked.addr()]);
        if !check::aligned::<NumberOf<K>, 2>(others)
            || !check::aligned::<NumberOf<K>, N>(signals)
            || !check::present(others)
            || !has_tag(storage)
            || !check::present(signals)
        {
            return refuse(storage.cast(), given, checked);
        }
        let signals = given.map(|given| K::Port::read(given));
        finish((*storage).kept.lend(|body| read(body, signals)), checked)
    }
}

/// The end of a reading that could not begin: what was wrong, told if it can be. Out of the way of those that could.
///
/// # Safety
/// As [`init`](crate::verbs::init).
#[cold]
#[inline(never)]
pub(crate) unsafe fn refuse<V: Port, const N: usize>(
    storage: *const V::Scalar,
    given: [V::Given; N],
    checked: *mut CheckedForm<V>,
) -> u32 {
    if let Err(code) = check::pointer(checked) {
        return code as u32;
    }
    let mut addresses = given.into_iter().map(V::address);
    let pointers = addresses.try_for_each(check::address::<V::Scalar>);
    let code = pointers.and_then(|()| check::pointer(storage)).err();
    // SAFETY: checked, and a variable by the caller's word.
    unsafe { finish(Err(code.unwrap_or(Code::NotInitialised)), checked) }
}

/// The end of a reading: its sample, written.
///
/// # Safety
/// `checked` is a variable of the caller's.
#[inline(always)]
unsafe fn finish<V: Port>(
    done: Result<CheckedSample<V>, Code>,
    checked: *mut CheckedForm<V>,
) -> u32 {
    let (told, code) = match &done {
        Ok(sample) => (CheckedForm::of(sample), Code::Ok),
        Err(code) => (CheckedForm::refused(), *code),
    };
    // SAFETY: as the caller says.
    unsafe { checked.write(told) };
    code as u32
}
