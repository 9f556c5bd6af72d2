//! How long the runs of a map are.

use super::grid::Grid;

/// The rows of the run of a cell, `round(duration servo_rate) + 1`.
pub(super) fn rows(grid: &Grid, cell: u64) -> u64 {
    let values = grid.values(cell);
    let number = |key: &str, own: f64| {
        let axes = [&grid.x.key, &grid.y.key];
        axes.iter().position(|axis| *axis == key).map_or(own, |which| values[which])
    };
    let duration = number("duration", grid.scene.duration.get());
    let rate = number("servo_rate", grid.scene.servo_rate.get());
    (duration * rate).round() as u64 + 1
}
