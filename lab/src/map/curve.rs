//! What the formulas say, over a map.

use super::grid::Grid;

/// A bound along one axis for each value of the other.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) label: &'static str,
    pub(super) colour: usize,
    pub(super) is_dashed: bool,
    /// Values of x and y.
    pub(super) points: Vec<(f64, f64)>,
}

/// The bounds on the stiffness of the environment, if that is an axis.
pub(super) fn all(grid: &Grid) -> Vec<Curve> {
    let _ = grid;
    Vec::new()
}
