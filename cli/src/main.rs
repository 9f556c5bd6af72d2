//! The command `lyapunov`.

use std::process::ExitCode;

use lyapunov_cli::Bench;

fn main() -> ExitCode {
    Bench::new().main()
}
