//! Method by which a map's cells are computed.

use super::grid::{Grid, Tile};
use super::kernel::{Kernel, Lanes};
use super::run_error::RunError;
use crate::measure::runs::has_lanes;
use crate::simulate::Instructions;

/// Method by which the cells are computed.
#[derive(Debug)]
pub enum Method {
    /// Many at once, on lanes of one loop compiled for the plain scene, and its other stabilizers on lanes of boxes.
    Kernel(Box<Kernel>),
    /// Many at once, on lanes of boxes on these instructions.
    Lanes(Instructions),
    /// One by one.
    Single,
}

impl Method {
    /// The method for the cells of `tile`.
    pub(super) fn of(grid: &Grid, tile: &Tile) -> Result<Self, RunError> {
        let best = Instructions::best();
        let kernel = Kernel::of(&grid.within(tile), best, Lanes::Many)?;
        Ok(match kernel {
            Some(kernel) => Self::Kernel(Box::new(kernel)),
            None if has_lanes(&grid.scene, &None) => Self::Lanes(best),
            None => Self::Single,
        })
    }

    /// The instructions of its lanes of boxes.
    pub(super) fn instructions(&self) -> Option<Instructions> {
        match self {
            Self::Kernel(kernel) => Some(kernel.instructions()),
            Self::Lanes(instructions) => Some(*instructions),
            Self::Single => None,
        }
    }
}
