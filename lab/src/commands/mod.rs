//! What the command line offers, and how its commands end.

mod observe;
mod paper;
mod run;
mod source;

use std::fmt::Display;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Parser;

/// Simulate sampled loops under stabilizers that watch a Lyapunov candidate.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Debug, Parser)]
#[command(name = "lyapunov", version, max_term_width = 100)]
pub(crate) enum Command {
    Run(run::Run),
    Paper(paper::Paper),
    Observe(observe::Observe),
}

impl Command {
    pub(crate) fn run(self) -> ExitCode {
        // Without the handler an interrupt ends the process at once, which loses nothing but tidiness.
        let _ = ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed));
        let end = match self {
            Self::Run(run) => run.run(),
            Self::Paper(paper) => paper.run(),
            Self::Observe(observe) => observe.run(),
        };
        match end {
            Ok(()) => ExitCode::SUCCESS,
            Err(end) => end.report(),
        }
    }
}

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Why a command ends before it is done.
#[derive(Debug)]
pub(crate) enum End {
    /// Whoever reads the output has read enough.
    Enough,
    /// What was asked for is not right; the message says what would be.
    Input(String),
    /// Something here is not right.
    Internal(String),
    Interrupted,
}

impl End {
    pub(crate) fn input(message: impl Display) -> Self {
        let message = message.to_string();
        Self::Input(match message.strip_prefix("error: ") {
            Some(rest) => rest.to_owned(),
            None => message,
        })
    }

    pub(crate) fn internal(message: impl Display) -> Self {
        Self::Internal(message.to_string())
    }

    /// Ends a command that was interrupted; called now and then by whatever takes long.
    pub(crate) fn if_interrupted() -> Result<(), Self> {
        if INTERRUPTED.load(Ordering::Relaxed) { Err(Self::Interrupted) } else { Ok(()) }
    }

    fn report(self) -> ExitCode {
        match self {
            Self::Enough => ExitCode::SUCCESS,
            Self::Input(message) => {
                eprintln!("error: {message}");
                ExitCode::from(2)
            }
            Self::Internal(message) => {
                eprintln!("internal error: {message}");
                ExitCode::from(1)
            }
            Self::Interrupted => {
                eprintln!("interrupted; nothing was written");
                ExitCode::from(130)
            }
        }
    }
}
