//! JSON beside a file of rows.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use lyapunov_lab::RowFile;
use serde_json::Value;

use super::{Inputs, Output, Outputs};
use crate::commands::End;

/// The JSON `NAME.json` beside the rows `NAME.csv`, which says what the columns are and what made them; none beside a
/// device or a pipe.
#[derive(Debug)]
pub(crate) struct Sidecar(Option<PathBuf>);

impl Sidecar {
    /// The one beside the file at `rows`.
    ///
    /// # Errors
    /// A file under that name that is one of `inputs`, or that no program like this one wrote; rows in the place of a scene.
    pub(crate) fn beside(rows: &Path, inputs: &Inputs) -> Result<Self, End> {
        if Output::is_direct(rows) {
            return Ok(Self(None));
        }
        if rows.extension().is_some_and(|ending| ending == "toml") && rows.exists() {
            return Err(End::input(format_args!(
                "{}: this file has the ending of a scene, and rows would replace it\n  = choose another name for the rows",
                rows.display()
            )));
        }
        let mut place = rows.with_extension("json");
        if place == rows {
            place.as_mut_os_string().push(".json");
        }
        inputs.spare(&place)?;
        let is_ours = |text: String| {
            serde_json::from_str::<Value>(&text).is_ok_and(|it| it.get("lyapunov").is_some())
        };
        if place.exists() && !fs::read_to_string(&place).is_ok_and(is_ours) {
            return Err(End::input(format_args!(
                "{}: this file says what {} holds, and another one has that name\n  \
                 = choose another name for the rows, or move that file",
                place.display(),
                rows.display()
            )));
        }
        Ok(Self(Some(place)))
    }

    /// Lets the rows and the JSON appear under their names.
    ///
    /// # Errors
    /// Any error of the system.
    pub(crate) fn keep(self, rows: Output, file: &RowFile) -> Result<(), End> {
        let Some(place) = self.0 else { return rows.keep().map_err(End::input) };
        // The rows are still open: to create a file removes the temporary files in its folder that no process holds open.
        let mut json = Output::create(&place).map_err(End::input)?;
        let text = file.to_json();
        json.write_all(text.as_bytes()).map_err(|error| End::input(json.blame(error)))?;
        let mut outputs = Outputs::of(place.parent().unwrap_or(Path::new("")));
        outputs.add(rows).map_err(End::input)?;
        outputs.add(json).map_err(End::input)?;
        outputs.keep().map_err(End::input)
    }
}
