//! Faults in words: the problem and the remedy.

use super::book::{Book, Key};
use super::diagnostic::Diagnostic;
use super::fault::{Fault, Found, Place, Problem};
use crate::text::{nearest, shorten};

/// The most tables named for a misplaced key.
const MOST_HOMES: usize = 3;

/// The message of a fault in the text.
pub(super) fn explain(book: &Book, fault: Fault, text: &str, name: &str) -> Diagnostic {
    let (problem, mut place) = fault.into_parts();
    let path = place.path();
    if path.is_empty() {
        // A fault of the whole text has no span of its own; it marks the first line that is not blank.
        let first = text.len() - text.trim_start().len();
        place.span = first..first;
    }
    let given = source(text, &place);
    let diagnostic = |message: String| {
        Diagnostic::new(name, message)
            .with_excerpt(text, place.span.clone())
            .with_key(shorten_path(&path))
    };
    match problem {
        Problem::UnknownKey { known } => {
            let message =
                format!("unknown key `{}` {}", shorten(&place.name), within(&place.table));
            unknown_key(book, diagnostic(message), &place, known)
        }
        Problem::UnknownWord { known } => {
            wrong_word(book, diagnostic, &place, known, Found::Value("the text"), given)
        }
        Problem::NotWord { known, found } => {
            wrong_word(book, diagnostic, &place, known, found, given)
        }
        Problem::Missing { key } => {
            let missing = place.child(key, place.span.clone());
            missing_key(book, diagnostic, &missing)
        }
        Problem::WrongKind { expected, found } => {
            let message = format!(
                "`{}` must be {expected}, not {}",
                shorten_path(&path),
                repeat(found, &given)
            );
            let diagnostic = diagnostic(message).with_value(Some(given.clone()));
            if expected == "a table" {
                table_help(book, diagnostic, &path, &given, found)
            } else {
                with_example(book, diagnostic, &path)
            }
        }
        Problem::Refused { sentence } => {
            let message = format!("`{}` {}", shorten_path(&path), sentence);
            with_example(book, diagnostic(message).with_value(Some(given)), &path)
        }
        Problem::NoneChosen { known } => {
            let message = format!("[{}] is empty", shorten_path(&path));
            let needed = format!("it needs one of {}", headers(book, &path, known));
            diagnostic(message).with_help(needed)
        }
        Problem::SeveralChosen { chosen, known } => {
            several(book, diagnostic, &place, &chosen, known)
        }
    }
}

fn unknown_key(
    book: &Book,
    mut diagnostic: Diagnostic,
    place: &Place,
    known: &[&'static str],
) -> Diagnostic {
    if let Some(near) = nearest(&place.name, known) {
        diagnostic = diagnostic.with_help(format!("did you mean `{near}`?"));
    }
    if let Some(home) = home(book, place) {
        diagnostic = diagnostic.with_help(home);
    }
    diagnostic.with_help(format!("known keys here: {}", known.join(", ")))
}

/// The tables to which a misplaced key belongs, in words.
fn home(book: &Book, place: &Place) -> Option<String> {
    let path = place.path();
    let homes = book.all().filter(|key| key.name() == place.name && key.path != path);
    // A misplaced key most likely belongs to an inner table of the one it stands in.
    let within = format!("{}.", place.table);
    let (inner, outer): (Vec<&Key>, Vec<_>) = homes.partition(|key| key.path.starts_with(&within));
    let homes: Vec<_> = inner.into_iter().chain(outer).take(MOST_HOMES).collect();
    let first = homes.first()?;
    let name = first.name();
    if first.is_table() {
        return Some(format!("`{name}` is a table of its own: [{}]", first.path));
    }
    let table = |key: &&Key| match key.table() {
        "" => "the top level (above the first [table])".to_owned(),
        table => format!("[{table}]"),
    };
    let tables: Vec<_> = homes.iter().map(table).collect();
    Some(format!("`{name}` is a key of {}", tables.join(", ")))
}

fn wrong_word(
    book: &Book,
    diagnostic: impl Fn(String) -> Diagnostic,
    place: &Place,
    known: &[&'static str],
    found: Found,
    given: String,
) -> Diagnostic {
    let path = place.path();
    let repeated = repeat(found, &given);
    if book.find(&path).is_some_and(Key::is_table) {
        let diagnostic = diagnostic(format!("`{path}` must be a table, not {repeated}"))
            .with_help(format!("the tables it can be: {}", headers(book, &path, known)));
        return with_example(book, diagnostic, &path).with_value(Some(given));
    }
    let mut diagnostic = diagnostic(format!("`{}` cannot be {repeated}", shorten_path(&path)));
    if let Some(near) = nearest(bare(&given), known) {
        diagnostic = diagnostic.with_help(format!("did you mean \"{near}\"?"));
    }
    let words: Vec<_> = known.iter().map(|word| format!("\"{word}\"")).collect();
    let help = format!("it is one of: {}", words.join(", "));
    diagnostic.with_help(help).with_value(Some(given))
}

fn missing_key(
    book: &Book,
    diagnostic: impl Fn(String) -> Diagnostic,
    missing: &Place,
) -> Diagnostic {
    let path = missing.path();
    let Some(key) = book.find(&path) else {
        return diagnostic(format!("missing key `{path}`")).with_key(path);
    };
    if key.is_table() {
        let header = key.example.lines().next().unwrap_or_default();
        let within = format!("{}.", header.trim_matches(['[', ']']));
        let first = book.all().find(|key| key.path.starts_with(&within));
        let first = first.map_or(path.as_str(), |key| key.path);
        return diagnostic(format!("missing key `{first}`: there is no [{path}]"))
            .with_key(first)
            .with_help(format!("add, for example:\n{}", key.example));
    }
    let place = if missing.table.is_empty() {
        "above the first [table]".to_owned()
    } else {
        format!("to [{}]", missing.table)
    };
    let unit = if key.unit.is_empty() { String::new() } else { format!(", in {}", key.unit) };
    diagnostic(format!("missing key `{path}`{unit}"))
        .with_key(path.as_str())
        .with_help(format!("add {place}, for example:\n{}", key.example))
}

fn table_help(
    book: &Book,
    diagnostic: Diagnostic,
    path: &str,
    given: &str,
    found: Found,
) -> Diagnostic {
    let chosen = format!("{path}.{}", bare(given));
    let path = if book.find(&chosen).is_some() { &chosen } else { path };
    let diagnostic = with_example(book, diagnostic, path);
    if found == Found::Structure("a list") {
        diagnostic.with_help("a table header has single brackets: [[name]] makes a list of tables")
    } else {
        diagnostic
    }
}

fn several(
    book: &Book,
    diagnostic: impl Fn(String) -> Diagnostic,
    place: &Place,
    chosen: &[String],
    known: &[&'static str],
) -> Diagnostic {
    let count = match chosen.len() {
        2 => "two".to_owned(),
        more => more.to_string(),
    };
    let quote = |name: &String| format!("`{}`", shorten(name));
    let mut names: Vec<_> = chosen.iter().take(4).map(quote).collect();
    let last = names.pop().unwrap_or_default();
    let noun = &place.name;
    let message =
        format!("{count} {noun}s, {} and {last}: a {} has only one", names.join(", "), book.noun);
    let path = format!("{}.{}", place.path(), chosen.first().map_or("", String::as_str));
    let kind = if book.find(&path).is_none_or(Key::is_table) { "tables" } else { "keys" };
    let mut diagnostic = diagnostic(message).with_help(format!("keep one of these {kind}"));
    for name in chosen.iter().take(4) {
        if !known.contains(&name.as_str()) {
            diagnostic = diagnostic.with_help(format!(
                "there is no {noun} {}; known: {}",
                quote(name),
                known.join(", ")
            ));
        }
    }
    diagnostic
}

/// The diagnostic with the unit of the key and a correct example line.
pub(super) fn with_example(book: &Book, diagnostic: Diagnostic, path: &str) -> Diagnostic {
    match book.find(path) {
        None => diagnostic,
        Some(key) if key.is_table() => {
            diagnostic.with_help(format!("for example:\n{}", key.example))
        }
        Some(key) if key.unit.is_empty() => {
            diagnostic.with_help(format!("for example: {}", key.example))
        }
        Some(key) => {
            diagnostic.with_help(format!("the unit is {}; for example: {}", key.unit, key.example))
        }
    }
}

fn headers(book: &Book, path: &str, known: &[&'static str]) -> String {
    let shown = |name: &&str| {
        let whole = format!("{path}.{name}");
        let is_table = book.find(&whole).is_none_or(Key::is_table);
        if is_table { format!("[{whole}]") } else { format!("`{name}`") }
    };
    let headers: Vec<_> = known.iter().map(shown).collect();
    headers.join(", ")
}

/// A text of the file without its quotes.
fn bare(given: &str) -> &str {
    given.trim_matches(['"', '\''])
}

fn repeat(found: Found, given: &str) -> String {
    match found {
        Found::Value(introduction) => format!("{introduction} {given}"),
        Found::Structure(structure) => structure.to_owned(),
    }
}

fn within(table: &str) -> String {
    if table.is_empty() {
        "at the top level".to_owned()
    } else {
        format!("in [{}]", shorten_path(table))
    }
}

fn source(text: &str, place: &Place) -> String {
    shorten(text.get(place.span.clone()).unwrap_or_default())
}

/// A path with each part shortened for a sentence.
pub(super) fn shorten_path(path: &str) -> String {
    let parts: Vec<_> = path.split('.').take(6).map(shorten).collect();
    parts.join(".")
}
