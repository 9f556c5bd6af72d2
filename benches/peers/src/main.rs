//! Comparison of exact propagation with integrators written by hand, crates and Python packages: accuracy and time on
//! the paper's 8 kN/m scene. `docs/peers.md` discusses the results.
//!
//! All rows take turns in one run, so that a slower machine slows all of them.

mod contest;
mod crates;
mod hand;
mod marks;
mod ours;
mod reference;
mod report;
mod row;
mod scene;
mod scripts;
#[cfg(test)]
mod tests;

use std::error::Error;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use lyapunov_lab::OutputError;

use contest::Contest;
use report::Report;
use row::{Origin, Row, Setting};
use scripts::Offers;

/// Compare exact propagation with other integrators, by largest error and time.
///
/// The table has of each peer's method the fastest setting below 1e-3, 1e-6, 1e-9 and 1e-11 m; --json has all.
/// The Python packages are those of benches/peers/python/install.sh; without them their rows are SKIPPED.
#[derive(Parser)]
struct Arguments {
    /// Write every row as JSON to FILE.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Times that each row is measured.
    #[arg(long, value_name = "COUNT", default_value_t = 21, value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    if let Some(path) = &arguments.json {
        // An unwritable place is reported before minutes are spent.
        let opened = File::options().append(true).create(true).open(path);
        opened.map_err(|error| OutputError::new(path, error))?;
    }
    let rounds = usize::from(arguments.rounds);
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} %, {eta} left")?;
    let bar = ProgressBar::new(0).with_style(style);

    let Offers { rows: python, versions, skipped } = Offers::gathered();
    let mut rows = own_rows();
    rows.extend(crates::rows());
    rows.extend(python);
    let report = Report::new(Contest::held(rows, rounds, &bar)?, rounds, versions, skipped);

    io::stdout().lock().write_all(report.to_string().as_bytes())?;
    if let Some(path) = &arguments.json {
        let written = fs::write(path, report.document()?);
        written.map_err(|error| OutputError::new(path, error))?;
    }
    Ok(())
}

/// Rows of this library and of the methods by hand. The exact row is the first.
fn own_rows() -> Vec<Row> {
    const STEPS: &[u32] = &[1, 2, 5, 10, 20, 50, 100];
    let valid = "the scene is valid";
    let mut rows = vec![Row::compiled(Origin::Ours, "exact", Setting::None, move |at| {
        ours::exact(at).expect(valid);
    })];
    rows.push(Row::side_by_side(Origin::Ours, "exact, a lane of 8", ours::LANES, move |at| {
        ours::exact_on_lanes(at).expect(valid);
    }));
    rows.extend(Row::stepped(Origin::Ours, "RK4 generic", STEPS, move |at, steps| {
        ours::runge_kutta_4(at, steps).expect(valid);
    }));
    rows.extend(Row::stepped(Origin::Hand, "RK4 by hand", STEPS, hand::runge_kutta_4));
    rows.push(Row::compiled(Origin::Hand, "exact by hand", Setting::None, hand::exact));
    let pair = "Dormand-Prince by hand";
    rows.extend(Row::adaptive(Origin::Hand, pair, hand::dormand_prince));
    rows
}
