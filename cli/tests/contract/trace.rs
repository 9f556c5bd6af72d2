//! Comparison of two traces of one scene, row by row.

use crate::contract::conditioning;
use crate::contract::reference;
use crate::contract::row::{HEADER, Row};
use crate::contract::scene::{Scalar, Scene};

/// Tolerance as a part of each column's largest absolute value: well above the error that conditioning lets rounding
/// reach, well below the error of any misreading of the contract.
pub(crate) fn tolerance(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => 2e-9,
        Scalar::F32 => 1e-2,
    }
}

/// Largest value of each column. The shortfall is only as exact as the observed energy, so both share a scale.
pub(crate) fn largest(rows: &[Row]) -> [f64; 12] {
    let scale = |columns: [f64; 12], row: &Row| {
        let mut values = row.columns().into_iter();
        columns.map(|largest| values.next().map_or(largest, |value| largest.max(value.abs())))
    };
    let mut row = Row::from_columns(rows.iter().fold([0.0; 12], scale));
    row.shortfall = row.shortfall.max(row.observer);
    row.columns()
}

pub(crate) fn agree(reference: &[Row], other: &[Row], tolerance: f64) -> Result<(), String> {
    if reference.len() != other.len() {
        return Err(format!("{} rows, not {}", other.len(), reference.len()));
    }
    let scale = largest(reference);
    for (n, (reference, other)) in reference.iter().zip(other).enumerate() {
        let pairs = reference.columns().into_iter().zip(other.columns());
        for ((name, (want, got)), scale) in HEADER.split(',').zip(pairs).zip(scale) {
            if (got - want).abs() > tolerance * scale {
                return Err(format!(
                    "row {n}: {name} is {got:e}, not {want:e} (largest {scale:e})"
                ));
            }
        }
    }
    Ok(())
}

/// Compares the trace up to where it stops being determined; a scene with nothing left passes.
pub(crate) fn compare(
    scene: &Scene,
    run: impl Fn(&Scene) -> Result<Vec<Row>, String>,
) -> Result<(), String> {
    let Some(scene) = conditioning::shortened(scene) else {
        return Ok(());
    };
    let told = |error| format!("{error}\n{}", scene.toml());
    let rows = run(&scene).map_err(told)?;
    agree(&reference::run(&scene), &rows, tolerance(scene.scalar)).map_err(told)
}
