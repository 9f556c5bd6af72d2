//! Runs of the command under test.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::effects::reference::Row;
use crate::effects::scene::Scene;
use crate::effects::toml::MOTION_FILE;

/// The bytes of the CSV of a scene, which the command must accept.
pub(crate) fn csv(scene: &Scene) -> Result<String, String> {
    csv_of(&scene.toml(), scene.motion_file().as_deref())
}

/// The bytes of the CSV of a scene's text, with the file of its motion beside it.
pub(crate) fn csv_of(scene: &str, motion: Option<&str>) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let put = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap_or(Path::new("")))
            .and_then(|()| fs::write(path, text))
            .map_err(|error| error.to_string())
    };
    put("scene.toml", scene)?;
    motion.map_or(Ok(()), |motion| put(MOTION_FILE, motion))?;
    // The command runs in another folder: files that a scene names are looked for beside the scene.
    let output = Command::new(env!("CARGO_BIN_EXE_lyapunov"))
        .args(["run".as_ref(), folder.path().join("scene.toml").as_os_str()])
        .args(["--csv", "-"])
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(format!("{}: {said}\n{scene}", output.status));
    }
    String::from_utf8(output.stdout).map_err(|error| error.to_string())
}

pub(crate) fn rows(scene: &Scene) -> Result<Vec<Row>, String> {
    let text = csv(scene)?;
    let mut lines = text.lines();
    let (names, columns) = (lines.next().unwrap_or_default(), scene.columns());
    if names != columns.join(",") {
        return Err(format!("the columns are {names}, not {}", columns.join(",")));
    }
    let number = |cell: &str| {
        let value = if scene.single {
            f64::from(cell.parse::<f32>().map_err(|error| error.to_string())?)
        } else {
            cell.parse().map_err(|error| format!("{cell}: {error}"))?
        };
        if f64::is_finite(value) { Ok(value) } else { Err(format!("{cell} is not finite")) }
    };
    let row = |line: &str| {
        let row = line.split(',').map(number).collect::<Result<Row, String>>()?;
        if row.len() == columns.len() { Ok(row) } else { Err(format!("a short row: {line}")) }
    };
    lines.map(row).collect()
}
