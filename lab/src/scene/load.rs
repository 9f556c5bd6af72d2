//! From a file or a text to a checked scene.

use std::fs::{self, File};
use std::io::{self, Read};
use std::ops::Range;
use std::path::Path;

use serde::Deserialize;
use toml::de::{DeTable, DeValue};

use super::check::Conflict;
use super::diagnostic::Diagnostic;
use super::excerpt::shorten;
use super::fault::Place;
use super::keys::SMALLEST;
use super::reader::Reader;
use super::written::Keys;
use super::{Scene, explain, syntax};

/// The largest scene file in bytes.
const LIMIT: u64 = 1 << 20;

const EXPECTED: &str = "give the path of a scene file, a text in TOML";

/// See [`Scene::parse`]; files that the scene names are looked for in `folder`.
pub(super) fn parse(text: &str, name: &str, folder: &Path) -> Result<Scene, Diagnostic> {
    // Some editors write a byte order mark; left in, it would shift every column of the first line.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let table = DeTable::parse(text).map_err(|error| syntax::explain(&error, text, name))?;
    let root = DeValue::Table(table.into_inner());
    if root.as_table().is_some_and(|table| table.is_empty()) {
        return Err(Diagnostic::new(name, "the scene is empty")
            .with_help(format!("the smallest scene is:\n{SMALLEST}")));
    }
    let keys = Keys::deserialize(Reader::new(&root, Place::default()))
        .map_err(|fault| explain::explain(fault, text, name))?;
    checked(keys, folder).map_err(|conflict| place(&conflict, &root, text, name))
}

fn checked(keys: Keys, folder: &Path) -> Result<Scene, Conflict> {
    let mut scene = Scene::try_from(keys)?;
    scene.read_motion(folder)?;
    scene.check()?;
    Ok(scene)
}

/// See [`Scene::load`].
pub(super) fn load(path: &Path) -> Result<Scene, Diagnostic> {
    let name = path.display().to_string();
    let bytes = read(path, &name)?;
    match str::from_utf8(&bytes) {
        Ok(text) if !text.contains('\0') => {
            parse(text, &name, path.parent().unwrap_or(Path::new("")))
        }
        _ => Err(not_text(&bytes, &name)),
    }
}

fn read(path: &Path, name: &str) -> Result<Vec<u8>, Diagnostic> {
    let refuse = |error: io::Error| unreadable(&error, name);
    let metadata = fs::metadata(path).map_err(refuse)?;
    if metadata.is_dir() {
        return Err(Diagnostic::new(name, "this is a folder").with_help(EXPECTED));
    }
    if metadata.len() > LIMIT {
        return Err(too_large(name, &format!("{} bytes", metadata.len())));
    }
    let mut bytes = Vec::new();
    // A device tells no size, and a file may grow: one byte more than allowed settles it.
    File::open(path)
        .and_then(|file| file.take(LIMIT + 1).read_to_end(&mut bytes))
        .map_err(refuse)?;
    if bytes.len() as u64 > LIMIT {
        return Err(too_large(name, "more than 1 MiB"));
    }
    Ok(bytes)
}

fn unreadable(error: &io::Error, name: &str) -> Diagnostic {
    match error.kind() {
        io::ErrorKind::NotFound => Diagnostic::new(name, "there is no such file")
            .with_help("check the path; it is taken from the current folder"),
        io::ErrorKind::PermissionDenied => Diagnostic::new(name, "this file may not be read")
            .with_help("check its permissions and those of its folder"),
        _ => {
            Diagnostic::new(name, format!("this file cannot be read: {error}")).with_help(EXPECTED)
        }
    }
}

fn too_large(name: &str, size: &str) -> Diagnostic {
    Diagnostic::new(name, format!("this file is too large for a scene: {size}"))
        .with_help(format!("a scene file has at most {LIMIT} bytes; {EXPECTED}"))
}

fn not_text(bytes: &[u8], name: &str) -> Diagnostic {
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
        format!("save it as UTF-8, or {EXPECTED}")
    };
    Diagnostic::new(name, message).with_help(help)
}

/// The conflict at the place of its key.
fn place(conflict: &Conflict, root: &DeValue<'_>, text: &str, name: &str) -> Diagnostic {
    let asker = || conflict.asker().and_then(|key| span_of(root, key));
    let span = span_of(root, conflict.key()).or_else(asker).unwrap_or_default();
    let value = text.get(span.clone()).filter(|value| !value.is_empty());
    Diagnostic::new(name, conflict.problem())
        .with_key(conflict.key())
        .with_value(value.map(shorten))
        .with_excerpt(text, span)
        .with_help(conflict.remedy())
}

fn span_of(root: &DeValue<'_>, path: &str) -> Option<Range<usize>> {
    let mut parts = path.split('.');
    let mut value = root.get(parts.next()?)?;
    // A key that is not given has the place of its table.
    while let Some(next) = parts.next().and_then(|part| value.get_ref().get(part)) {
        value = next;
    }
    Some(value.span())
}
