//! Run of a scene with its curves: `lyapunov run`.

mod curves;
mod picture;
mod report;

pub use curves::Curves;
