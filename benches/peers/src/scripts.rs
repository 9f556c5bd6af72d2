//! Peers that are Python packages: scripts that run a row on request, between the rows of this program. The protocol is
//! in `python/rows.py`.

use std::cell::RefCell;
use std::io::{BufRead, BufReader, Lines, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::rc::Rc;

use serde::Deserialize;

use crate::row::{Origin, Row, Setting};

/// Python packages, each with a script.
const PACKAGES: [&str; 3] = ["scipy", "mujoco", "drake"];

/// Scripts that could be started, with their rows.
#[derive(Default)]
pub(crate) struct Offers {
    pub(crate) rows: Vec<Row>,
    /// Packages and their versions.
    pub(crate) versions: Vec<[String; 2]>,
    /// Packages that cannot run here, and why.
    pub(crate) skipped: Vec<[String; 2]>,
}

impl Offers {
    /// Starts every script.
    pub(crate) fn gathered() -> Self {
        let mut offers = Self::default();
        for package in PACKAGES {
            if let Err(reason) = offers.gather(package) {
                offers.skipped.push([package.into(), reason]);
            }
        }
        offers
    }

    fn gather(&mut self, package: &str) -> Result<(), String> {
        let (script, first) = Script::started(package)?;
        let offer: Offer = script.read(&first)?;
        if let Some(reason) = offer.skipped {
            return Err(reason);
        }
        self.versions.push([package.into(), offer.version]);
        let script = Rc::new(RefCell::new(script));
        for (index, offered) in offer.rows.into_iter().enumerate() {
            let setting = match (offered.steps, offered.tolerance) {
                (Some(steps), _) => Setting::Steps(steps),
                (None, Some(tolerance)) => Setting::Tolerance(tolerance),
                (None, None) => Setting::None,
            };
            let script = Rc::clone(&script);
            self.rows.push(Row {
                origin: Origin::Python,
                method: offered.method,
                setting,
                run: Box::new(move |positions| {
                    let answer = script.borrow_mut().asked(index)?;
                    let count = answer.positions.len();
                    *positions = answer
                        .positions
                        .try_into()
                        .map_err(|_| format!("the script told {count} positions"))?;
                    Ok(answer.ns)
                }),
            });
        }
        Ok(())
    }
}

#[derive(Deserialize)]
struct Offer {
    #[serde(default)]
    version: String,
    #[serde(default)]
    rows: Vec<Offered>,
    skipped: Option<String>,
}

#[derive(Deserialize)]
struct Offered {
    method: String,
    steps: Option<u32>,
    tolerance: Option<f64>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Reply {
    Ran(Answer),
    Failed { failed: String },
}

#[derive(Deserialize)]
struct Answer {
    ns: f64,
    positions: Vec<f64>,
}

/// Running script that waits for the number of a row.
struct Script {
    name: PathBuf,
    process: Child,
    input: ChildStdin,
    lines: Lines<BufReader<ChildStdout>>,
}

impl Script {
    /// The script of `package`, and its first line of output.
    fn started(package: &str) -> Result<(Self, String), String> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let python = folder.join("../../target/peers-python/bin/python");
        if !python.exists() {
            return Err("no Python packages here yet: run benches/peers/python/install.sh".into());
        }
        let name = folder.join("python").join(format!("{package}_rows.py"));
        let command = Command::new(python)
            .arg(&name)
            // Threads do not pay for matrices of three rows.
            .env("OPENBLAS_NUM_THREADS", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut process = command.map_err(|error| format!("Python does not start: {error}"))?;
        let (Some(input), Some(output)) = (process.stdin.take(), process.stdout.take()) else {
            return Err("Python starts without input or output".into());
        };
        let lines = BufReader::new(output).lines();
        let mut script = Self { name, process, input, lines };
        let first = script.line()?;
        Ok((script, first))
    }

    fn asked(&mut self, row: usize) -> Result<Answer, String> {
        let ask = writeln!(self.input, "{row}").and_then(|()| self.input.flush());
        ask.map_err(|error| format!("{} takes no questions: {error}", self.name.display()))?;
        let line = self.line()?;
        match self.read(&line)? {
            Reply::Ran(answer) => Ok(answer),
            Reply::Failed { failed } => Err(failed),
        }
    }

    fn line(&mut self) -> Result<String, String> {
        match self.lines.next() {
            Some(Ok(line)) => Ok(line),
            _ => Err(format!("{} has ended", self.name.display())),
        }
    }

    fn read<T: for<'a> Deserialize<'a>>(&self, line: &str) -> Result<T, String> {
        serde_json::from_str(line).map_err(|error| {
            format!("{} says what is not understood: {error}", self.name.display())
        })
    }
}

impl Drop for Script {
    /// Ends the script, which has no state to save and would otherwise wait for requests.
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
