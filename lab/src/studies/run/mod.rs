//! Run of a scene with its curves: `lyapunov run`.

mod against;
mod curves;
mod picture;
mod report;

pub use against::{Against, Difference, Differences, Laid, Start};
pub use curves::Curves;
