//! Recorded motions of the operator's hand.

use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;
use std::sync::Arc;

use super::Draft;
use super::check::Conflict;
use super::operator::Motion;
use crate::text::{Checksum, legible, shorten};

/// The largest file in bytes.
const LIMIT: u64 = 1 << 26;

/// The longest line in bytes: no two numbers take as many, and a file of zeros is one long line.
const LONGEST: u64 = 1 << 12;

const KEY: &str = "operator.motion.path";

const EXPECTED: &str = "a motion is CSV with the columns t,rest in s and m, t increasing";

/// Opener of the files that scenes name.
pub(crate) type Open<'a> = &'a dyn Fn(&Path) -> io::Result<Box<dyn Read>>;

impl Draft {
    /// Reads the recorded motion that the scene names, if it names one; its path is relative to `folder`.
    pub(crate) fn read_motion(&mut self, folder: &Path, open: Open<'_>) -> Result<(), Conflict> {
        let Some(Motion::File { path, samples }) = &mut self.operator.motion else {
            return Ok(());
        };
        *path = folder.join(&*path);
        *samples = read(path, open).map_err(|problem| Conflict::new(KEY, problem, EXPECTED))?;
        Ok(())
    }

    /// The file that the scene names, a recorded motion, under the path at which it was read.
    pub fn named_file(&self) -> Option<&Path> {
        match &self.operator.motion {
            Some(Motion::File { path, .. }) => Some(path),
            _ => None,
        }
    }

    /// Checksum of the rows of the recorded motion, if there is one.
    pub(crate) fn motion_checksum(&self) -> Option<Checksum> {
        let Some(Motion::File { samples, .. }) = &self.operator.motion else { return None };
        let numbers = samples.iter().flat_map(|(t, rest)| [t, rest]);
        Some(numbers.fold(Checksum::EMPTY, |sum, it| sum.and(&it.to_bits().to_le_bytes())))
    }
}

fn read(path: &Path, open: Open<'_>) -> Result<Arc<[(f64, f64)]>, String> {
    let shown = legible(&path.display().to_string());
    let refused = |error| format!("`{shown}` cannot be read: {error}");
    let too_large = || format!("`{shown}` is too large for a motion: more than {LIMIT} bytes");
    // A device reports no size: reading one byte beyond the limit detects it.
    let mut lines = BufReader::new(open(path).map_err(refused)?.take(LIMIT + 1));
    let mut samples: Vec<(f64, f64)> = Vec::new();
    let (mut line, mut bytes, mut has_names) = (String::new(), 0, false);
    for number in 1_u64.. {
        line.clear();
        let read = lines.by_ref().take(LONGEST).read_line(&mut line).map_err(refused)? as u64;
        bytes += read;
        if read == 0 {
            break;
        }
        if bytes > LIMIT {
            return Err(too_large());
        }
        let at = |problem: String| format!("`{shown}`, line {number}: {problem}");
        if read == LONGEST && !line.ends_with('\n') {
            return Err(at(format!("`{}` goes on for too long for a row", shorten(&line))));
        }
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() {
            continue;
        }
        if !has_names {
            let names: Vec<&str> = line.split(',').map(str::trim).collect();
            if names != ["t", "rest"] {
                return Err(at(format!("the columns are `{}`, not `t,rest`", shorten(line))));
            }
            has_names = true;
            continue;
        }
        let sample =
            sample(line).ok_or_else(|| at(format!("`{}` is not two numbers", shorten(line))))?;
        if samples.last().is_some_and(|last| sample.0 <= last.0) {
            return Err(at(format!("t = {:?} does not come after the row before", sample.0)));
        }
        samples.push(sample);
    }
    if samples.is_empty() { Err(format!("`{shown}` has no rows")) } else { Ok(samples.into()) }
}

fn sample(line: &str) -> Option<(f64, f64)> {
    let (t, rest) = line.split_once(',')?;
    let (t, rest): (f64, f64) = (t.trim().parse().ok()?, rest.trim().parse().ok()?);
    (t.is_finite() && rest.is_finite()).then_some((t, rest))
}
