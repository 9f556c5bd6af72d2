//! Functions under their names in C, and their description.

mod entries;
mod form;
mod verbs;

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
        $value:ty, $keep:ident $($numbers:literal + $per_axis:tt)?;
        { $($(#[doc = $told:literal])+ $field:ident: $type:ty $(=> $retuned:tt)?,)* };
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
            /// Its number of axes.
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

            impl $crate::retuned::Retuned for Parameters {
                fn retuned(&self) -> Self {
                    Self { $($field: $crate::retuned::retuned!(self $field $($retuned)?),)* }
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

/// The type that keeps a value in storage.
macro_rules! kept {
    (whole) => { Whole<Value> };
    (words) => { Words<Block, { <Parameters as Flat<Word>>::WORDS + MEMORY }> };
}

pub(crate) use entries::{bare, blocks, each, on, one};
pub(crate) use form::form;
pub(crate) use verbs::verbs;
pub(crate) use {block_on, exported, kept};
