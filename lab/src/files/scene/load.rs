//! The text and the kind of a file.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use super::book::Book;
use super::diagnostic::Diagnostic;
use super::document::names_any;
use super::mistaken;
use crate::files::shipped::SCENES;
use crate::files::unopened::unopened;

/// The largest file in bytes.
const LIMIT: u64 = 1 << 20;

/// The bytes of a file in which its first line is looked for.
const HEAD: usize = 1 << 12;

/// A kind of file other than a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    /// The noun for such a file, with its article.
    pub(crate) noun: &'static str,
    /// The tables that no other kind has.
    tables: &'static [&'static str],
}

/// Models of plants.
pub(crate) const MODEL: Kind =
    Kind { noun: "a model of a plant", tables: &["plant", "controller"] };

/// Teleoperators.
pub(crate) const TELEOPERATOR: Kind =
    Kind { noun: "a teleoperator", tables: &["master", "slave", "coordination", "channel"] };

impl Kind {
    /// Whether `text` is meant as such a file, as far as a broken text can be parsed.
    pub(crate) fn is_in(self, text: &str) -> bool {
        names_any(text, self.tables)
    }
}

/// The text of a file of the kind in `book`, of at most 1 MiB.
pub(crate) fn text_of(book: &Book, path: &Path) -> Result<String, Diagnostic> {
    let name = path.display().to_string();
    let bytes = read(book, path, &name)?;
    match String::from_utf8(bytes) {
        Ok(text) if !text.contains('\0') => Ok(text),
        Ok(text) => Err(not_text(book, text.as_bytes(), &name)),
        Err(error) => Err(not_text(book, error.as_bytes(), &name)),
    }
}

/// The remedy: the path of the right kind of file.
fn expected(book: &Book) -> String {
    format!("give the path of a {} file, a text in TOML", book.noun)
}

fn read(book: &Book, path: &Path, name: &str) -> Result<Vec<u8>, Diagnostic> {
    let refuse = |error: io::Error| unreadable(book, &error, name);
    let metadata = fs::metadata(path).map_err(refuse)?;
    if metadata.is_dir() {
        return Err(Diagnostic::new(name, "this is a folder").with_help(expected(book)));
    }
    let mut bytes = Vec::new();
    // A device reports no size, and a file may grow: reading one byte beyond the limit detects both.
    File::open(path)
        .and_then(|file| file.take(LIMIT + 1).read_to_end(&mut bytes))
        .map_err(refuse)?;
    // Most logs are larger than any scene, and what they are helps more than their size.
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(HEAD)]);
    if let Some(log) = mistaken::as_log(book, &head, name) {
        return Err(log);
    }
    if bytes.len() as u64 > LIMIT {
        let size = match metadata.len() {
            ..=LIMIT => "more than 1 MiB".to_owned(),
            size => format!("{size} bytes"),
        };
        return Err(too_large(book, name, &size));
    }
    Ok(bytes)
}

fn unreadable(book: &Book, error: &io::Error, name: &str) -> Diagnostic {
    match unopened(error.kind()) {
        Some([wrong, remedy]) if error.kind() == io::ErrorKind::NotFound => {
            Diagnostic::new(name, wrong).with_help(format!("{remedy}{}", saved(name)))
        }
        Some([wrong, remedy]) => Diagnostic::new(name, wrong).with_help(remedy),
        None => Diagnostic::new(name, format!("this file cannot be read: {error}"))
            .with_help(expected(book)),
    }
}

/// The rest of the remedy for the path of a file that is not there: one that ships with such a name can be saved.
fn saved(path: &str) -> String {
    let name = Path::new(path).file_stem().and_then(|it| it.to_str()).unwrap_or_default();
    match SCENES.iter().find(|scene| scene.name == name) {
        Some(_) => {
            format!("; `lyapunov scenes {name} > {name}.toml` saves the shipped file of that name")
        }
        None => String::new(),
    }
}

fn too_large(book: &Book, name: &str, size: &str) -> Diagnostic {
    Diagnostic::new(name, format!("this file is too large for a {}: {size}", book.noun))
        .with_help(format!("a {} file has at most {LIMIT} bytes; {}", book.noun, expected(book)))
}

fn not_text(book: &Book, bytes: &[u8], name: &str) -> Diagnostic {
    let valid = match str::from_utf8(bytes) {
        Ok(_) => bytes.len(),
        Err(error) => error.valid_up_to(),
    };
    let zero = bytes.iter().position(|byte| *byte == 0).unwrap_or(valid);
    let offset = valid.min(zero);
    let value = bytes.get(offset).copied().unwrap_or_default();
    let message = format!("this file is not text in UTF-8: byte {value:#04x} at offset {offset}");
    let help = if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        "it looks like UTF-16: save it as UTF-8".to_owned()
    } else {
        format!("save it as UTF-8, or {}", expected(book))
    };
    Diagnostic::new(name, message).with_help(help)
}
