//! The command under test.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::contract::row::{HEADER, Row};
use crate::contract::scene::{Scalar, Scene};

/// The rows that the command writes for a scene, which it must accept.
pub(crate) fn run(scene: &Scene) -> Result<Vec<Row>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let (file, csv) = (folder.path().join("scene.toml"), folder.path().join("rows.csv"));
    fs::write(&file, scene.toml()).map_err(|error| error.to_string())?;

    let output = command(&file, &csv)?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(format!("{}: {said}", output.status));
    }
    let text = fs::read_to_string(&csv).map_err(|error| format!("no CSV: {error}"))?;
    read(&text, scene.scalar)
}

fn command(scene: &Path, csv: &Path) -> Result<Output, String> {
    Command::new(env!("CARGO_BIN_EXE_lyapunov"))
        .arg("run")
        .arg(scene)
        .arg("--csv")
        .arg(csv)
        .output()
        .map_err(|error| error.to_string())
}

pub(crate) fn read(text: &str, scalar: Scalar) -> Result<Vec<Row>, String> {
    let mut lines = text.lines();
    let header = lines.next().unwrap_or_default();
    if header != HEADER {
        return Err(format!("the columns are {header}, not {HEADER}"));
    }
    let row = |(n, line): (usize, &str)| {
        let mut columns = [0.0; 12];
        let cells: Vec<&str> = line.split(',').collect();
        if cells.len() != columns.len() {
            return Err(format!("row {n} has {} cells: {line}", cells.len()));
        }
        for (column, cell) in columns.iter_mut().zip(cells) {
            *column =
                number(cell, scalar).ok_or_else(|| format!("row {n} holds {cell}: {line}"))?;
        }
        Ok(Row::from_columns(columns))
    };
    lines.enumerate().map(row).collect()
}

/// An f32 may be written as the shortest decimal that reads back as that f32, which is another number in f64.
fn number(cell: &str, scalar: Scalar) -> Option<f64> {
    let value = match scalar {
        Scalar::F64 => cell.parse().ok()?,
        Scalar::F32 => f64::from(cell.parse::<f32>().ok()?),
    };
    f64::is_finite(value).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::read;
    use crate::contract::reference;
    use crate::contract::row::{HEADER, Row};
    use crate::contract::scene::{Kind, SOFT, Scalar, Scene, Work};

    #[test]
    fn rows_read_back_exactly() {
        let scene = Scene::paper(SOFT).with(Kind::Popc, Work::Held, 0.5);
        let rows = reference::run(&scene);
        let line = |row: &Row| row.columns().map(|value| format!("{value:?}")).join(",");
        let lines: Vec<String> = rows.iter().map(line).collect();
        let text = format!("{HEADER}\n{}\n", lines.join("\n"));
        assert_eq!(read(&text, Scalar::F64).as_ref(), Ok(&rows));
    }

    #[test]
    fn bad_text_is_refused() {
        let nothing = "0,".repeat(11);
        for bad in ["NaN", "inf", "-inf", "", "1e39"] {
            let text = format!("{HEADER}\n{nothing}{bad}\n");
            assert!(read(&text, Scalar::F32).is_err(), "{bad}");
        }
        assert!(read(&format!("{HEADER}\n{nothing}\n"), Scalar::F64).is_err());
        assert!(read(&format!("t,x\n{nothing}1\n"), Scalar::F64).is_err());
        assert!(read("", Scalar::F64).is_err());
    }
}
