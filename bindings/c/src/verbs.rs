//! What the functions of C do, once for all blocks.

use core::ffi::c_void;

use lyapunov::{Correction, Held, ParameterError, Scalar, Stabilizer, Work};

use crate::abi::ABI;
use crate::check;
use crate::kept::{Keep, Kind, NumberOf, Storage, WordOf};
use crate::number::Word;
use crate::port::{CorrectionForm, Port, SampleForm};
use crate::status::{Code, Status};
use crate::told::Candidate;

/// Initialization of a block in `storage` from its `parameters`.
///
/// # Safety
/// What every function of C asks of its caller: a pointer that is neither null nor misaligned leads to a variable of its
/// type, to be read, and to be written where it is not `const`, that nobody else touches meanwhile. They may overlap.
pub unsafe fn init<K: Kind>(
    storage: *mut Storage<K>,
    parameters: *const K::Parameters,
    abi: u32,
) -> Status {
    if abi != ABI {
        return Status::of(Code::OtherAbi);
    }
    if let Err(code) = check::pointer(storage).and_then(|()| check::pointer(parameters)) {
        return Status::of(code);
    }
    // SAFETY: not null, aligned, and a variable by the caller's word.
    let parameters = unsafe { parameters.read() };
    match K::build(&parameters) {
        Ok(body) => {
            let kept = K::Kept::keep(body, &parameters);
            let fresh = Storage { tag: WordOf::<K>::of(u64::from(K::TAG)), kept };
            // SAFETY: as above; what was there is numbers, of which nothing has to be dropped.
            unsafe { storage.write(fresh) };
            Status::of(Code::Ok)
        }
        Err(error) => Status::refused(Code::Parameter, error),
    }
}

/// Whether storage has the tag of its kind.
///
/// # Safety
/// `storage` is neither null nor misaligned; else as [`init`].
#[inline(always)]
pub(crate) unsafe fn has_tag<K: Kind>(storage: *const Storage<K>) -> bool {
    // SAFETY: as the caller says; every pattern of bits is a tag.
    let tag = unsafe { (&raw const (*storage).tag).read() };
    tag == WordOf::<K>::of(u64::from(K::TAG))
}

/// Whether the storage behind a pointer has the tag of its kind.
///
/// # Safety
/// As [`init`].
#[inline(always)]
unsafe fn tagged<K: Kind>(storage: *const Storage<K>) -> Result<(), Code> {
    check::pointer(storage)?;
    // SAFETY: not null, aligned, and a variable by the caller's word.
    if unsafe { has_tag(storage) } { Ok(()) } else { Err(Code::NotInitialised) }
}

/// The storage behind a pointer, if it has the tag of its kind.
///
/// # Safety
/// As [`init`]; the reference ends before the caller's call does.
#[inline(always)]
pub(crate) unsafe fn open<'a, K: Kind>(
    storage: *mut Storage<K>,
) -> Result<&'a mut Storage<K>, Code> {
    // SAFETY: as the caller says; every pattern of bits is a `Kept`, which is words or `Plain`.
    unsafe { tagged(storage).map(|()| &mut *storage) }
}

/// The storage behind a pointer, to be looked at, if it has the tag of its kind.
///
/// # Safety
/// As [`open`].
#[inline(always)]
pub(crate) unsafe fn look<'a, K: Kind>(storage: *const Storage<K>) -> Result<&'a Storage<K>, Code> {
    // SAFETY: as for `open`.
    unsafe { tagged(storage).map(|()| &*storage) }
}

/// A copy of what is kept behind a pointer, if it has the tag of its kind.
///
/// # Safety
/// As [`init`].
pub(crate) unsafe fn copy<K: Kind>(storage: *const Storage<K>) -> Result<K::Kept, Code> {
    // SAFETY: as for `open`.
    unsafe { tagged(storage).map(|()| (&raw const (*storage).kept).read()) }
}

/// Other parameters; the memory stays.
///
/// # Safety
/// As [`init`].
pub unsafe fn retune<K: Kind>(
    storage: *mut Storage<K>,
    parameters: *const K::Parameters,
) -> Status {
    // SAFETY: as the caller says; both are checked before they are followed.
    let opened = unsafe {
        check::pointer(parameters).and_then(|()| Ok((open(storage)?, parameters.read())))
    };
    let done = opened
        .map_err(Status::of)
        .and_then(|(storage, parameters)| storage.kept.retune(&parameters));
    done.err().unwrap_or(Status::of(Code::Ok))
}

/// The memory, taken out.
///
/// # Safety
/// As [`init`].
pub unsafe fn save<K: Kind>(storage: *const Storage<K>, memory: *mut K::Memory) -> u32 {
    let mut saved = K::EMPTY;
    // SAFETY: as the caller says.
    let kept = unsafe { check::pointer(memory).and_then(|()| copy(storage)) };
    let done = kept.and_then(|mut kept| kept.save(&mut saved));
    if done.is_ok() {
        // SAFETY: `memory` was checked, and is a variable by the caller's word.
        unsafe { memory.write(saved) };
    }
    done.err().unwrap_or(Code::Ok) as u32
}

/// A memory in place of the own one.
///
/// # Safety
/// As [`init`].
pub unsafe fn restore<K: Kind>(storage: *mut Storage<K>, memory: *const K::Memory) -> Status {
    // SAFETY: as the caller says; both are checked before they are followed.
    let opened =
        unsafe { check::pointer(memory).and_then(|()| Ok((open(storage)?, memory.read()))) };
    let done =
        opened.map_err(Status::of).and_then(|(storage, memory)| storage.kept.restore(&memory));
    done.err().unwrap_or(Status::of(Code::Ok))
}

/// Whether a tick can begin: nothing is null or misaligned, and the storage has its tag.
///
/// # Safety
/// As [`init`].
#[inline(always)]
unsafe fn ready<K: Kind>(
    storage: *const Storage<K>,
    sample: *const SampleForm<K::Port>,
    effort: <K::Port as Port>::Given,
    correction: *const CorrectionForm<K::Port>,
) -> bool {
    const {
        let number = align_of::<NumberOf<K>>();
        assert!(align_of::<Storage<K>>() == number && align_of::<SampleForm<K::Port>>() == number);
        assert!(align_of::<CorrectionForm<K::Port>>() == number);
    }
    let effort = K::Port::address(effort);
    check::aligned::<NumberOf<K>, 4>([storage.addr(), sample.addr(), effort, correction.addr()])
        && check::present([storage.addr(), sample.addr(), correction.addr()])
        // SAFETY: not null, aligned as a number and so as the storage, and a variable by the caller's word.
        && unsafe { has_tag(storage) }
        // By itself: four at once are compared as vectors, which takes longer.
        && effort != 0
}

/// The end of a tick that was not [`ready`]: what was wrong, told in the correction if that can be written. Out of the way of
/// the ticks that are, and one for all blocks of a signal.
///
/// # Safety
/// As [`init`].
#[cold]
#[inline(never)]
unsafe fn refuse<V: Port>(
    storage: *const V::Scalar,
    sample: *const SampleForm<V>,
    effort: V::Given,
    correction: *mut CorrectionForm<V>,
) -> u32 {
    if let Err(code) = check::pointer(correction) {
        return code as u32;
    }
    let pointers = check::pointer(sample)
        .and_then(|()| check::address::<V::Scalar>(V::address(effort)))
        .and_then(|()| check::pointer(storage));
    let code = pointers.err().unwrap_or(Code::NotInitialised);
    // SAFETY: checked, and a variable by the caller's word.
    unsafe { finish(Err(code), correction) }
}

/// The end of a tick: the correction, written.
///
/// # Safety
/// `correction` is a variable of the caller's.
#[inline(always)]
unsafe fn finish<V: Port>(
    done: Result<Correction<V>, Code>,
    correction: *mut CorrectionForm<V>,
) -> u32 {
    let (told, code) = match &done {
        // Apart from one that was rejected, so that an accepted tick ends without a jump.
        Ok(done) if done.accepted => {
            let told = CorrectionForm { accepted: 1, ..CorrectionForm::of(done) };
            // SAFETY: as the caller says.
            unsafe { correction.write(told) };
            return Code::Ok as u32;
        }
        Ok(done) => (CorrectionForm::of(done), Code::Ok),
        Err(code) => (CorrectionForm::refused(*code), *code),
    };
    // SAFETY: as the caller says.
    unsafe { correction.write(told) };
    code as u32
}

/// One tick of a stabilizer.
///
/// # Safety
/// As [`init`].
#[inline(always)]
pub unsafe fn step<K: Kind<Body: Stabilizer<K::Port>>>(
    storage: *mut Storage<K>,
    sample: *const SampleForm<K::Port>,
    effort: <K::Port as Port>::Given,
    correction: *mut CorrectionForm<K::Port>,
) -> u32 {
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word. Sample and
    // effort are read before the storage is lent and the correction is written after, so all may overlap. Every pattern of
    // bits is a `Kept`, which is words or `Plain`.
    unsafe {
        if !ready(storage, sample, effort, correction) {
            return refuse(storage.cast(), sample, effort, correction);
        }
        let (sample, effort) = (sample.read().sample(), K::Port::read(effort));
        finish((*storage).kept.lend(|body| body.stabilize(&sample, effort)), correction)
    }
}

/// What `tell` says of a block; NaN of storage that is not initialised.
///
/// # Safety
/// As [`init`].
pub unsafe fn told_by<K: Kind>(
    storage: *const Storage<K>,
    tell: impl FnOnce(&mut K::Body) -> NumberOf<K>,
) -> NumberOf<K> {
    // SAFETY: as the caller says.
    let kept = unsafe { copy(storage) };
    kept.and_then(|mut kept| kept.lend(tell)).unwrap_or(Scalar::of(f64::NAN))
}

/// A change of a block.
///
/// # Safety
/// As [`init`].
pub unsafe fn change<K: Kind>(storage: *mut Storage<K>, change: impl FnOnce(&mut K::Body)) -> u32 {
    // SAFETY: as the caller says.
    let done = unsafe { open(storage) }.and_then(|it| it.kept.lend(change));
    done.err().unwrap_or(Code::Ok) as u32
}

/// A change that a block may refuse.
///
/// # Safety
/// As [`init`].
pub unsafe fn ask<K: Kind>(
    storage: *mut Storage<K>,
    change: impl FnOnce(&mut K::Body) -> Result<(), ParameterError>,
) -> Status {
    // SAFETY: as the caller says.
    match unsafe { open(storage) }.and_then(|it| it.kept.lend(change)) {
        Ok(Ok(())) => Status::of(Code::Ok),
        Ok(Err(error)) => Status::refused(Code::Parameter, error),
        Err(code) => Status::of(code),
    }
}

/// One tick of a stabilizer whose candidate is a function of C; `tell` hands its value to the block.
///
/// # Safety
/// As [`init`]; `function` can be called with `context` and a sample.
#[inline(always)]
pub unsafe fn called<K: Kind<Body: Stabilizer<K::Port>>>(
    storage: *mut Storage<K>,
    sample: *const SampleForm<K::Port>,
    effort: <K::Port as Port>::Given,
    (function, context): (Candidate<K::Port>, *mut c_void),
    correction: *mut CorrectionForm<K::Port>,
    tell: impl FnOnce(&mut K::Body, NumberOf<K>),
) -> u32 {
    // SAFETY: as for `step`; nothing of the storage is lent while the function of the caller runs.
    unsafe {
        if !ready(storage, sample, effort, correction) {
            return refuse(storage.cast(), sample, effort, correction);
        }
        let Some(function) = function else {
            return finish(Err(Code::Null), correction);
        };
        let (sample, effort) = (sample.read().sample(), K::Port::read(effort));
        let seen = <Held as Work>::sample(&sample, no_effort::<K::Port>());
        let value = function(context, &SampleForm::of(&seen));
        let done = (*storage).kept.lend(|body| {
            tell(body, value);
            body.stabilize(&sample, effort)
        });
        finish(done, correction)
    }
}

/// No effort: held work does not ask for it.
pub(crate) fn no_effort<V: Port>() -> V {
    V::splat(Scalar::of(0.0))
}
