//! Entries of blocks, on all signals that they are for.

/// Blocks, an entry for each: a name, the signals, the value and how it is kept, its parameters, how it is made of them, and
/// the groups of functions. `V` is the signal, `T` its number, `Form` the signal as C has it. A parameter that `init` alone reads
/// has behind `=>` what `retune` reads in its place.
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

pub(crate) use {bare, blocks, each, on, one};
