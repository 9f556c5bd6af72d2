//! Assignment of cells to lanes.

use super::field::Copier;
use super::parts::LaneScenes;
use crate::files::scene::{Draft, Positive, Scene};

/// Cells that wait for a lane, and their scenes.
#[derive(Debug)]
pub(super) struct Seats<'a> {
    pub(super) along: &'a Along,
    pub(super) cells: &'a [u64],
    taken: usize,
    scenes: Vec<Draft>,
}

/// The scenes along both axes, with the copiers that take a cell's two numbers from them.
#[derive(Debug)]
pub(super) struct Along {
    pub(super) base: Draft,
    pub(super) x: (Vec<Scene>, Copier),
    pub(super) y: (Vec<Scene>, Copier),
}

impl Along {
    /// Turns the scene of another cell into that of `cell`.
    fn write(&self, cell: u64, scene: &mut Draft) {
        let columns = self.x.0.len();
        let (column, row) = (cell as usize % columns, cell as usize / columns);
        (self.x.1)(scene, &self.x.0[column]);
        (self.y.1)(scene, &self.y.0[row]);
    }
}

impl<'a> Seats<'a> {
    pub(super) fn new(along: &'a Along, cells: &'a [u64]) -> Self {
        Self { along, cells, taken: 0, scenes: Vec::new() }
    }

    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    /// The next cells, at most `lanes` and alike in rates and duration, with the place of the first one.
    pub(super) fn next(&mut self, lanes: usize) -> Option<(usize, LaneScenes<'_>)> {
        let first = self.taken;
        let waiting = self.cells.get(first..)?;
        let mut count = 0;
        for &cell in waiting.iter().take(lanes) {
            if self.scenes.len() == count {
                self.scenes.push(self.along.base.clone());
            }
            self.along.write(cell, &mut self.scenes[count]);
            if count > 0 && trajectory(&self.scenes[count]) != trajectory(&self.scenes[0]) {
                break;
            }
            count += 1;
        }
        self.taken += count;
        (count > 0).then(|| (first, LaneScenes(&self.scenes[..count])))
    }
}

/// Rates and duration, which are the same for all lanes of a group.
fn trajectory(scene: &Draft) -> (Positive, Option<Positive>, Positive) {
    (scene.servo_rate, scene.environment_rate, scene.duration)
}
