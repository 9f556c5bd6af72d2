//! Names of types in C.

use std::format;
use std::string::{String, ToString};

use lyapunov::poses::Screw;
use nalgebra::SVector;

use crate::answered::WaveForm;
use crate::number::Number;
use crate::port::{AxesForm, CorrectionForm, Port, SampleForm, ScrewForm};
use crate::poses::PoseForm;
use crate::readings::CheckedForm;
use crate::status::Status;
use crate::told::Candidate;
use crate::watched::SummaryForm;

/// Type with a name in C.
pub trait CType {
    /// The name.
    fn name() -> String;
}

macro_rules! named {
    ($($type:ty = $name:literal),+ $(,)?) => {$(
        impl CType for $type {
            fn name() -> String {
                $name.to_string()
            }
        }
    )+};
}

named! {
    f32 = "float",
    f64 = "double",
    u16 = "uint16_t",
    u32 = "uint32_t",
    u64 = "uint64_t",
    usize = "size_t",
    u8 = "char",
    core::ffi::c_char = "char",
    core::ffi::c_void = "void",
    Status = "lyapunov_status",
}

impl<C: CType> CType for *mut C {
    fn name() -> String {
        format!("{} *", C::name())
    }
}

impl<C: CType> CType for *const C {
    fn name() -> String {
        format!("const {} *", C::name())
    }
}

/// The end of the names of a signal's types.
pub(crate) trait Suffix {
    /// The end.
    fn suffix() -> String;
}

impl Suffix for f32 {
    fn suffix() -> String {
        "f32".into()
    }
}

impl Suffix for f64 {
    fn suffix() -> String {
        "f64".into()
    }
}

impl<T: Suffix, const N: usize> Suffix for SVector<T, N> {
    fn suffix() -> String {
        format!("{}x{N}", T::suffix())
    }
}

impl<T: Suffix> Suffix for Screw<T> {
    fn suffix() -> String {
        format!("{}screw", T::suffix())
    }
}

impl<T: Suffix, const N: usize> CType for AxesForm<T, N> {
    fn name() -> String {
        format!("lyapunov_{}x{N}", T::suffix())
    }
}

impl<T: Suffix> CType for ScrewForm<T> {
    fn name() -> String {
        format!("lyapunov_{}screw", T::suffix())
    }
}

impl<T: Suffix> CType for PoseForm<T> {
    fn name() -> String {
        format!("lyapunov_{}pose", T::suffix())
    }
}

impl<V: Port + Suffix> CType for WaveForm<V> {
    fn name() -> String {
        format!("lyapunov_wave_{}", V::suffix())
    }
}

impl<V: Port + Suffix> CType for SampleForm<V> {
    fn name() -> String {
        format!("lyapunov_sample_{}", V::suffix())
    }
}

impl<V: Port + Suffix> CType for CorrectionForm<V> {
    fn name() -> String {
        format!("lyapunov_correction_{}", V::suffix())
    }
}

impl<V: Port + Suffix> CType for CheckedForm<V> {
    fn name() -> String {
        format!("lyapunov_checked_sample_{}", V::suffix())
    }
}

impl<T: Number + Suffix> CType for SummaryForm<T> {
    fn name() -> String {
        format!("lyapunov_energy_summary_{}", T::suffix())
    }
}

impl<V: Port + Suffix> CType for Candidate<V> {
    fn name() -> String {
        format!("lyapunov_candidate_{}", V::suffix())
    }
}

impl<T: CType, const N: usize> CType for [T; N] {
    fn name() -> String {
        format!("{}[{N}]", T::name())
    }
}

/// Number with a name and an end.
pub(crate) trait Named: Number<Fill: CType> + CType + Suffix {}

impl<T: Number<Fill: CType> + CType + Suffix> Named for T {}
