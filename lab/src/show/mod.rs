//! Presentation of results: tables, pages, lines of text and comma-separated values.

pub(crate) mod beside;
pub(crate) mod csv;
pub(crate) mod described;
pub(crate) mod energy_bars;
pub(crate) mod envelope;
pub(crate) mod html;
pub(crate) mod json;
pub(crate) mod labelled;
pub(crate) mod output_error;
pub(crate) mod row_file;
mod summary;
pub(crate) mod sync_folder;
pub(crate) mod table;
pub(crate) mod verdict;

pub(crate) use output_error::OutputError;
pub(crate) use sync_folder::sync_folder;
