//! The scenes of the paper's section IV and the figures drawn from them.
//!
//! What the paper leaves open (how operator and device join, where the operator's spring rests, the observer's
//! rate) is read as in docs/paper.md: one mass, at rest at the wall, everything at 100 Hz, held work, a damping
//! cap of half of m / T.

use std::io::{self, Write};
use std::path::Path;

use lyapunov::ParameterError;

use crate::chart::{Figure, Guide, Inset, Panel, Series};
use crate::scene::{Diagnostic, Scene};
use crate::{Csv, Output, OutputError, Rollout, Row};

/// A scene of the paper's section IV.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// 8 kN/m and 2 N·s/m without control: figure 6.
    Plain8k,
    /// The same with POPC.
    Popc8k,
    /// The same with LOLC: figure 7.
    Lolc8k,
    /// 50 kN/m and 20 N·s/m without control.
    Plain50k,
    /// The same with POPC: figures 8 and 9.
    Popc50k,
    /// The same with LOLC: figures 8 and 9.
    Lolc50k,
}

impl Case {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Plain8k, Self::Popc8k, Self::Lolc8k, Self::Plain50k, Self::Popc50k, Self::Lolc50k];

    /// The name of the scene file, without its ending.
    pub fn name(self) -> &'static str {
        self.file().0
    }

    /// The scene.
    ///
    /// # Errors
    /// None as long as the scene files that ship are right.
    pub fn scene(self) -> Result<Scene, Diagnostic> {
        let (name, text) = self.file();
        Scene::parse(text, name)
    }

    fn file(self) -> (&'static str, &'static str) {
        macro_rules! shipped {
            ($name:literal) => {
                ($name, include_str!(concat!("../../scenes/", $name, ".toml")))
            };
        }
        match self {
            Self::Plain8k => shipped!("paper-8k-none"),
            Self::Popc8k => shipped!("paper-8k-popc"),
            Self::Lolc8k => shipped!("paper-8k-lolc"),
            Self::Plain50k => shipped!("paper-50k-none"),
            Self::Popc50k => shipped!("paper-50k-popc"),
            Self::Lolc50k => shipped!("paper-50k-lolc"),
        }
    }

    /// The rows of the scene.
    ///
    /// # Errors
    /// None as long as the scene files that ship are right.
    pub fn rows(self) -> Result<Vec<Row>, PaperError> {
        Ok(Rollout::<f64>::of(&self.scene()?)?.collect())
    }
}

/// Why the paper's figures could not be made.
#[derive(Debug)]
pub enum PaperError {
    /// A shipped scene is not right.
    Scene(Diagnostic),
    /// A shipped scene has a parameter that no block takes.
    Parameter(ParameterError),
    /// A picture could not be drawn.
    Chart(crate::chart::ChartError),
    /// A file could not be written.
    Output(OutputError),
}

macro_rules! causes {
    ($($variant:ident($cause:ty)),+) => {$(
        impl From<$cause> for PaperError {
            fn from(cause: $cause) -> Self {
                Self::$variant(cause)
            }
        }
    )+

        impl std::fmt::Display for PaperError {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $(Self::$variant(cause) => cause.fmt(f),)+
                }
            }
        }
    };
}

causes!(
    Scene(Diagnostic),
    Parameter(ParameterError),
    Chart(crate::chart::ChartError),
    Output(OutputError)
);

impl std::error::Error for PaperError {}

/// The paper's figures 6 to 9 by name.
///
/// # Errors
/// None as long as the scene files that ship are right.
pub fn figures() -> Result<[(&'static str, Figure); 4], PaperError> {
    let plain8k = Case::Plain8k.rows()?;
    let lolc8k = Case::Lolc8k.rows()?;
    let (popc50k, lolc50k) = (Case::Popc50k.rows()?, Case::Lolc50k.rows()?);
    Ok([
        ("figure-6", figure_6(&plain8k)),
        ("figure-7", figure_7(&lolc8k)),
        ("figure-8", figure_8(&popc50k, &lolc50k)),
        ("figure-9", figure_9(&popc50k, &lolc50k)),
    ])
}

/// Writes the figures as SVG and PNG, and the rows of every case as CSV, into `folder`, which is made if it is
/// not there.
///
/// # Errors
/// A folder or file that cannot be written.
pub fn write(folder: &Path) -> Result<(), PaperError> {
    let put = |name: String, bytes: &[u8]| -> Result<(), PaperError> {
        let mut output = Output::create(&folder.join(name))?;
        output.write_all(bytes).map_err(|error| output.blame(error))?;
        Ok(output.keep()?)
    };
    std::fs::create_dir_all(folder).map_err(|error| OutputError::new(folder, error))?;
    for (name, figure) in figures()? {
        put(format!("{name}.svg"), figure.to_svg().as_bytes())?;
        put(format!("{name}.png"), &figure.to_png(2.0)?)?;
    }
    for case in Case::ALL {
        let text = csv(&case.rows()?).map_err(|error| OutputError::new(folder, error))?;
        put(format!("{}.csv", case.name()), &text)?;
    }
    Ok(())
}

fn csv(rows: &[Row]) -> io::Result<Vec<u8>> {
    let mut csv = Csv::new(Vec::new())?;
    rows.iter().try_for_each(|row| csv.write(row))?;
    Ok(csv.into_inner())
}

fn points(rows: &[Row], y: impl Fn(&Row) -> f64) -> Vec<(f64, f64)> {
    rows.iter().map(|row| (row.t, y(row))).collect()
}

const TIME: &str = "time, s";
const SURFACE: &str = "wall surface";

fn figure_6(plain: &[Row]) -> Figure {
    let shown = 2.0;
    let panel = Panel::new("8 kN/m, 2 N·s/m, without control", TIME, "position, mm")
        .with_series(Series::line("no control", 0, points(plain, |row| 1e3 * row.x)))
        .with_guide(Guide::horizontal(0.0, SURFACE))
        .with_x_range(0.0, shown)
        .with_y_range(-60.0, 60.0);
    Figure::new("Figure 6: without control the position is unstable").with_panel(panel)
}

fn figure_7(lolc: &[Row]) -> Figure {
    let line = |y: fn(&Row) -> f64| Series::line("LOLC", 0, points(lolc, y));
    let steps = |y: fn(&Row) -> f64| Series::steps("LOLC", 0, points(lolc, y));
    Figure::new("Figure 7: 8 kN/m and 2 N·s/m with the Lyapunov observer/controller")
        .with_columns(2)
        .with_width(960.0)
        .with_panel(
            Panel::new("(a) position", TIME, "position, mm")
                .with_series(line(|row| 1e3 * row.x))
                .with_guide(Guide::horizontal(0.0, SURFACE)),
        )
        .with_panel(
            Panel::new("(b) force of the environment", TIME, "force, N")
                .with_series(steps(|row| row.f_env)),
        )
        .with_panel(
            Panel::new("(c) force of the controller", TIME, "force, N")
                .with_series(steps(|row| row.f_ctl)),
        )
        .with_panel(
            Panel::new("(d) observed energy", TIME, "energy, mJ")
                .with_series(line(|row| 1e3 * row.observer))
                .with_guide(Guide::horizontal(0.0, "")),
        )
}

fn figure_8(popc: &[Row], lolc: &[Row]) -> Figure {
    let panel = Panel::new("50 kN/m, 20 N·s/m", TIME, "position, mm")
        .with_series(Series::line("POPC", 1, points(popc, |row| 1e3 * row.x)))
        .with_series(Series::line("LOLC", 0, points(lolc, |row| 1e3 * row.x)))
        .with_guide(Guide::horizontal(0.0, SURFACE))
        .with_x_range(0.0, 5.0)
        .with_inset(Inset::over(2.5, 4.0));
    Figure::new("Figure 8: position with POPC and with LOLC").with_width(840.0).with_panel(panel)
}

fn figure_9(popc: &[Row], lolc: &[Row]) -> Figure {
    let panel = Panel::new("50 kN/m, 20 N·s/m", TIME, "observed energy, mJ")
        .with_series(Series::line("POPC", 1, points(popc, |row| 1e3 * row.observer)))
        .with_series(Series::line("LOLC", 0, points(lolc, |row| 1e3 * row.observer)))
        .with_guide(Guide::horizontal(0.0, ""))
        .with_x_range(0.0, 5.0)
        .with_inset(Inset::over(2.5, 4.0));
    Figure::new("Figure 9: observed energy with POPC and with LOLC")
        .with_width(840.0)
        .with_panel(panel)
}
