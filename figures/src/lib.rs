//! Figures for print and screen: data in, SVG out, and PNG with the feature `png`.
//!
//! A [`Figure`] holds [`Panel`]s, a panel holds [`Series`], [`Guide`]s and at most one magnified
//! [`Inset`]. The typeface is included, so that a figure looks the same on every machine and
//! needs neither fonts nor programs there. Curves of any length give small files: only the points
//! that the page can show are written.
//!
//! Feature `png` (off by default): `Figure::to_png` and what it needs, a rasteriser.
//!
//! ```
//! use lyapunov_figures::{Figure, Guide, Inset, Panel, Series};
//!
//! let swing: Vec<(f64, f64)> = (0..=2000)
//!     .map(|tick| f64::from(tick) / 1000.0)
//!     .map(|time| (time, 4.0 * (-2.0 * time).exp() * (40.0 * time).sin()))
//!     .collect();
//! let position = Panel::new("(a) position", "time, s", "position, mm")
//!     .with_series(Series::line("measured", 0, swing))
//!     .with_guide(Guide::horizontal(0.0, "rest"))
//!     .with_inset(Inset::over(0.4, 0.6));
//! let figure = Figure::new("A swing that dies away").with_panel(position);
//!
//! let svg = figure.to_svg();
//! # assert!(svg.starts_with("<svg"));
//! ```

mod axes;
mod curve;
mod data;
mod drawing;
mod figure;
mod geometry;
mod guide;
mod heat;
mod inset;
mod legend;
mod magnifier;
mod markup;
mod page;
mod palette;
mod panel;
mod picture;
mod png;
#[cfg(feature = "png")]
mod raster;
mod reference;
mod series;
mod span;
#[cfg(all(test, feature = "png"))]
mod tests;
mod text;
mod thinning;
mod ticks;

pub use figure::Figure;
pub use guide::{Direction, Guide};
pub use heat::{Colouring, HeatMap};
pub use inset::{Inset, Placement};
pub use palette::PALETTE;
pub use panel::{Numbering, Panel};
#[cfg(feature = "png")]
pub use raster::{ChartError, MOST_PIXELS};
pub use series::{Series, Trace};
