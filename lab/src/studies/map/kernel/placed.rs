//! The kernel of a tile at its place in the map.

use super::Kernel;

/// The kernel of a tile, whose cells count from 0, and the tile's first cell.
#[derive(Clone, Copy)]
pub(in crate::studies::map) struct Placed<'a> {
    pub(in crate::studies::map) kernel: &'a Kernel,
    pub(in crate::studies::map) first: u64,
}

impl Placed<'_> {
    /// `cells` of the map as cells of the tile.
    pub(in crate::studies::map) fn cells(&self, cells: &[u64]) -> Vec<u64> {
        cells.iter().map(|cell| cell - self.first).collect()
    }
}
