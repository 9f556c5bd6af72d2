//! How results are shown: tables, pages, lines of text and comma-separated values.

pub mod csv;
pub(crate) mod described;
pub(crate) mod html;
pub mod output_error;
mod summary;
pub(crate) mod table;
