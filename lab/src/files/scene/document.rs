//! TOML text read into checked values.

use std::ops::Range;

use serde::Deserialize;
use toml::de::{DeTable, DeValue};

use super::book::Book;
use super::check::Conflict;
use super::diagnostic::Diagnostic;
use super::fault::{Fault, Place};
use super::node::Node;
use super::reader::Reader;
use super::{explain, syntax};
use crate::text::shorten;

/// The value that `checked` makes of the keys of `text`, a file of the kind in `book`; messages call the text `name`.
pub(crate) fn read<Keys, Checked>(
    book: &Book,
    text: &str,
    name: &str,
    checked: impl FnOnce(Keys) -> Result<Checked, Conflict>,
) -> Result<Checked, Diagnostic>
where
    Keys: for<'text> Deserialize<'text>,
{
    let text = without_mark(text);
    let table = DeTable::parse(text).map_err(|error| syntax::explain(book, &error, text, name))?;
    let root = DeValue::Table(table.into_inner());
    if root.as_table().is_some_and(|table| table.is_empty()) {
        let Book { noun, smallest, .. } = book;
        return Err(Diagnostic::new(name, format!("the {noun} is empty"))
            .with_help(format!("the smallest {noun} is:\n{smallest}")));
    }
    let keys = Keys::deserialize(Reader::new(Node::Read(&root), Place::default()))
        .map_err(|fault| explain::explain(book, fault, text, name))?;
    checked(keys).map_err(|conflict| place(&conflict, &root, text, name))
}

/// The keys in a tree that was made, such as one of a scene with a number replaced.
///
/// # Errors
/// The first fault, in words.
pub(super) fn read_made<Keys>(tree: &toml::Value) -> Result<Keys, String>
where
    Keys: for<'tree> Deserialize<'tree>,
{
    Keys::deserialize(Reader::new(Node::Made(tree), Place::default())).map_err(Fault::into_words)
}

/// Whether the text has one of these `keys` at its top level, as far as a broken text can be parsed.
pub(super) fn names_any(text: &str, keys: &[&str]) -> bool {
    let (table, _) = DeTable::parse_recoverable(without_mark(text));
    keys.iter().any(|key| table.get_ref().contains_key(*key))
}

/// The text without the byte order mark that some editors write, which would shift every column of the first line.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// The diagnostic of a conflict, at the place of its key.
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
    // An absent key has the place of its table.
    while let Some(next) = parts.next().and_then(|part| value.get_ref().get(part)) {
        value = next;
    }
    Some(value.span())
}
