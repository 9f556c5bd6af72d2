//! Damping limits, as numbers that the parameters of blocks take.

use lyapunov::{DampingLimit, ParameterError};

use crate::check;
use crate::number::Number;
use crate::status::{Code, Status};

/// The limit of `damping` N·s/m.
pub(crate) fn limit<T: Number>(damping: T) -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::at(damping)
}

/// Writes the limit that `made` gives.
///
/// # Safety
/// `limit`, where it is neither null nor misaligned, is a variable of the caller.
unsafe fn write<T: Number>(
    limit: *mut T,
    made: impl FnOnce() -> Result<DampingLimit<T>, ParameterError>,
) -> Status {
    if let Err(code) = check::pointer(limit) {
        return Status::of(code);
    }
    match made() {
        Ok(made) => {
            // SAFETY: checked, and a variable by the caller's word.
            unsafe { limit.write(made.most()) };
            Status::of(Code::Ok)
        }
        Err(error) => Status::refused(Code::Parameter, error),
    }
}

macro_rules! limits {
    ($module:ident, $number:ident, $signal:literal) => {
        /// Damping limits in one kind of number.
        pub mod $module {
            use super::{DampingLimit, Status, write};

            crate::export::exported! { "damping_limit", $signal, describe;
                /// The limit cap * tan(pi / (4 (late + 1))) * mass / period, N.s/m, for an effort that acts `late` ticks late:
                /// 0 if it acts from this tick on, 1 if it is latched at the next. `mass` is the least that moves with the port,
                /// kg, and a cap of 0.5 is usual.
                fn of_mass(cap: $number, mass: $number, period: $number, late: u32, limit: *mut $number) -> Status {
                    // SAFETY: as the caller says.
                    unsafe { write(limit, || Ok(DampingLimit::of_mass(cap, mass, period)?.delayed(late))) }
                }
                /// The limit of a mobility, cap * tan(pi / (4 (late + 1))) / (stiffness * period), m/(N.s), where force comes in
                /// and motion goes out: `stiffness` is the largest that holds the device, N/m; `late` as of a mass.
                fn of_stiffness(cap: $number, stiffness: $number, period: $number, late: u32, limit: *mut $number) -> Status {
                    // SAFETY: as the caller says.
                    unsafe { write(limit, || Ok(DampingLimit::of_stiffness(cap, stiffness, period)?.delayed(late))) }
                }
            }
        }
    };
}

limits!(of_f32, f32, "f32");
limits!(of_f64, f64, "f64");
