//! Files of a call that do not fit, while the others go on.

use super::End;

/// Files that were left out of a call with several, each with its reason.
#[derive(Debug)]
pub(crate) struct LeftOut {
    /// The number of files in the call.
    of: usize,
    reasons: Vec<String>,
}

impl LeftOut {
    /// Nothing left out yet `of` so many files.
    pub(crate) fn of(of: usize) -> Self {
        Self { of, reasons: Vec::new() }
    }

    /// The reasons, each with the name of its file.
    pub(crate) fn reasons(&self) -> &[String] {
        &self.reasons
    }

    /// The result, or none for a file whose input is wrong, which is left out.
    ///
    /// # Errors
    /// Any other end, and wrong input in a call with a single file.
    pub(crate) fn unless<T>(&mut self, result: Result<T, End>) -> Result<Option<T>, End> {
        match result {
            Ok(it) => Ok(Some(it)),
            Err(End::Input(reason)) if self.of > 1 => {
                self.reasons.push(reason);
                Ok(None)
            }
            Err(end) => Err(end),
        }
    }

    /// The results.
    ///
    /// # Errors
    /// No result at all.
    pub(crate) fn unless_all<T>(&self, results: Vec<T>) -> Result<Vec<T>, End> {
        if results.is_empty() { Err(self.told()) } else { Ok(results) }
    }

    /// The end of the call.
    ///
    /// # Errors
    /// Files that were left out.
    pub(crate) fn end(&self) -> Result<(), End> {
        if self.reasons.is_empty() { Ok(()) } else { Err(self.told()) }
    }

    fn told(&self) -> End {
        let reasons: Vec<String> =
            self.reasons.iter().map(|reason| reason.replace('\n', "\n    ")).collect();
        let (count, of) = (reasons.len(), self.of);
        End::input(format!("{count} of {of} files left out\n  - {}", reasons.join("\n  - ")))
    }
}
