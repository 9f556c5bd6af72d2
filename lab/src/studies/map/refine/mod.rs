//! Edge of bounded runs of a map at the resolution of its grid, from few of its runs.

mod document;
mod edge;
mod picture;
mod report;
mod side;
#[cfg(test)]
mod tests;

pub use edge::{Edge, Shares};
pub use side::Side;

use super::grid::Grid;
use super::run::Run;
use super::run_error::RunError;
use crate::simulate::family::StabilizerName;

/// The edges of stability of a map, one under each stabilizer.
#[derive(Clone, Debug)]
pub struct Refined {
    grid: Grid,
    edges: Vec<Edge>,
}

impl Refined {
    /// Finds the edges on the grid of `run`; `watch` learns how many more cells are judged, and says whether to go on.
    ///
    /// # Errors
    /// [`RunError::Stopped`] if `watch` stops it, and a cell whose values make no scene.
    pub fn of(run: &Run<'_>, watch: &(dyn Fn(u64) -> bool + Sync)) -> Result<Self, RunError> {
        let grid = run.grid();
        let edges = grid.stabilizers.iter().map(|member| {
            Edge::find([grid.x.count, grid.y.count], |cells| {
                let sides = run.verdicts(*member, cells, &|| watch(0))?;
                watch(cells.len() as u64);
                Ok(sides.into_iter().map(Side::from).collect())
            })
        });
        Ok(Self { grid: grid.clone(), edges: edges.collect::<Result<_, RunError>>()? })
    }

    /// The grid of the map.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The edge under each stabilizer.
    pub fn edges(&self) -> impl Iterator<Item = (StabilizerName, &Edge)> {
        self.grid.stabilizers.iter().copied().zip(&self.edges)
    }
}
