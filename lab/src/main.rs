//! The command `lyapunov`.

mod commands;

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    commands::Command::parse().run()
}
