//! Output and exit status of a command.

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// The widest line that fits a terminal.
const WIDTH: usize = 100;

/// Time after which a command counts as hanging; none here takes as long, even on a busy machine.
const PATIENCE: Duration = Duration::from_secs(240);

/// Output, exit status and duration of a command that has ended.
#[derive(Debug)]
pub(crate) struct Said {
    /// The exit status; none if a signal ended it.
    pub(crate) status: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
    /// Time that the command took to end.
    pub(crate) took: Duration,
}

impl Said {
    pub(crate) fn by(command: &mut Command) -> Self {
        Self::by_child(command.stdin(Stdio::null()).start(Stdio::piped()))
    }

    /// Waits for the end, and kills a command that hangs.
    pub(crate) fn by_child(mut child: Child) -> Self {
        let start = Instant::now();
        let out = child.stdout.take().map(|pipe| thread::spawn(|| text(pipe)));
        let err = child.stderr.take().map(|pipe| thread::spawn(|| text(pipe)));
        let status = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break status;
            }
            if start.elapsed() > PATIENCE {
                child.kill().unwrap();
                child.wait().unwrap();
                panic!("the command hangs");
            }
            thread::sleep(Duration::from_millis(2));
        };
        let took = start.elapsed();
        let text = |reader: Option<thread::JoinHandle<String>>| {
            reader.map_or(String::new(), |reader| reader.join().unwrap())
        };
        Self { status: status.code(), out: text(out), err: text(err), took }
    }

    /// All output in one line, so that a wrapped sentence is found.
    fn unfolded(&self) -> String {
        let all = format!("{} {}", self.out, self.err);
        all.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Asserts that the exit status is `status`, and that the output holds every one of `words` and no internals.
    #[track_caller]
    pub(crate) fn ended(&self, status: i32, words: &[&str]) {
        assert_eq!(self.status, Some(status), "{self:?}");
        let unfolded = self.unfolded();
        for word in words {
            assert!(unfolded.contains(word), "no {word:?} in:\n{}{}", self.out, self.err);
        }
        for word in ["panicked", ".lyapunov-", "internal error:"] {
            assert!(!unfolded.contains(word), "{word:?} in:\n{}{}", self.out, self.err);
        }
    }

    /// Asserts that no line is wider than a terminal.
    #[track_caller]
    pub(crate) fn fits(&self) {
        for line in self.out.lines().chain(self.err.lines()) {
            assert!(line.chars().count() <= WIDTH, "too wide: {line}");
        }
    }
}

/// Start of a command with its standard error captured and its standard output sent to `out`.
pub(crate) trait Start {
    fn start(&mut self, out: Stdio) -> Child;
}

impl Start for Command {
    fn start(&mut self, out: Stdio) -> Child {
        self.stdout(out).stderr(Stdio::piped()).spawn().unwrap()
    }
}

fn text(mut pipe: impl Read) -> String {
    let mut bytes = Vec::new();
    pipe.read_to_end(&mut bytes).unwrap();
    String::from_utf8_lossy(&bytes).into_owned()
}
