//! Functions of blocks that are asked something of signals, beside a stabilizer's tick.

use lyapunov::{ParameterError, Requirement, Scalar, Snapshot};

use crate::check;
use crate::export::form;
use crate::kept::{Keep, Kind, Plain, Storage, Whole};
use crate::port::Port;
use crate::status::Code;
use crate::verbs::{look, open};

form! {
    /// End of a line of waves, in C `lyapunov_wave_f64` and kin: what is there, and what travels.
    #[derive(Clone, Copy, Debug)]
    pub struct WaveForm<V: Port> {
        /// The flow, m/s.
        pub flow: V::Form,
        /// The effort, N.
        pub effort: V::Form,
        /// The wave that travels with the flow, root of W: (b v + F) / sqrt(2 b) of an impedance b, a flow v and an effort F.
        pub there: V::Form,
        /// The wave that comes back, root of W: (b v - F) / sqrt(2 b).
        pub back: V::Form,
    }
}

impl<V: Port> WaveForm<V> {
    /// The form of an end.
    pub fn of(flow: V, effort: V, (there, back): (V, V)) -> Self {
        let (flow, effort) = (flow.form(), effort.form());
        Self { flow, effort, there: there.form(), back: back.form() }
    }
}

impl<V: Port> Default for WaveForm<V> {
    fn default() -> Self {
        let zero = V::splat(Scalar::of(0.0));
        Self::of(zero, zero, (zero, zero))
    }
}

/// Value without memory.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<B>(pub B);

impl<B> Snapshot for Fixed<B> {
    /// One word that says nothing: C has no empty structs.
    type State = u32;

    fn state(&self) -> u32 {
        0
    }

    fn restored(self, state: u32) -> Result<Self, ParameterError> {
        Requirement::AtMost(0.0).check("stored word", f64::from(state))?;
        Ok(self)
    }
}

/// The answer of a block to signals, which it remembers; each of `given` is read first. A call that does nothing gives zeros.
///
/// # Safety
/// As [`init`](crate::verbs::init).
#[inline(always)]
pub unsafe fn answer<K: Kind, O: Copy + Default, const N: usize>(
    storage: *mut Storage<K>,
    given: [<K::Port as Port>::Given; N],
    out: *mut O,
    answer: impl FnOnce(&mut K::Body, [K::Port; N]) -> O,
) -> u32 {
    // SAFETY: as the caller says; the storage is lent after all else was read.
    unsafe { write(given, out, |given| open(storage)?.kept.lend(|body| answer(body, given))) }
}

/// The answer of a block without memory, as [`answer`] gives it.
///
/// # Safety
/// As [`init`](crate::verbs::init).
#[inline(always)]
pub unsafe fn answer_of<B, K, O: Copy + Default, const N: usize>(
    storage: *const Storage<K>,
    given: [<K::Port as Port>::Given; N],
    out: *mut O,
    answer: impl FnOnce(&B, [K::Port; N]) -> O,
) -> u32
where
    K: Plain<Body = Fixed<B>, Kept = Whole<Fixed<B>>>,
{
    // SAFETY: as the caller says; the storage is looked at after all else was read.
    unsafe { write(given, out, |given| Ok(answer(&look(storage)?.kept.value().0, given))) }
}

/// Writes what `answer` makes of signals, or zeros.
///
/// # Safety
/// As [`init`](crate::verbs::init).
#[inline(always)]
unsafe fn write<V: Port, O: Copy + Default, const N: usize>(
    given: [V::Given; N],
    out: *mut O,
    answer: impl FnOnce([V; N]) -> Result<O, Code>,
) -> u32 {
    if let Err(code) = check::pointer(out) {
        return code as u32;
    }
    let mut addresses = given.into_iter().map(V::address);
    let sound = addresses.try_for_each(check::address::<V::Scalar>);
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word; all are read
    // before the storage is, and the answer is written after.
    unsafe {
        let done = sound.and_then(|()| answer(given.map(|given| V::read(given))));
        out.write(done.unwrap_or_default());
        done.err().unwrap_or(Code::Ok) as u32
    }
}
