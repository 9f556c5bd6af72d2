//! Files of a figure.

use lyapunov_figures::{ChartError, Figure};

/// Pixels of a PNG per unit of the drawing.
const SCALE: f64 = 2.0;

/// Files of `figure`, SVG and PNG: names, `name` with the ending, and bytes.
///
/// # Errors
/// A picture that is too large, or that the rasteriser rejects.
pub(crate) fn pictures(name: &str, figure: &Figure) -> Result<[(String, Vec<u8>); 2], ChartError> {
    let picture = figure.to_png(SCALE)?;
    Ok([(format!("{name}.svg"), figure.to_svg().into_bytes()), (format!("{name}.png"), picture)])
}
