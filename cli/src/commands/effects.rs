//! The command `lyapunov effects`.

use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use lyapunov_lab::effects::{Costs, CostsError};

use super::{End, heed_interrupts, standard_output};

/// Measure what each effect costs per step, on this machine.
///
/// Prints the nanoseconds that a step takes longer with an effect than without, alone and with all other effects, for one
/// rollout (f64) and for eight at once (f64x8). Environments and axes replace the wall, so their price is the
/// difference to it. docs/effects/prices.md says how to read the table.
///
/// Exit status: 0 done, 1 internal error, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Effects {
    /// Print JSON instead of tables.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Effects {
    pub(crate) fn run(&self) -> Result<(), End> {
        heed_interrupts(true);
        let bar = self.progress()?;
        let watch = || {
            bar.inc(1);
            match End::if_interrupted() {
                Ok(()) => ControlFlow::Continue(()),
                Err(_) => ControlFlow::Break(()),
            }
        };
        let prices = Costs::measured(&watch).map_err(|error| match error {
            CostsError::Stopped => End::Interrupted,
            error => End::internal(error),
        })?;
        bar.finish_and_clear();
        if self.quiet {
            return Ok(());
        }
        let text = match self.json {
            true => prices.document().map_err(End::internal)?,
            false => prices.to_string(),
        };
        io::stdout().lock().write_all(text.as_bytes()).map_err(standard_output)
    }

    /// Progress bar, hidden without a terminal.
    fn progress(&self) -> Result<ProgressBar, End> {
        if self.quiet || !io::stdout().is_terminal() {
            return Ok(ProgressBar::hidden());
        }
        let loops = Costs::loops().map_err(End::internal)? as u64;
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %, {eta} left");
        let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
        Ok(ProgressBar::new(loops).with_style(style))
    }
}
