//! Results of a command, as `--out` writes them.

use std::fmt::Display;

use lyapunov_figures::Figure;
use lyapunov_lab::shell_word;

use super::{End, arguments, program};
use crate::files::Output;
use crate::pictures::pictures;

/// The files of a folder: the page `report.html`, the JSON that `--json` prints, the figures, the rows.
#[derive(Debug)]
pub(crate) struct Results {
    pub(super) files: Vec<(String, Vec<u8>)>,
    /// Rows that were written while the command computed.
    pub(super) streamed: Option<Output>,
}

impl Results {
    /// The page, and the JSON under `name`.
    pub(crate) fn new(page: String, name: &str, json: &str) -> Self {
        Self::of(Vec::new()).with_file("report.html", page).with_file(name, json)
    }

    /// These files, each given by name and bytes, without a page.
    pub(crate) fn of(files: Vec<(String, Vec<u8>)>) -> Self {
        Self { files, streamed: None }
    }

    /// The same with a figure, as SVG and as PNG.
    pub(crate) fn with_figure(mut self, name: &str, figure: &Figure) -> Result<Self, End> {
        self.files.extend(pictures(name, figure).map_err(End::internal)?);
        Ok(self)
    }

    /// The same with a file more.
    pub(crate) fn with_file(mut self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.push((name.into(), bytes.into()));
        self
    }

    /// The same with rows that were written while the command computed.
    pub(crate) fn with_rows(self, rows: Output) -> Self {
        Self { streamed: Some(rows), ..self }
    }
}

/// The names of the files of a command: the page, the JSON called `json`, each of the `figures` as SVG and as PNG, and
/// `others`.
pub(crate) fn names(
    json: &str,
    figures: impl IntoIterator<Item = impl Display>,
    others: impl IntoIterator<Item = impl Display>,
) -> Vec<String> {
    let drawn = figures.into_iter().flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
    let first = ["report.html".to_owned(), json.to_owned()];
    first.into_iter().chain(drawn).chain(others.into_iter().map(|it| it.to_string())).collect()
}

/// The command as it was called, for the head of a page.
pub(crate) fn command_line() -> String {
    let given = arguments().map(|word| shell_word(&word.to_string_lossy()));
    std::iter::once(program().to_owned()).chain(given).collect::<Vec<_>>().join(" ")
}
