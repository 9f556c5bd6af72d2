//! Logs that are given in place of a scene.

use super::book::Book;
use super::diagnostic::Diagnostic;

/// The fewest columns of a log: time, position and force.
const COLUMNS: usize = 3;

/// The diagnostic of a `text` whose first line is that of a log. No scene begins so: a key comes before its `=`, and a table in
/// brackets.
pub(super) fn as_log(book: &Book, text: &str, name: &str) -> Option<Diagnostic> {
    let mut start = 0;
    let line = text.split_inclusive('\n').find(|line| {
        let is_note = line.trim().is_empty() || line.trim_start().starts_with('#');
        start += if is_note { line.len() } else { 0 };
        !is_note
    })?;
    let line = line.trim_end();
    let is_text = !line.chars().any(|it| it.is_control() && it != '\t');
    let is_parted = [',', ';', '\t'].iter().any(|mark| line.split(*mark).count() >= COLUMNS);
    if !is_text || !is_parted || line.contains('=') || line.trim_start().starts_with('[') {
        return None;
    }
    let noun = book.noun;
    let message = "this looks like a log: fields stand here, and not `key = value`";
    let help = format!(
        "give the path of a {noun} file; `lyapunov observe` reads a log, and `lyapunov identify` makes a scene of it"
    );
    let diagnostic = Diagnostic::new(name, message).with_excerpt(text, start..start);
    Some(diagnostic.with_help(help))
}
