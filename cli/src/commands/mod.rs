//! What the command line offers, and how its commands end.

mod accuracy;
mod bound;
mod compare;
mod effects;
mod explain;
mod folder;
mod hard;
mod map;
mod observe;
mod paper;
mod run;
mod scenes;
mod schema;
mod source;
mod subjects;

use std::fmt::Display;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::Path;
use std::process::{self, ExitCode};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use lyapunov_lab::OutputError;

/// Simulate sampled loops under stabilizers that watch a Lyapunov candidate.
#[derive(Debug, Parser)]
#[command(
    name = "lyapunov",
    version,
    max_term_width = 100,
    after_help = "Exit status: 0 done, 1 internal error or a hard case that failed, 2 bad input, 130 interrupted."
)]
pub(crate) enum Command {
    Run(run::Run),
    Compare(compare::Compare),
    Map(Box<map::Map>),
    Bound(bound::Bound),
    Explain(explain::Explain),
    Paper(paper::Paper),
    Hard(hard::Hard),
    Observe(observe::Observe),
    Effects(effects::Effects),
    Accuracy(accuracy::Accuracy),
    Scenes(scenes::Scenes),
    Schema(schema::Schema),
}

impl Command {
    pub(crate) fn run(self) -> ExitCode {
        let end = match self {
            Self::Run(run) => run.run(),
            Self::Compare(compare) => compare.run(),
            Self::Map(map) => map.run(),
            Self::Bound(bound) => bound.run(),
            Self::Explain(explain) => explain.run(),
            Self::Paper(paper) => paper.run(),
            Self::Hard(hard) => hard.run(),
            Self::Observe(observe) => observe.run(),
            Self::Effects(effects) => effects.run(),
            Self::Accuracy(accuracy) => accuracy.run(),
            Self::Scenes(scenes) => scenes.run(),
            Self::Schema(schema) => schema.run(),
        };
        match end {
            Ok(()) => ExitCode::SUCCESS,
            Err(end) => ExitCode::from(end.report()),
        }
    }
}

/// How a share of something known looks while it grows.
const BAR: &str = "{bar:40} {percent:>3} %, {eta} left";

/// The bar in this form, hidden where nobody looks: unless standard output and standard error are both a terminal.
pub(crate) fn shown(bar: ProgressBar, template: &str) -> ProgressBar {
    if !io::stdout().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(template);
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// How long a command that leaves nothing behind may take to end after an interrupt.
const GRACE: Duration = Duration::from_millis(500);

/// From here on an interrupt lets the command end in its own way, through [`End::if_interrupted`].
///
/// A command that is not `tidying` up after itself is ended before long in any case: a write that nobody takes
/// never comes back to look.
pub(crate) fn heed_interrupts(tidying: bool) {
    // Without the handler an interrupt ends the process at once, which loses nothing but tidiness.
    let _ = ctrlc::set_handler(move || {
        INTERRUPTED.store(true, Ordering::Relaxed);
        if !tidying {
            thread::sleep(GRACE);
            process::exit(End::Interrupted.report().into());
        }
    });
}

/// Says something on standard error; where that is closed or full, nobody listens, and the exit status says it.
pub(crate) fn say(message: impl Display) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// Why a command ends before it is done.
#[derive(Debug)]
pub(crate) enum End {
    /// Whoever reads the output has read enough.
    Enough,
    /// What was asked for is not right; the message says what would be.
    Input(String),
    /// Something that is promised does not hold.
    Failed(String),
    /// Something here is not right.
    Internal(String),
    Interrupted,
    /// Interrupted, with something left to go on from; the message says what.
    Kept(String),
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

    /// Tells why, and gives the exit status.
    fn report(self) -> u8 {
        match self {
            Self::Enough => 0,
            Self::Input(message) => {
                say(format_args!("error: {message}"));
                2
            }
            Self::Failed(message) => {
                say(message);
                1
            }
            Self::Internal(message) => {
                say(format_args!("internal error: {message}"));
                1
            }
            Self::Interrupted => {
                say("interrupted; no file was written");
                130
            }
            Self::Kept(message) => {
                say(message);
                130
            }
        }
    }
}

/// What an error of standard output means: a closed pipe is no fault.
pub(crate) fn standard_output(error: io::Error) -> End {
    match error.kind() {
        ErrorKind::BrokenPipe => End::Enough,
        _ => End::input(OutputError::new(Path::new("standard output"), error)),
    }
}
