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

/// The pointers that C hands over.
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

/// Whether the storage behind a pointer has the tag of its kind.
///
/// # Safety
/// As [`init`].
#[inline(always)]
unsafe fn tagged<K: Kind>(storage: *const Storage<K>) -> Result<(), Code> {
    check::pointer(storage)?;
    // SAFETY: not null, aligned, and a variable by the caller's word; every pattern of bits is a tag.
    let tag = unsafe { (&raw const (*storage).tag).read() };
    if tag == WordOf::<K>::of(u64::from(K::TAG)) { Ok(()) } else { Err(Code::NotInitialised) }
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
    match opened {
        Ok((storage, parameters)) => match storage.kept.retune(&parameters) {
            Ok(()) => Status::of(Code::Ok),
            Err(status) => status,
        },
        Err(code) => Status::of(code),
    }
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
    match opened {
        Ok((storage, memory)) => match storage.kept.restore(&memory) {
            Ok(()) => Status::of(Code::Ok),
            Err(status) => status,
        },
        Err(code) => Status::of(code),
    }
}

/// One tick, with `stabilize` in the middle.
///
/// # Safety
/// As [`init`].
#[inline(always)]
pub(crate) unsafe fn tick<K: Kind>(
    storage: *mut Storage<K>,
    sample: *const SampleForm<K::Port>,
    effort: <K::Port as Port>::Given,
    correction: *mut CorrectionForm<K::Port>,
    stabilize: impl FnOnce(&mut K::Body, SampleForm<K::Port>, K::Port) -> Correction<K::Port>,
) -> u32 {
    if let Err(code) = check::pointer(correction) {
        return code as u32;
    }
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word. Sample and
    // effort are read before the storage is lent and the correction is written after, so all may overlap.
    let done = unsafe {
        check::pointer(sample).and_then(|()| {
            let (sample, effort) = (sample.read(), K::Port::given(effort)?);
            open(storage)?.kept.lend(|body| stabilize(body, sample, K::Port::of(effort)))
        })
    };
    let (told, code) = match &done {
        Ok(done) => (CorrectionForm::of(done), Code::Ok),
        Err(code) => (CorrectionForm::refused(*code), *code),
    };
    // SAFETY: checked above.
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
    // SAFETY: as the caller says.
    unsafe {
        tick(storage, sample, effort, correction, |body, sample, effort| {
            body.stabilize(&sample.sample(), effort)
        })
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
    // SAFETY: each pointer is checked before it is followed, and leads to a variable by the caller's word; nothing of the
    // storage is lent while the function of the caller runs.
    let value = unsafe {
        open(storage).and_then(|_| {
            check::pointer(sample)?;
            let seen = <Held as Work>::sample(&sample.read().sample(), no_effort::<K::Port>());
            let function = function.ok_or(Code::Null)?;
            Ok(function(context, &SampleForm::of(&seen)))
        })
    };
    match value {
        // SAFETY: as the caller says.
        Ok(value) => unsafe {
            tick(storage, sample, effort, correction, |body, sample, effort| {
                tell(body, value);
                body.stabilize(&sample.sample(), effort)
            })
        },
        Err(code) => {
            if check::pointer(correction).is_ok() {
                // SAFETY: checked, and a variable by the caller's word.
                unsafe { correction.write(CorrectionForm::refused(code)) };
            }
            code as u32
        }
    }
}

/// No effort: held work does not ask for it.
pub(crate) fn no_effort<V: Port>() -> V {
    V::splat(Scalar::of(0.0))
}
