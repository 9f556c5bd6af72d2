//! Parameters as retuning reads them.

use crate::port::{AxesForm, ScrewForm};

/// Parameter, or several, with what only `init` reads replaced by a value that no constructor refuses.
///
/// The memory has the energy by then. What stands in the field may not fit any more: the start of a tank whose ceiling was
/// lowered since is above it.
pub trait Retuned {
    /// The parameter that `retune` reads.
    fn retuned(&self) -> Self;
}

macro_rules! as_told {
    ($([$($param:tt)*] $type:ty),+ $(,)?) => {$(
        impl<$($param)*> Retuned for $type {
            fn retuned(&self) -> Self {
                *self
            }
        }
    )+};
}

as_told! { [] f32, [] f64, [] u32, [T: Copy, const N: usize] AxesForm<T, N>, [T: Copy] ScrewForm<T> }

impl<P: Retuned, const N: usize> Retuned for [P; N] {
    fn retuned(&self) -> Self {
        core::array::from_fn(|at| self[at].retuned())
    }
}

/// A field as retuning reads it: as it was told, or what the entry has behind `=>`, a number or another field.
macro_rules! retuned {
    ($given:ident $field:ident) => {
        $crate::retuned::Retuned::retuned(&$given.$field)
    };
    ($given:ident $field:ident $number:literal) => {
        $number
    };
    ($given:ident $field:ident $other:ident) => {
        $given.$other
    };
}

pub(crate) use retuned;
