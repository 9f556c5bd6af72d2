//! The command, called with arguments, and what it says.

use std::ffi::OsStr;
use std::process::{Command, Output};

pub(crate) fn lyapunov<A: AsRef<OsStr>>(arguments: impl IntoIterator<Item = A>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lyapunov")).args(arguments).output().unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Asserts that the command calls its input bad, in all of these words, and prints no result.
#[track_caller]
pub(crate) fn refuses(arguments: &[&OsStr], words: &[&str]) {
    let said = lyapunov(arguments);
    assert_eq!((said.status.code(), said.stdout.len()), (Some(2), 0));
    let err = text(&said.stderr);
    assert!(words.iter().all(|word| err.contains(word)), "{err}");
}
