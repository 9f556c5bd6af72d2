//! Output files of one folder.

use std::io::Write;
use std::path::Path;

use lyapunov_lab::{OutputError, sync_folder};

use super::output::{Output, Written};

/// Output files of one folder, all of which are on the disk before the first takes its name.
#[derive(Debug)]
pub(crate) struct Outputs<'a> {
    folder: &'a Path,
    written: Vec<Written>,
}

impl<'a> Outputs<'a> {
    /// No files yet, for `folder`.
    pub(crate) fn of(folder: &'a Path) -> Self {
        Self { folder, written: Vec::new() }
    }

    /// Adds a file that has been written already.
    ///
    /// # Errors
    /// A full device.
    pub(crate) fn add(&mut self, output: Output) -> Result<(), OutputError> {
        self.written.push(output.written()?);
        Ok(())
    }

    /// Writes several files, each given by name and bytes.
    ///
    /// # Errors
    /// As [`Output::create`], and a full device.
    pub(crate) fn put_all(
        &mut self,
        files: impl IntoIterator<Item = (String, Vec<u8>)>,
    ) -> Result<(), OutputError> {
        files.into_iter().try_for_each(|(name, bytes)| {
            let mut output = Output::create(&self.folder.join(name))?;
            output.write_all(&bytes).map_err(|error| output.blame(error))?;
            self.add(output)
        })
    }

    /// Moves all files to their names, one after the other.
    ///
    /// # Errors
    /// As [`Output::keep`]; the files before the failed one have their names then, each of them whole.
    pub(crate) fn keep(self) -> Result<(), OutputError> {
        let mut folders = Vec::new();
        for written in self.written {
            folders.extend(written.keep()?);
        }
        // A link may lead to another folder.
        folders.dedup();
        let sync = |folder: &std::path::PathBuf| {
            sync_folder(folder).map_err(|error| OutputError::new(folder, error))
        };
        folders.iter().try_for_each(sync)
    }
}
