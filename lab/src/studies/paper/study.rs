//! Everything that `lyapunov paper` computes.

use serde::Serialize;

use super::PaperError;
use super::claims::{
    Balance, Claim, Control, Grid, MovedClaim, Reading, Setting, claims, sensitivity, starts,
};
use super::figures::NamedFigure;
use super::report::Report;

/// How many starts the verdicts rest on.
const STARTS: usize = 101;
/// The walls over which stable areas are compared.
const GRID: Grid = Grid { stiffnesses: 12, dampings: 9 };

/// What is being computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The claims over the ensemble.
    Claims,
    /// How they move with what the paper leaves open.
    Readings,
    /// Where the energy went.
    Balances,
    /// Figures and files.
    Files,
}

impl Stage {
    /// All of them, in order.
    pub const ALL: [Self; 4] = [Self::Claims, Self::Readings, Self::Balances, Self::Files];

    /// A few words for whoever waits.
    pub fn words(self) -> &'static str {
        match self {
            Self::Claims => "claims over 101 starts",
            Self::Readings => "caps, rates and the printed recursion",
            Self::Balances => "energy balances",
            Self::Files => "figures and report",
        }
    }
}

/// The claims of the paper's section IV and what they rest on.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The claims, each with its verdict.
    pub claims: Vec<Claim>,
    /// How the ensembles move with what the paper leaves open.
    pub readings: Vec<Reading>,
    /// How the verdicts on the two walls move with it.
    pub moved: Vec<MovedClaim>,
    /// Where the energy of the paper's runs went, by name.
    pub balances: Vec<(&'static str, Balance)>,
}

/// The content of `claims.json`.
#[derive(Serialize)]
struct Rows<'a> {
    rows: &'a [Claim],
}

impl Study {
    /// Computes everything; `tell` hears of each stage before it begins and may end the study.
    ///
    /// # Errors
    /// What `tell` says, or a number that no part takes.
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

    /// `claims.json`.
    ///
    /// # Errors
    /// None that is known: every number is finite or absent.
    pub fn to_json(&self) -> Result<String, PaperError> {
        let text = serde_json::to_string_pretty(&Rows { rows: &self.claims });
        Ok(text.map_err(PaperError::Json)? + "\n")
    }

    /// The report with these `figures`, in HTML; `command` stands in it as what made it.
    pub fn to_html(&self, figures: &[NamedFigure], command: &str) -> String {
        Report { study: self, figures, command }.to_html()
    }
}
