//! Messages about text that is not TOML, in plain words.

use std::ops::Range;

use super::book::Book;
use super::diagnostic::Diagnostic;
use super::explain::{shorten_path, with_example};
use crate::text::excerpt::boundary;
use crate::text::shorten;

const NUMBERS: &str =
    "a number is written as 0.5, -4e-3, 100 or inf, without a unit, spaces or a comma";

/// The beginning of a parser's message, the message in its place, and the remedy.
const SENTENCES: &[(&str, &str, &str)] = &[
    ("unexpected key or value", "the line should end here", "one key or one [table] on each line"),
    (
        "cannot extend value",
        "this name has a value already and cannot be a table as well",
        "keep one of the two",
    ),
    (
        "key with no value",
        "a key must be followed by `=`",
        "write `key = value`; a comment begins with #",
    ),
    ("unclosed table", "the table header lacks its closing `]`", "write [name]"),
    ("unclosed array table", "the table header lacks its closing `]]`", "write [name]"),
    ("unclosed array", "the list lacks its closing `]`", "write [1, 2]"),
    ("unclosed inline table", "the table lacks its closing `}`", "write { key = value }"),
    (
        "missing comma between array elements",
        "the list before this lacks a comma or its closing `]`",
        "write [1, 2]",
    ),
    (
        "missing comma between key-value pairs",
        "the table before this lacks a comma or its closing `}`",
        "write { key = value, key = value }",
    ),
    (
        "missing key for inline table element",
        "a key or the table's closing `}` is missing here",
        "write { key = value, key = value }",
    ),
    ("invalid basic string", "the text lacks its closing quote", "write \"text\" on one line"),
    ("invalid literal string", "the text lacks its closing quote", "write \"text\" on one line"),
    (
        "missing escaped value",
        "the text has an unknown escape after `\\`",
        "a backslash is written `\\\\`",
    ),
    (
        "unquoted keys cannot be empty",
        "the name of a key is missing",
        "write `key = value` or [name]",
    ),
    (
        "invalid unquoted key",
        "this character cannot be in a key",
        "keys have letters, digits, `_` and `-`",
    ),
    ("extra `=`", "there is one `=` too many", "write `key = value`"),
    ("invalid mantissa", "this is not a number", NUMBERS),
    ("invalid fraction", "this is not a number", NUMBERS),
    ("invalid exponent", "this is not a number", NUMBERS),
    ("unexpected leading zero", "a number cannot begin with a zero before other digits", NUMBERS),
    ("redundant numeric sign", "a number has at most one sign", NUMBERS),
    ("`_` may only go between digits", "a number has `_` only between digits", NUMBERS),
    ("invalid comment character", "a comment holds a control character", "remove the character"),
    (
        "carriage return must be",
        "a carriage return stands without a newline",
        "end lines with LF or CRLF",
    ),
    (
        "cannot recurse further",
        "tables or lists are nested too deeply",
        "no file here needs more than three levels",
    ),
    (
        "recursion limit",
        "tables or lists are nested too deeply",
        "no file here needs more than three levels",
    ),
];

/// The parser's message for a key or table given twice.
const DUPLICATE: &str = "duplicate key";

/// The beginnings of the parser's messages for a value that TOML does not know.
const BARE_VALUES: &[&str] = &["string values must be quoted", "invalid boolean", "invalid float"];

/// The message of a parser's error.
pub(super) fn explain(book: &Book, error: &toml::de::Error, text: &str, name: &str) -> Diagnostic {
    let span = error.span().unwrap_or_default();
    let given = text.get(span.clone()).unwrap_or_default().trim();
    let (mut path, mut value) = assignment_at(text, span.start).unwrap_or_default();
    let (message, help) = match error.message() {
        DUPLICATE => {
            if path.is_empty() {
                (path, value) = (given.to_owned(), "");
            }
            let message = format!("`{}` is given twice in the same table", shorten(given));
            (message, "keep one of the two, and write each [table] once".to_owned())
        }
        message if message.starts_with("unexpected key or value") && decimal_comma(value) => {
            (format!("`{}` is not a number", shorten(value)), NUMBERS.to_owned())
        }
        message if BARE_VALUES.iter().any(|begin| message.starts_with(begin)) => {
            unquoted(given, value)
        }
        message => sentence(book, message),
    };
    let diagnostic = Diagnostic::new(name, message)
        .with_excerpt(text, visible(text, span))
        .with_key(shorten_path(&path))
        .with_value(Some(shorten(value)).filter(|value| !value.is_empty()))
        .with_help(help);
    if error.message() == DUPLICATE { diagnostic } else { with_example(book, diagnostic, &path) }
}

fn decimal_comma(value: &str) -> bool {
    let part = |character: char| character.is_ascii_digit() || "+-., ".contains(character);
    value.contains(',') && value.chars().all(part)
}

/// The problem and the remedy of a bare value that TOML does not know.
fn unquoted(given: &str, value: &str) -> (String, String) {
    if given.is_empty() {
        let help = "write `key = value` on one line".to_owned();
        return ("a value is missing after `=`".to_owned(), help);
    }
    let begins_number = |first: char| first.is_ascii_digit() || "+-.".contains(first);
    for number in [given, value] {
        if number.starts_with(begins_number) {
            return (format!("`{}` is not a number", shorten(number)), NUMBERS.to_owned());
        }
    }
    let short = shorten(given);
    let small = given.to_ascii_lowercase();
    if ["inf", "nan", "true", "false"].contains(&small.as_str()) {
        return (format!("`{short}` is not a value"), format!("in small letters: {small}"));
    }
    (format!("the text `{short}` lacks its quotes"), format!("write \"{short}\""))
}

fn sentence(book: &Book, message: &str) -> (String, String) {
    let known = SENTENCES.iter().find(|(begin, ..)| message.starts_with(begin));
    match known {
        Some((_, sentence, help)) => ((*sentence).to_owned(), (*help).to_owned()),
        None => {
            let plain = message.trim_end_matches(", expected nothing");
            let noun = book.noun;
            let help = format!("a {noun} file is TOML: `key = value` lines below [table] headers");
            (format!("this is not TOML: {plain}"), help)
        }
    }
}

/// The same span, moved back from the end of the file to the last line that is not blank.
fn visible(text: &str, span: Range<usize>) -> Range<usize> {
    let written = text.trim_end().len();
    if span.start > written { written..written } else { span }
}

/// The key and the value of the line with this byte, as far as a broken text can be parsed; the key has the table path
/// of the header above it.
fn assignment_at(text: &str, offset: usize) -> Option<(String, &str)> {
    let start = text[..boundary(text, offset)].rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[start..].lines().next().unwrap_or_default();
    let (key, value) = line.split_once('=')?;
    let (key, value) = (key.trim(), value.split('#').next().unwrap_or_default().trim());
    let bare = |character: char| character.is_ascii_alphanumeric() || "_-.".contains(character);
    if key.is_empty() || !key.chars().all(bare) {
        return None;
    }
    let header = text[..start].lines().rev().find(|line| line.trim_start().starts_with('['));
    let Some(header) = header else {
        return Some((key.to_owned(), value));
    };
    let table = header.trim_start().trim_start_matches('[').split(']').next()?.trim();
    table.chars().all(bare).then(|| (format!("{table}.{key}"), value))
}
