//! Status of a call.

use lyapunov::{ParameterError, Requirement};

/// What became of a call; in C `lyapunov_code`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Code {
    /// Done.
    Ok = 0,
    /// A pointer was null.
    Null = 1,
    /// A pointer was not aligned for what it points to.
    Misaligned = 2,
    /// The storage has not been initialised, or as another block.
    NotInitialised = 3,
    /// The header is of another version than the library.
    OtherAbi = 4,
    /// A parameter was refused.
    Parameter = 5,
    /// A stored memory was refused.
    Memory = 6,
}

/// Names in C, and what to do.
pub const CODES: [(&str, Code, &str); 7] = [
    ("OK", Code::Ok, "done"),
    ("NULL", Code::Null, "a pointer is null; give the address of a variable"),
    (
        "MISALIGNED",
        Code::Misaligned,
        "a pointer is misaligned; give the address of a variable of its type",
    ),
    (
        "NOT_INITIALISED",
        Code::NotInitialised,
        "the storage is not initialised as this block; call its init first",
    ),
    (
        "OTHER_ABI",
        Code::OtherAbi,
        "the header and the library differ in version; take both from one release",
    ),
    ("PARAMETER", Code::Parameter, "a parameter is refused"),
    ("MEMORY", Code::Memory, "the stored memory is refused"),
];

/// Status of a call, with the refused parameter; in C `lyapunov_status`.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Status {
    /// The refused value.
    pub value: f64,
    /// The number of the requirement, where it has one.
    pub bound: f64,
    /// The parameter's name, not closed by a zero; null without one.
    pub parameter: *const u8,
    /// The length of the name.
    pub length: u16,
    /// The requirement.
    pub requirement: u16,
    /// The code.
    pub code: u32,
}

impl Status {
    /// The status of a `code` alone.
    pub const fn of(code: Code) -> Self {
        let (value, bound, parameter) = (0.0, 0.0, core::ptr::null());
        Self { value, bound, parameter, length: 0, requirement: 0, code: code as u32 }
    }

    /// The status of a refused parameter, or of a number in a memory.
    pub fn refused(code: Code, error: ParameterError) -> Self {
        let name = error.parameter;
        let (requirement, bound) = numbered(error.requirement);
        Self {
            value: error.value,
            bound,
            parameter: name.as_ptr(),
            length: name.len() as u16,
            requirement,
            code: code as u32,
        }
    }
}

/// What a value must be, in the order of `Status::requirement`, and whether a bound follows.
pub(crate) const REQUIREMENTS: [(&str, &str); 9] = [
    ("finite", ""),
    ("above 0 and finite", ""),
    ("at least 0 and finite", ""),
    ("at least 0 (infinity: no limit)", ""),
    ("at most ", " "),
    ("at least ", " and finite"),
    ("such that the result is within the range of the scalar", ""),
    ("above 0 (infinity: no limit)", ""),
    ("as the library requires it", ""),
];

fn numbered(requirement: Requirement) -> (u16, f64) {
    match requirement {
        Requirement::Finite => (0, 0.0),
        Requirement::Positive => (1, 0.0),
        Requirement::NonNegative => (2, 0.0),
        Requirement::Limit => (3, 0.0),
        Requirement::AtMost(most) => (4, most),
        Requirement::AtLeast(least) => (5, least),
        Requirement::InRange => (6, 0.0),
        Requirement::AboveZero => (7, 0.0),
        _ => (8, 0.0),
    }
}
