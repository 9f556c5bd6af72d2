//! The study that `lyapunov paper` computes.

use serde::Serialize;

use super::PaperError;
use super::claims::{
    Balance, Claim, Control, Grid, MovedClaim, Reading, Setting, claims, sensitivity, starts,
};
use super::figures::NamedFigure;
use super::report::Report;

/// Number of starts that the verdicts rest on.
const STARTS: usize = 101;
/// Walls over which stable areas are compared.
const GRID: Grid = Grid { stiffnesses: 12, dampings: 9 };

/// Stage of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The claims over the ensemble.
    Claims,
    /// Their sensitivity to what the paper leaves open.
    Readings,
    /// The energy balances.
    Balances,
    /// Figures and files.
    Files,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 4] = [Self::Claims, Self::Readings, Self::Balances, Self::Files];

    /// A few words for a progress display.
    pub fn words(self) -> &'static str {
        match self {
            Self::Claims => "claims over 101 starts",
            Self::Readings => "caps, rates and the printed recursion",
            Self::Balances => "energy balances",
            Self::Files => "figures and report",
        }
    }
}

/// The claims of the paper's section IV and the results that they rest on.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The claims, each with its verdict.
    pub claims: Vec<Claim>,
    /// The ensembles under other readings of what the paper leaves open.
    pub readings: Vec<Reading>,
    /// The verdicts on the two walls under the same readings.
    pub moved: Vec<MovedClaim>,
    /// The energy balances of the paper's runs, by name.
    pub balances: Vec<(&'static str, Balance)>,
}

/// The content of `claims.json`.
#[derive(Serialize)]
struct Rows<'a> {
    rows: &'a [Claim],
}

impl Study {
    /// Computes everything; calls `tell` with each stage before it begins, which may stop the study.
    ///
    /// # Errors
    /// The error of `tell`, or a number that a part rejects.
    pub fn run<E: From<PaperError>>(
        mut tell: impl FnMut(Stage) -> Result<(), E>,
    ) -> Result<Self, E> {
        let starts = starts(STARTS);
        let refuse = |error| E::from(PaperError::from(error));
        tell(Stage::Claims)?;
        let claims = claims(&starts, GRID).map_err(refuse)?;
        tell(Stage::Readings)?;
        let (readings, moved) = sensitivity(&starts).map_err(refuse)?;
        tell(Stage::Balances)?;
        let mut balances = Vec::new();
        for (name, stiffness, damping, control) in [
            ("8 kN/m, POPC", 8e3, 2.0, Control::Popc),
            ("8 kN/m, LOLC", 8e3, 2.0, Control::Lolc),
            ("50 kN/m, POPC", 50e3, 20.0, Control::Popc),
            ("50 kN/m, LOLC", 50e3, 20.0, Control::Lolc),
        ] {
            let setting = Setting::read(stiffness, damping, control);
            balances.push((name, Balance::of(&setting).map_err(refuse)?));
        }
        Ok(Self { claims, readings, moved, balances })
    }

    /// The text of `claims.json`.
    ///
    /// # Errors
    /// None known: every number is finite or absent.
    pub fn to_json(&self) -> Result<String, PaperError> {
        let text = serde_json::to_string_pretty(&Rows { rows: &self.claims });
        Ok(text.map_err(PaperError::Json)? + "\n")
    }

    /// The report with these `figures`, in HTML; `command` is the command that it names as its maker.
    pub fn to_html(&self, figures: &[NamedFigure], command: &str) -> String {
        Report { study: self, figures, command }.to_html()
    }
}
