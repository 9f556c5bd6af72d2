//! The command, called with arguments, and what it says.

use std::ffi::OsStr;
use std::process::{Command, Output};

use serde_json::Value;

pub(crate) fn lyapunov<A: AsRef<OsStr>>(arguments: impl IntoIterator<Item = A>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lyapunov")).args(arguments).output().unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The output of a command that has to succeed and to say nothing besides.
#[track_caller]
pub(crate) fn prints<A: AsRef<OsStr>>(arguments: impl IntoIterator<Item = A>) -> String {
    let said = lyapunov(arguments);
    assert_eq!((said.status.code(), text(&said.stderr)), (Some(0), String::new()));
    text(&said.stdout)
}

/// Asserts that the command calls its input bad, in all of these words, and prints no result.
#[track_caller]
pub(crate) fn refuses<A: AsRef<OsStr>>(arguments: &[A], words: &[&str]) {
    let said = lyapunov(arguments);
    let err = text(&said.stderr);
    assert_eq!((said.status.code(), said.stdout.len()), (Some(2), 0), "{err}");
    assert!(!err.contains("panicked"), "{err}");
    words.iter().for_each(|word| assert!(err.contains(word), "no `{word}` in: {err}"));
}

/// Asserts that the lines of `csv` below its first are the `rows` of a JSON, key by key; null is an empty field.
#[track_caller]
pub(crate) fn holds_rows(csv: &str, rows: &[Value]) {
    let mut lines = csv.lines();
    let keys: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(lines.clone().count(), rows.len(), "{csv}");
    for (line, row) in lines.zip(rows) {
        let row = row.as_object().unwrap();
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!((fields.len(), row.len()), (keys.len(), keys.len()), "{line}");
        for (key, field) in keys.iter().zip(fields) {
            match &row[*key] {
                Value::Null => assert_eq!(field, "", "{key}"),
                Value::String(word) => assert_eq!(field, word, "{key}"),
                number => assert_eq!(field.parse().ok(), number.as_f64(), "{key}"),
            }
        }
    }
}
