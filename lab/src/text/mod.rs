//! The lowest layer: text helpers for every other layer, independent of the subject of the text.

mod checksum;
pub(crate) mod excerpt;
mod file_name;
pub(crate) mod names;
pub(crate) mod numbers;
mod prefix;
mod shell;
pub(crate) mod suggest;
pub(crate) mod words;

pub(crate) use checksum::Checksum;
pub use excerpt::legible;
pub(crate) use excerpt::shorten;
pub(crate) use file_name::file_name;
pub(crate) use numbers::{found, given, near_one, to_digits};
pub(crate) use prefix::{prefix, prefixed};
pub use shell::shell_word;
pub(crate) use suggest::nearest;
pub(crate) use words::{at_commas, counted, folded, listed, shortened_names};
