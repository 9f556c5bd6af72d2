//! The folder that `lyapunov paper` fills.

use std::io;
use std::path::Path;

use super::figures::figures;
use super::report::Report;
use super::study::Study;
use super::{Case, PaperError};
use crate::{Csv, OutputError, Outputs, Row};

pub(super) fn write(study: &Study, folder: &Path, command: &str) -> Result<(), PaperError> {
    let figures = figures()?;
    let report = Report { study, figures: &figures, command };
    let mut files = vec![
        ("report.html".to_owned(), report.to_html().into_bytes()),
        ("claims.json".to_owned(), study.to_json()?.into_bytes()),
    ];
    for (name, figure, _) in &figures {
        files.push((format!("{name}.svg"), figure.to_svg().into_bytes()));
        files.push((format!("{name}.png"), figure.to_png(2.0)?));
    }
    for case in Case::ALL {
        let text = csv(&case.rows()?).map_err(|error| OutputError::new(folder, error))?;
        files.push((format!("{}.csv", case.name()), text));
    }
    std::fs::create_dir_all(folder).map_err(|error| OutputError::new(folder, error))?;
    let mut outputs = Outputs::of(folder);
    files.into_iter().try_for_each(|(name, bytes)| outputs.put(&name, bytes))?;
    Ok(outputs.keep()?)
}

fn csv(rows: &[Row]) -> io::Result<Vec<u8>> {
    let mut csv = Csv::new(Vec::new(), &[])?;
    rows.iter().try_for_each(|row| csv.write(row, &[]))?;
    csv.into_inner()
}
