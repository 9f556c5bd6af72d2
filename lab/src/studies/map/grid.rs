//! The grid of a map: a scene, two of its numbers, and stabilizers.

use std::fmt;
use std::ops::Range;

use lyapunov::ParameterError;
use rayon::prelude::*;

use super::axis::Axis;
use super::varied::Variation;
use super::vary::{VaryError, no_scene};
use crate::files::Scene;
use crate::files::scene::Conflict;
use crate::simulate::family::{StabilizerName, StabilizerNames, StabilizerNamesError};

/// A scene with two of its numbers varied, under several stabilizers.
///
/// Cells are counted along x first: cell `i + j · x.count` has value `i` of x and value `j` of y.
#[derive(Clone, Debug)]
pub struct Grid {
    /// The scene whose numbers are varied.
    pub scene: Scene,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The stabilizers that run in each cell.
    pub stabilizers: StabilizerNames,
    variation: Variation,
    /// The values of x and y that [`Grid::along`] gives.
    window: [Range<u64>; 2],
}

/// The most values of an axis whose scenes are in memory at once.
const WIDEST: u64 = 1 << 14;

/// Consecutive cells whose scenes are few enough to be in memory at once.
#[derive(Clone, Debug)]
pub(super) struct Tile {
    /// The cells.
    pub(super) cells: Range<u64>,
    window: [Range<u64>; 2],
}

/// Reason why there is no such map.
#[derive(Clone, Debug, PartialEq)]
pub enum GridError {
    /// An axis that does not fit the scene.
    Axis(VaryError),
    /// The same number twice.
    SameKey(String),
    /// A stabilizer for one dimension on a scene in a space.
    Axes(Conflict),
    /// A stabilizer named twice, or none at all.
    StabilizerNames(StabilizerNamesError),
    /// A scene that cannot be written as TOML.
    Unwritten(String),
    /// Two values that are each valid but make no scene together.
    Cell {
        /// The two values.
        cell: String,
        /// The reason.
        reason: String,
    },
    /// A stabilizer that cannot be made on the scene of some values.
    Refused {
        /// The values.
        cell: String,
        /// The stabilizer.
        stabilizer: StabilizerName,
        /// The reason.
        error: ParameterError,
    },
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Axis(error) => error.fmt(f),
            Self::SameKey(key) => {
                write!(f, "both axes are `{key}`\n  = give two different numbers of the scene")
            }
            Self::Axes(conflict) => {
                write!(f, "{}\n  = {}", conflict.problem(), conflict.remedy())
            }
            Self::StabilizerNames(error) => error.fmt(f),
            Self::Unwritten(problem) => f.write_str(problem),
            Self::Cell { cell, reason } => write!(
                f,
                "{cell} is no scene: {reason}\n  = choose ranges in which every pair is right"
            ),
            Self::Refused { cell, stabilizer, error } => write!(
                f,
                "{stabilizer} cannot run at {cell}: {error}\n  = leave {stabilizer} out of --stabilizers, of which `all` has it \
                 too, or give {} a value that is right",
                error.parameter
            ),
        }
    }
}

impl std::error::Error for GridError {}

impl From<VaryError> for GridError {
    fn from(error: VaryError) -> Self {
        Self::Axis(error)
    }
}

impl Grid {
    /// The map of `scene` over `x` and `y`.
    ///
    /// # Errors
    /// A key that is no number of the scene, or the same twice; a value that the scene does not allow; a stabilizer
    /// named twice.
    pub fn new(
        scene: Scene,
        x: Axis,
        y: Axis,
        members: impl IntoIterator<Item = impl Into<StabilizerName>>,
    ) -> Result<Self, GridError> {
        if x.key == y.key {
            return Err(GridError::SameKey(x.key));
        }
        let members = StabilizerNames::of(members).map_err(GridError::StabilizerNames)?;
        let variation = Variation::of(&scene, &[&x, &y], &members)?;
        let window = [0..x.count, 0..y.count];
        Ok(Self { scene, x, y, stabilizers: members, variation, window })
    }

    /// The tile that `cell` is in: some rows, or a part of one where a row is long.
    pub(super) fn tile(&self, cell: u64) -> Tile {
        let (column, row) = (cell % self.x.count, cell / self.x.count);
        let around =
            |at: u64, count: u64| at / WIDEST * WIDEST..count.min((at / WIDEST + 1) * WIDEST);
        let window = match self.x.count <= WIDEST {
            true => [0..self.x.count, around(row, self.y.count)],
            false => [around(column, self.x.count), row..row + 1],
        };
        let last = (window[1].end - 1) * self.x.count + window[0].end;
        Tile { cells: window[1].start * self.x.count + window[0].start..last, window }
    }

    /// The same with the scenes of `tile` only along its axes; its cells count from 0.
    pub(super) fn within(&self, tile: &Tile) -> Self {
        Self { window: tile.window.clone(), ..self.clone() }
    }

    /// Checks every value of both axes: a wrong one would only be found after the cells before it.
    ///
    /// # Errors
    /// The first value that the scene does not allow.
    pub(super) fn check(&self) -> Result<(), VaryError> {
        for (which, axis) in [&self.x, &self.y].into_iter().enumerate() {
            let wrong = |index| self.with(which, axis.value(index)).err();
            if let Some(error) = (0..axis.count).into_par_iter().find_map_first(wrong) {
                return Err(error);
            }
        }
        Ok(())
    }

    /// The number of cells.
    pub fn cells(&self) -> u64 {
        self.x.count * self.y.count
    }

    /// The values of x and y in a cell.
    pub fn values(&self, cell: u64) -> [f64; 2] {
        [self.x.value(cell % self.x.count), self.y.value(cell / self.x.count)]
    }

    /// The scene for each value of an axis, or of a tile along it, with the other number unchanged.
    ///
    /// # Errors
    /// A value that the scene does not allow.
    pub(super) fn along(&self, which: usize) -> Result<Vec<Scene>, VaryError> {
        let axis = [&self.x, &self.y][which];
        self.window[which].clone().map(|index| self.with(which, axis.value(index))).collect()
    }

    /// The scene with `value` for one of its two numbers, and the other unchanged; a number of a stabilizer's table is
    /// written in that table, which replaces the scene's own.
    ///
    /// # Errors
    /// A value that the scene does not allow.
    pub(super) fn with(&self, which: usize, value: f64) -> Result<Scene, VaryError> {
        let number = &self.variation.numbers()[which];
        if let Some(member) = number.member() {
            let written = number.written(&self.scene, member, value)?;
            return Ok(written.unwrap_or_else(|| self.scene.clone()));
        }
        let mut values = [None; 2];
        values[which] = Some(value);
        let scene = self.variation.scene(&values)?;
        scene.map_err(|reason| no_scene([&self.x, &self.y][which], value, &self.scene, &reason))
    }

    /// The scene of a cell, without the numbers that axes write into the table of a stabilizer that the scene does not name.
    ///
    /// # Errors
    /// Two values that make no scene together.
    pub fn scene_of(&self, cell: u64) -> Result<Scene, GridError> {
        let scene = self.variation.scene(&self.values(cell).map(Some))?;
        scene.map_err(|reason| self.at(cell, reason))
    }

    /// The scenes of cells under `member`, made from their [`scene_of`](Self::scene_of); none where no axis is over its table, so that
    /// those serve.
    ///
    /// # Errors
    /// A value that the table does not allow.
    pub(super) fn written(
        &self,
        cells: &[u64],
        scenes: &[Scene],
        member: StabilizerName,
    ) -> Result<Option<Vec<Scene>>, GridError> {
        if (0..2).all(|which| self.member(which) != Some(member)) {
            return Ok(None);
        }
        let under = |(cell, scene): (&u64, &Scene)| {
            self.variation.under(scene.clone(), member, &self.values(*cell))
        };
        Ok(Some(cells.iter().zip(scenes).map(under).collect::<Result<_, _>>()?))
    }

    /// The stabilizer whose table an axis is over.
    pub(super) fn member(&self, which: usize) -> Option<StabilizerName> {
        self.variation.numbers()[which].member()
    }

    /// The error of a cell with its values.
    pub(super) fn at(&self, cell: u64, reason: String) -> GridError {
        GridError::Cell { cell: self.place(cell), reason }
    }

    /// The error of a cell in which a stabilizer cannot be made.
    pub(super) fn refused(
        &self,
        cell: u64,
        stabilizer: StabilizerName,
        error: ParameterError,
    ) -> GridError {
        GridError::Refused { cell: self.place(cell), stabilizer, error }
    }

    /// The values of a cell, in words.
    fn place(&self, cell: u64) -> String {
        let [x, y] = self.values(cell);
        format!("`{}` = {x:?} with `{}` = {y:?}", self.x.key, self.y.key)
    }

    /// The number of rows of a cell's run, `round(duration servo_rate) + 1`.
    pub(super) fn rows(&self, cell: u64) -> u64 {
        let values = self.values(cell);
        let number = |key: &str, own: f64| {
            let axes = [&self.x.key, &self.y.key];
            axes.iter().position(|axis| *axis == key).map_or(own, |which| values[which])
        };
        let duration = number("duration", self.scene.duration.get());
        let rate = number("servo_rate", self.scene.servo_rate.get());
        ((duration * rate).round() as u64).saturating_add(1)
    }
}
