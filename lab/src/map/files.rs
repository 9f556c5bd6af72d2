//! The files of a map beside its table: heat maps and a report page.

use rayon::prelude::*;

use super::bounds::Bounds;
use super::picture::{self, Drawn};
use super::report;
use super::survey::Survey;
use crate::chart::ChartError;

/// Names and bytes of the heat maps and the report page; `command` made the map.
///
/// # Errors
/// A picture that cannot be drawn.
pub fn files(
    survey: &Survey,
    bounds: Option<&Bounds>,
    command: &str,
) -> Result<Vec<(String, Vec<u8>)>, ChartError> {
    let figures = picture::figures(survey, bounds);
    let drawn: Result<Vec<_>, ChartError> = figures
        .par_iter()
        .map(|Drawn { name, figure, .. }| {
            let svg = (format!("{name}.svg"), figure.to_svg().into_bytes());
            Ok([svg, (format!("{name}.png"), figure.to_png(2.0)?)])
        })
        .collect();
    let mut files: Vec<_> = drawn?.into_iter().flatten().collect();
    let page = report::page(survey, bounds, &figures, command);
    files.push(("report.html".to_owned(), page.into_bytes()));
    Ok(files)
}
