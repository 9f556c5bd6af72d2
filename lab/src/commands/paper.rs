//! `lyapunov paper`.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::paper::{self, Case, PaperError};
use lyapunov_lab::{Rollout, Summary};

use super::End;

/// Draw the paper's figures 6 to 9 as SVG and PNG, with the rows behind them as CSV.
#[derive(Args, Debug)]
pub(crate) struct Paper {
    /// The folder for figures and rows; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "paper")]
    out: PathBuf,
}

impl Paper {
    /// Takes a moment and leaves each file whole, so an interrupt may end it anywhere.
    pub(crate) fn run(&self) -> Result<(), End> {
        paper::write(&self.out).map_err(|error| match error {
            PaperError::Output(error) => End::input(error),
            error => End::internal(error),
        })?;
        let mut out = io::stdout().lock();
        let mut tell = |text: String| writeln!(out, "{text}").map_err(|_| End::Enough);
        for case in Case::ALL {
            let scene = case.scene().map_err(End::internal)?;
            let rows = Rollout::<f64>::of(&scene).map_err(End::internal)?;
            tell(format!("{}\n{}\n", case.name(), Summary::of(&scene, rows)))?;
        }
        tell(format!("figures 6 to 9 and the rows behind them are in {}", self.out.display()))
    }
}
