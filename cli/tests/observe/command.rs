//! Runs of the command under test.

use std::io::Write;
use std::process::{Child, Command, Stdio};

/// Exit status and output of the command.
#[derive(Debug)]
pub(crate) struct Ended {
    pub(crate) status: Option<i32>,
    pub(crate) out: String,
    pub(crate) error: String,
}

pub(crate) fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
    command.arg("observe").args(arguments);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// The command over a log that comes in by standard input.
pub(crate) fn observe(log: &[u8], arguments: &[&str]) -> Ended {
    let mut child = command(&[&["-"], arguments].concat()).stdin(Stdio::piped()).spawn().unwrap();
    // A command that ends early closes the pipe, which is no error.
    let _ = child.stdin.take().unwrap().write_all(log);
    ended(child)
}

pub(crate) fn run(arguments: &[&str]) -> Ended {
    ended(command(arguments).spawn().unwrap())
}

pub(crate) fn ended(child: Child) -> Ended {
    let output = child.wait_with_output().unwrap();
    Ended {
        status: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        error: String::from_utf8(output.stderr).unwrap(),
    }
}
