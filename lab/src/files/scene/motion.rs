//! Recorded motions of the operator's hand.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::sync::Arc;

use super::Draft;
use super::check::Conflict;
use super::operator::Motion;

/// The largest file in bytes.
const LIMIT: u64 = 1 << 26;

const KEY: &str = "operator.motion.path";

const EXPECTED: &str = "a motion is CSV with the columns t,rest in s and m, t increasing";

impl Draft {
    /// Reads the recorded motion that the scene names, if it names one; its path is relative to `folder`.
    pub(crate) fn read_motion(&mut self, folder: &Path) -> Result<(), Conflict> {
        let Some(Motion::File { path, samples }) = &mut self.operator.motion else {
            return Ok(());
        };
        *path = folder.join(&*path);
        *samples = read(path).map_err(|problem| Conflict::new(KEY, problem, EXPECTED))?;
        Ok(())
    }
}

fn read(path: &Path) -> Result<Arc<[(f64, f64)]>, String> {
    let shown = path.display();
    let refused = |error| format!("`{shown}` cannot be read: {error}");
    let file = File::open(path).map_err(refused)?;
    if file.metadata().is_ok_and(|metadata| metadata.len() > LIMIT) {
        return Err(format!("`{shown}` is too large for a motion: more than {LIMIT} bytes"));
    }
    let mut samples: Vec<(f64, f64)> = Vec::new();
    let mut has_names = false;
    for (index, line) in BufReader::new(file.take(LIMIT)).lines().enumerate() {
        let line = line.map_err(refused)?;
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() {
            continue;
        }
        let at = |problem: String| format!("`{shown}`, line {}: {problem}", index + 1);
        if !has_names {
            let names: Vec<&str> = line.split(',').map(str::trim).collect();
            if names != ["t", "rest"] {
                return Err(at(format!("the columns are `{line}`, not `t,rest`")));
            }
            has_names = true;
            continue;
        }
        let sample = sample(line).ok_or_else(|| at(format!("`{line}` is not two numbers")))?;
        if samples.last().is_some_and(|last| sample.0 <= last.0) {
            return Err(at(format!("t = {} does not come after the row before", sample.0)));
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
