//! Functions under their names in C, and their description.

/// Functions of C: each is written once, here, and described from the same line.
macro_rules! exported {
    ($name:literal, $signal:literal, $describe:ident; $(
        $(#[doc = $doc:literal])+
        fn $verb:ident ($($argument:ident: $type:ty),* $(,)?) -> $returned:ty { $($body:tt)* }
    )*) => {
        $(
            $(#[doc = $doc])+
            ///
            /// # Safety
            /// A pointer that is neither null nor misaligned leads to a variable of its type that nobody else touches
            /// meanwhile.
            #[unsafe(export_name = concat!("lyapunov_", $name, "_", $signal, "_", stringify!($verb)))]
            pub unsafe extern "C" fn $verb($($argument: $type),*) -> $returned {
                $($body)*
            }
        )*

        /// Describes the functions.
        #[cfg(feature = "describe")]
        pub fn $describe(header: &mut $crate::describe::Header) {
            use $crate::describe::CType;
            $(
                header.function(
                    concat!("lyapunov_", $name, "_", $signal, "_", stringify!($verb)),
                    &[$($doc),+],
                    <$returned as CType>::name(),
                    &[$((stringify!($argument), <$type as CType>::name())),*],
                );
            )*
        }
    };
}

/// One block on one signal, in a module.
macro_rules! block_on {
    (
        $module:ident, $signal:literal, [$port:ty], [$number:ty];
        $(#[doc = $doc:literal])+
        $name:literal;
        $value:ty, $keep:ident $($numbers:literal + $per_axis:literal)?;
        { $($(#[doc = $told:literal])+ $field:ident: $type:ty,)* };
        |$given:ident| $build:expr;
        [$($verbs:ident)*]
    ) => {
        /// On one kind of signal.
        pub mod $module {
            #![allow(unused_imports)]
            use super::*;
            use $crate::kept::{Kind, Storage, Whole, Words};
            use $crate::port::{CorrectionForm, Port, SampleForm};
            use $crate::flat::Flat;
            use $crate::status::Status;
            use $crate::blocks::lolc::$module as lolc;
            use $crate::export::{kept, verbs};

            /// The number.
            pub type T = $number;
            /// The signal.
            pub type V = $port;
            /// The signal as C has it.
            pub type Form = <V as Port>::Form;
            type Word = <T as $crate::number::Number>::Word;
            /// How many axes it has.
            pub const AXES: usize = size_of::<Form>() / size_of::<T>();

            /// Parameters.
            #[derive(Clone, Copy, Debug)]
            #[repr(C)]
            pub struct Parameters {
                $($(#[doc = $told])+ pub $field: $type,)*
            }

            impl Flat<Word> for Parameters {
                const WORDS: usize = 0 $(+ <$type as Flat<Word>>::WORDS)*;

                fn put(&self, out: &mut impl FnMut(Word)) {
                    $(Flat::<Word>::put(&self.$field, out);)*
                }

                fn take(from: &mut impl FnMut() -> Word) -> Self {
                    Self { $($field: <$type as Flat<Word>>::take(from),)* }
                }
            }

            /// Memory without the parameters, as words.
            #[derive(Clone, Copy, Debug)]
            #[repr(C)]
            pub struct Memory {
                /// The words.
                pub word: [Word; MEMORY],
            }

            impl AsRef<[Word]> for Memory {
                fn as_ref(&self) -> &[Word] {
                    &self.word
                }
            }

            impl AsMut<[Word]> for Memory {
                fn as_mut(&mut self) -> &mut [Word] {
                    &mut self.word
                }
            }

            /// The kind.
            #[derive(Clone, Copy, Debug)]
            pub struct Block;

            type Value = $value;
            type State = <Value as lyapunov::Snapshot>::State;
            const MEMORY: usize = <State as Flat<Word>>::WORDS;

            impl Kind for Block {
                type Port = V;
                type Parameters = Parameters;
                type Body = Value;
                type Kept = kept!($keep);
                type Memory = Memory;
                const TAG: u32 = $crate::abi::tag($name, $signal);
                const EMPTY: Memory = Memory { word: [0; MEMORY] };

                #[inline(always)]
                fn build($given: &Parameters) -> Result<Value, lyapunov::ParameterError> {
                    $build
                }
            }

            $(
                // SAFETY: the fields of the value, and of the values in it, are numbers of the port and nothing else: the
                // assertion below counts them, and a test under Miri reads every byte.
                unsafe impl $crate::kept::Plain for Block {}

                const _: () = assert!(
                    size_of::<Value>()
                        == ($numbers + $per_axis * AXES) * size_of::<T>()
                );
            )?

            const _: () = assert!(align_of::<Storage<Block>>() == align_of::<T>());

            /// Describes the block.
            #[cfg(feature = "describe")]
            pub fn describe(header: &mut $crate::describe::Header) {
                use $crate::describe::{CType, Field};
                let name = concat!("lyapunov_", $name, "_", $signal);
                header.block(name, &[$($doc),+]);
                header.parameters::<Block>(name, &[$(Field {
                    name: stringify!($field),
                    c_type: <$type as CType>::name(),
                    offset: core::mem::offset_of!(Parameters, $field),
                    about: &[$($told),+],
                }),*]);
                header.storage::<Block>(name);
                $($verbs::describe(header);)*
            }

            $(
                /// Functions of the block.
                pub mod $verbs {
                    use super::*;
                    $crate::export::verbs! { $verbs, $name, $signal }
                }
            )*

            // Names, as the functions are described by their types.
            #[cfg(feature = "describe")]
            impl $crate::describe::CType for Storage<Block> {
                fn name() -> std::string::String {
                    concat!("lyapunov_", $name, "_", $signal).into()
                }
            }

            #[cfg(feature = "describe")]
            impl $crate::describe::CType for Parameters {
                fn name() -> std::string::String {
                    concat!("lyapunov_", $name, "_", $signal, "_parameters").into()
                }
            }

            #[cfg(feature = "describe")]
            impl $crate::describe::CType for Memory {
                fn name() -> std::string::String {
                    concat!("lyapunov_", $name, "_", $signal, "_memory").into()
                }
            }
        }
    };
}

/// How storage keeps a value.
macro_rules! kept {
    (whole) => { Whole<Value> };
    (words) => { Words<Block, { <Parameters as Flat<Word>>::WORDS + MEMORY }> };
}

/// Groups of functions.
macro_rules! verbs {
    (life, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
            /// version of the header.
            fn init_abi(storage: *mut Storage<Block>, parameters: *const Parameters, abi: u32) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::init(storage, parameters, abi) }
            }
            /// Changes the parameters between ticks; the memory stays. A refused change changes nothing.
            fn retune(storage: *mut Storage<Block>, parameters: *const Parameters) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::retune(storage, parameters) }
            }
            /// Takes the memory out, to be stored over a restart.
            fn save(storage: *const Storage<Block>, memory: *mut Memory) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::save(storage, memory) }
            }
            /// Puts a stored memory in place of the own one. A refused one changes nothing.
            fn restore(storage: *mut Storage<Block>, memory: *const Memory) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::restore(storage, memory) }
            }
        }
    };
    (stabilizer, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// One tick: what the other side did, and the effort that your controller asks for; out comes the correction.
            fn step(storage: *mut Storage<Block>, sample: *const SampleForm<V>, effort: <V as Port>::Given, correction: *mut CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::step(storage, sample, effort, correction) }
            }
        }
    };
    (custom, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch
            /// this storage. A value that is not finite rejects the sample.
            fn step(storage: *mut Storage<Block>, sample: *const SampleForm<V>, effort: <V as Port>::Given, candidate: $crate::told::Candidate<V>, context: *mut core::ffi::c_void, correction: *mut CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::called(storage, sample, effort, (candidate, context), correction, |body, value| body.candidate_mut().decrease = value) }
            }
        }
    };
    (storage, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage.
            fn step(storage: *mut Storage<Block>, sample: *const SampleForm<V>, effort: <V as Port>::Given, energy: $crate::told::Energy<V>, context: *mut core::ffi::c_void, correction: *mut CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::called(storage, sample, effort, (energy, context), correction, |body, value| body.candidate_mut().now = value) }
            }
        }
    };
    (observer, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Books a sample; writes the observed energy, J. A decrease that is not finite is left out.
            fn observe(storage: *mut Storage<Block>, sample: *const SampleForm<V>, energy: *mut T) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::watched::observe(storage, sample, energy) }
            }
        }
    };
    (meter, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Adds a tick.
            fn add(storage: *mut Storage<Block>, sample: *const SampleForm<V>, correction: *const CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::watched::add(storage, sample, correction) }
            }
            /// Writes the energies up to now.
            fn summary(storage: *const Storage<Block>, summary: *mut $crate::watched::SummaryForm<T>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::watched::summary(storage, summary) }
            }
        }
    };
    (reading, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of this tick's reading: the position now, and the effort that the motor applied since the last.
            fn read(storage: *mut Storage<Block>, position: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, applied], checked, |body, [position, applied]| body.read(Reading { position, applied })) }
            }
            /// The sample of a tick without a reading.
            fn missed(storage: *mut Storage<Block>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed(applied)) }
            }
        }
    };
    (moving_reading, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last.
            fn read_moving(storage: *mut Storage<Block>, position: <V as Port>::Given, velocity: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, velocity, applied], checked, |body, [position, velocity, applied]| body.read_moving(MovingReading { position, velocity, applied })) }
            }
            /// The sample of a tick without a reading.
            fn missed_moving(storage: *mut Storage<Block>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed_moving(applied)) }
            }
        }
    };
    (reading_at, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of the reading at the time `now`, s from any start.
            fn read_at(storage: *mut Storage<Block>, now: f64, position: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, applied], checked, |body, [position, applied]| body.read_at(now, Reading { position, applied })) }
            }
            /// The sample of a tick without a reading at the time `now`, s.
            fn missed_at(storage: *mut Storage<Block>, now: f64, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed_at(now, applied)) }
            }
        }
    };
    (moving_reading_at, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of the reading at the time `now`, s from any start.
            fn read_moving_at(storage: *mut Storage<Block>, now: f64, position: <V as Port>::Given, velocity: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, velocity, applied], checked, |body, [position, velocity, applied]| body.read_moving_at(now, MovingReading { position, velocity, applied })) }
            }
            /// The sample of a tick without a reading at the time `now`, s.
            fn missed_moving_at(storage: *mut Storage<Block>, now: f64, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed_moving_at(now, applied)) }
            }
        }
    };
    (place, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read.
            fn restart(storage: *mut Storage<Block>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| body.restart()) }
            }
        }
    };
    (side, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised.
            fn absorbed(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| body.absorbed()) }
            }
            /// What the other side said it absorbed, J. Packets may come late, twice or not at all.
            fn receive(storage: *mut Storage<Block>, energy: T) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| body.receive(energy)) }
            }
        }
    };
    (layer, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// What this side sent since the start, J, to be told the other; NaN if the storage is not initialised.
            fn sent(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| body.sent()) }
            }
            /// What the other side said it sent, J. Packets may come late, twice or not at all.
            fn receive(storage: *mut Storage<Block>, energy: T) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| body.receive(energy)) }
            }
        }
    };
    (account, $name:literal, $signal:literal) => {
        use lyapunov::stabilizers::Account;

        $crate::export::exported! { $name, $signal, describe;
            /// The observed energy, J; NaN if the storage is not initialised.
            fn observed_energy(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| Account::observed_energy(body)) }
            }
            /// Sets the observed energy to 0: credit is forfeited, a debt forgiven.
            fn reset(storage: *mut Storage<Block>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| Account::<T>::reset(body)) }
            }
            /// Adds as many joules of credit that were not absorbed.
            fn grant(storage: *mut Storage<Block>, energy: T) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::ask(storage, |body| Account::<T>::grant(body, energy)) }
            }
            /// Adds a debt of as many joules.
            fn owe(storage: *mut Storage<Block>, debt: T) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::ask(storage, |body| Account::<T>::owe(body, debt)) }
            }
        }
    };
}

/// Blocks, an entry for each: a name, the signals, the value and how it is kept, its parameters, how it is made of them, and
/// the groups of functions. `V` is the signal, `T` its number, `Form` the signal as C has it.
macro_rules! blocks {
    ($(
        $(#[doc = $doc:literal])+
        $module:ident on $signals:ident = $entry:tt
    )*) => {
        $(
            $(#[doc = $doc])+
            pub mod $module {
                use super::*;
                $crate::export::on! { $signals [$(#[doc = $doc])+] $entry }
            }
        )*

        #[cfg(feature = "describe")]
        pub(super) fn describe(header: &mut $crate::describe::Header) {
            $($module::describe(header);)*
        }
    };
}

/// An entry on a set of signals.
macro_rules! on {
    (every $about:tt $entry:tt) => {
        $crate::export::each! { $about $entry [of_f32 "f32" f32 f32] [of_f64 "f64" f64 f64]
            [of_f32x3 "f32x3" (nalgebra::SVector<f32, 3>) f32] [of_f64x3 "f64x3" (nalgebra::SVector<f64, 3>) f64]
            [of_f32x6 "f32x6" (nalgebra::SVector<f32, 6>) f32] [of_f64x6 "f64x6" (nalgebra::SVector<f64, 6>) f64]
            [of_f32screw "f32screw" (lyapunov::poses::Screw<f32>) f32] [of_f64screw "f64screw" (lyapunov::poses::Screw<f64>) f64] }
    };
    (line $about:tt $entry:tt) => {
        $crate::export::each! { $about $entry [of_f32 "f32" f32 f32] [of_f64 "f64" f64 f64] }
    };
    (spaces $about:tt $entry:tt) => {
        $crate::export::each! { $about $entry
            [of_f32x3 "f32x3" (nalgebra::SVector<f32, 3>) f32] [of_f64x3 "f64x3" (nalgebra::SVector<f64, 3>) f64]
            [of_f32x6 "f32x6" (nalgebra::SVector<f32, 6>) f32] [of_f64x6 "f64x6" (nalgebra::SVector<f64, 6>) f64] }
    };
    (axes $about:tt $entry:tt) => {
        $crate::export::each! { $about $entry [of_f32 "f32" f32 f32] [of_f64 "f64" f64 f64]
            [of_f32x3 "f32x3" (nalgebra::SVector<f32, 3>) f32] [of_f64x3 "f64x3" (nalgebra::SVector<f64, 3>) f64]
            [of_f32x6 "f32x6" (nalgebra::SVector<f32, 6>) f32] [of_f64x6 "f64x6" (nalgebra::SVector<f64, 6>) f64] }
    };
    (bodies $about:tt $entry:tt) => {
        $crate::export::each! { $about $entry
            [of_f32screw "f32screw" (lyapunov::poses::Screw<f32>) f32] [of_f64screw "f64screw" (lyapunov::poses::Screw<f64>) f64] }
    };
}

/// An entry on each of the signals listed.
macro_rules! each {
    ($about:tt $entry:tt $([$module:ident $signal:literal $port:tt $number:tt])*) => {
        $($crate::export::one! { $module $signal $port $number $about $entry })*

        #[cfg(feature = "describe")]
        pub(super) fn describe(header: &mut $crate::describe::Header) {
            $($module::describe(header);)*
        }
    };
}

/// An entry on one signal.
macro_rules! one {
    ($module:ident $signal:literal $port:tt $number:tt [$($about:tt)*] { $($entry:tt)* }) => {
        $crate::export::block_on! { $module, $signal, [$crate::export::bare!($port)], [$number]; $($about)* $($entry)* }
    };
}

/// A type without the parentheses around it.
macro_rules! bare {
    (($port:ty)) => {
        $port
    };
    ($port:ty) => {
        $port
    };
}

pub(crate) use {bare, block_on, blocks, each, exported, kept, on, one, verbs};
