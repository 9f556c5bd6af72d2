//! The command `lyapunov`.

mod commands;
mod output;
mod pictures;

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    commands::Command::parse().run()
}
