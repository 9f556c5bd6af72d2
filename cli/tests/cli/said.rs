//! What the command said, and how it ended.

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// The widest line that fits a terminal.
const WIDTH: usize = 100;

/// Longer than any command here takes on a busy machine; one that is still there by then hangs.
const PATIENCE: Duration = Duration::from_secs(60);

/// A command that has ended.
#[derive(Debug)]
pub(crate) struct Said {
    /// The exit status; none if a signal ended it.
    pub(crate) status: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
    /// How long it took to end.
    pub(crate) took: Duration,
}

impl Said {
    pub(crate) fn by(command: &mut Command) -> Self {
        Self::by_child(command.stdin(Stdio::null()).start(Stdio::piped()))
    }

    /// Waits for the end, and ends what does not.
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

    /// Everything that was said, in one line, so that a folded sentence is found.
    fn unfolded(&self) -> String {
        let all = format!("{} {}", self.out, self.err);
        all.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// The exit status is `status`, every one of `words` was said, and what was said is fit for a person.
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

    /// No line is wider than a terminal.
    #[track_caller]
    pub(crate) fn fits(&self) {
        for line in self.out.lines().chain(self.err.lines()) {
            assert!(line.chars().count() <= WIDTH, "too wide: {line}");
        }
    }
}

/// Starts a command whose standard error is caught and whose standard output goes to `out`.
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
