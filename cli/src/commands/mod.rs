//! Commands of the command line, and the ways they end.

mod accuracy;
mod apart;
mod bound;
mod compare;
mod effects;
mod explain;
mod folder;
mod hard;
mod identify;
mod left_out;
mod map;
mod observe;
mod paper;
mod progress;
mod results;
mod run;
mod scenes;
mod schema;
mod source;
mod tune;

use std::borrow::Cow;
use std::ffi::OsString;
use std::fmt::Display;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use clap::{CommandFactory, FromArgMatches, Parser};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lyapunov_lab::{OutputError, legible};

use crate::files::is_any_kept;
use crate::interrupts;

/// End of the help of all commands.
const EXIT_STATUS: &str = "Exit status: 0 done, 1 internal error or a hard case that failed, 2 bad input, 130 interrupted.";

/// The commands that take names of stabilizers.
const NAMING: [&str; 4] = ["compare", "map", "tune", "hard"];

/// Simulate sampled loops under stabilizers that watch a Lyapunov candidate.
#[derive(Debug, Parser)]
#[command(
    name = "lyapunov",
    version,
    max_term_width = 100,
    after_help = EXIT_STATUS
)]
enum Command {
    Run(run::Run),
    Compare(compare::Compare),
    Map(Box<map::Map>),
    Bound(bound::Bound),
    Explain(explain::Explain),
    Paper(paper::Paper),
    Hard(hard::Hard),
    Observe(observe::Observe),
    Identify(identify::Identify),
    Tune(tune::Tune),
    Effects(effects::Effects),
    Accuracy(accuracy::Accuracy),
    Scenes(scenes::Scenes),
    Schema(schema::Schema),
}

impl Command {
    fn run(self) -> u8 {
        interrupts::heed();
        let end = match self {
            Self::Run(run) => run.run(),
            Self::Compare(compare) => compare.run(),
            Self::Map(map) => map.run(),
            Self::Bound(bound) => bound.run(),
            Self::Explain(explain) => explain.run(),
            Self::Paper(paper) => paper.run(),
            Self::Hard(hard) => hard.run(),
            Self::Observe(observe) => observe.run(),
            Self::Identify(identify) => identify.run(),
            Self::Tune(tune) => tune.run(),
            Self::Effects(effects) => effects.run(),
            Self::Accuracy(accuracy) => accuracy.run(),
            Self::Scenes(scenes) => scenes.run(),
            Self::Schema(schema) => schema.run(),
        };
        match end {
            Ok(()) => 0,
            Err(end) => end.report(),
        }
    }
}

/// Runs the command that `words` ask for, in a program whose own stabilizers are called `own`; returns the exit status.
pub(crate) fn run(own: &[&str], words: Vec<OsString>) -> u8 {
    let mut command = Command::command();
    if !own.is_empty() {
        let told = format!("Own stabilizers of this program: {}", own.join(", "));
        for name in NAMING {
            command = command.mut_subcommand(name, |it| it.after_help(told.clone()));
        }
        command = command.after_help(format!("{told}\n\n{EXIT_STATUS}"));
        let path = words.first().map(PathBuf::from);
        let name = path.as_deref().and_then(Path::file_stem).map(|it| it.to_string_lossy());
        // It is set once, here.
        let _ = PROGRAM.set(name.map_or_else(|| SHIPPED.to_owned(), Cow::into_owned));
    }
    // One command is run in a process.
    let words = WORDS.get_or_init(|| words);
    let asked = command.clone().try_get_matches_from(words).and_then(|words| {
        Command::from_arg_matches(&words).map_err(|error| error.format(&mut command))
    });
    match asked {
        Ok(asked) => asked.run(),
        Err(error) => answer(&error),
    }
}

/// Prints the help that is asked for, or what is wrong with the words, and returns the exit status.
fn answer(error: &clap::Error) -> u8 {
    match error.print() {
        Err(unprinted) if !error.use_stderr() => standard_output(unprinted).report(),
        _ => u8::try_from(error.exit_code()).unwrap_or(2),
    }
}

/// Whether `words` ask for a command that ships; what is wrong with them if not.
pub(crate) fn understand(words: impl IntoIterator<Item = OsString>) -> Result<(), String> {
    Command::try_parse_from(words).map(drop).map_err(|error| error.to_string())
}

/// The name of the binary that ships.
const SHIPPED: &str = "lyapunov";

static PROGRAM: OnceLock<String> = OnceLock::new();

/// The name of the program as it was called, and its arguments.
static WORDS: OnceLock<Vec<OsString>> = OnceLock::new();

/// The name of this program, for the command lines that reports tell.
pub(crate) fn program() -> &'static str {
    PROGRAM.get().map_or(SHIPPED, String::as_str)
}

/// The arguments of the command.
pub(crate) fn arguments() -> impl Iterator<Item = &'static OsString> {
    WORDS.get().into_iter().flatten().skip(1)
}

/// Template of a progress bar whose length is known.
const BAR: &str = "{bar:40} {percent:>3} %, {eta} left";

/// The bar in this form, unless the command is `quiet`; a line now and then unless standard output and standard error are
/// both a terminal.
pub(crate) fn shown(bar: ProgressBar, template: &str, quiet: bool) -> ProgressBar {
    if quiet {
        bar.set_draw_target(ProgressDrawTarget::hidden());
        return bar;
    }
    if !io::stdout().is_terminal() || !io::stderr().is_terminal() {
        return progress::in_lines(bar, template);
    }
    let style = ProgressStyle::with_template(template);
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Moves the bar on, and tells whether to go on.
pub(crate) fn advance(bar: &ProgressBar, by: u64) -> ControlFlow<()> {
    bar.inc(by);
    End::go_on()
}

/// Prints a result on standard output.
pub(crate) fn print(text: impl Display) -> Result<(), End> {
    let mut out = io::stdout().lock();
    let written = out.write_all(text.to_string().as_bytes());
    written.and_then(|()| out.flush()).map_err(standard_output)
}

/// Prints the result as `json` or `quiet` ask for it: the `document`, nothing, or the `words`.
pub(crate) fn tell(
    json: bool,
    quiet: bool,
    document: impl Display,
    words: impl Display,
) -> Result<(), End> {
    match (json, quiet) {
        (true, _) => print(document),
        (_, true) => Ok(()),
        _ => print(words),
    }
}

/// Prints a message on standard error. A closed or full stream is no error here: the exit status still reports the end.
///
/// Control characters are replaced, as file names and texts of others may be part of it.
pub(crate) fn say(message: impl Display) {
    let plain = |it: char| if it.is_control() && it != '\n' { '\u{fffd}' } else { it };
    let message: String = message.to_string().chars().map(plain).collect();
    let _ = writeln!(io::stderr(), "{message}");
}

/// Reason why a command ends before it is done.
#[derive(Debug)]
pub(crate) enum End {
    /// The reader of the output has closed it.
    Enough,
    /// The input is wrong; the message says what would be right.
    Input(String),
    /// A promise does not hold.
    Failed(String),
    /// A fault of the program itself.
    Internal(String),
    Interrupted,
    /// Interrupted, with an unfinished result kept to go on from; the message names it.
    Kept(String),
}

/// The path as the terminal may show it.
pub(crate) fn named(path: &Path) -> String {
    legible(&path.display().to_string())
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

    /// Error that ends an interrupted command. Long work calls this now and then.
    pub(crate) fn if_interrupted() -> Result<(), Self> {
        if interrupts::is_interrupted() { Err(Self::Interrupted) } else { Ok(()) }
    }

    /// Whether work is to go on, for what looks between ticks.
    pub(crate) fn go_on() -> ControlFlow<()> {
        if interrupts::is_interrupted() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Prints the reason and returns the exit status.
    pub(crate) fn report(self) -> u8 {
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
                let files =
                    if is_any_kept() { "the files are written" } else { "no file was written" };
                say(format_args!("interrupted; {files}"));
                130
            }
            Self::Kept(message) => {
                say(message);
                130
            }
        }
    }
}

/// End that an error of standard output calls for: a closed pipe is no fault.
pub(crate) fn standard_output(error: io::Error) -> End {
    match error.kind() {
        ErrorKind::BrokenPipe => End::Enough,
        _ => End::input(OutputError::new(Path::new("standard output"), error)),
    }
}
