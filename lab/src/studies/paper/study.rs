//! The study that `lyapunov paper` computes.

use std::fmt;

use serde::Serialize;

use super::PaperError;
use super::claims::{
    Balance, Claim, Control, Judged, Member, Outcomes, Runs, SOFT, STIFF, Steps, Unstated, Verdict,
    claims,
};
use super::figures::PaperFigure;
use super::report::Report;
use crate::show::json;
use crate::show::table::{Cell, Heading, Table};

/// Ensemble that the verdicts rest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Draws {
    /// The number of members.
    pub count: u64,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Default for Draws {
    fn default() -> Self {
        Self { count: 1000, seed: 1 }
    }
}

/// The claims of the paper's section IV and the results that they rest on.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The ensemble.
    pub draws: Draws,
    /// The claims, each with its verdicts.
    pub claims: Vec<Claim>,
    /// Outcomes of all runs, by loop and rate.
    pub outcomes: Vec<Outcomes>,
    /// The energy balances of the paper's runs, by name.
    pub balances: Vec<(&'static str, Balance)>,
}

/// The content of `claims.json`.
#[derive(Serialize)]
struct Rows<'a> {
    draws: Draws,
    rows: &'a [Claim],
}

impl Study {
    /// The number of calls of `tell` in [`Study::run`].
    pub const STAGES: usize = 2 * Runs::LOOPS;

    /// Computes everything; calls `tell` before each part of the work.
    ///
    /// # Errors
    /// A number that a part rejects.
    pub fn run(draws: Draws, mut tell: impl FnMut()) -> Result<Self, PaperError> {
        let members = Member::draw(draws.seed, draws.count)?;
        let paper = [Member::of_the_paper()?];
        let (mut runs, mut single) = (Vec::new(), Vec::new());
        for steps in [Steps::Printed, Steps::Ours] {
            runs.push(Runs::of(steps, &members, &mut tell)?);
            single.extend(Runs::of(steps, &paper, || ())?);
        }
        let (runs, single) = ([&runs[0][..], &runs[1]], [single[0], single[1]]);
        let balance = |control, wall| Balance::of(control, &paper[0], wall);
        let balances = || -> Result<Vec<_>, PaperError> {
            Ok(vec![
                ("8 kN/m, POPC", balance(Control::Popc, SOFT)?),
                ("8 kN/m, LOLC", balance(Control::Lolc, SOFT)?),
                ("50 kN/m, POPC", balance(Control::Popc, STIFF)?),
                ("50 kN/m, LOLC", balance(Control::Lolc, STIFF)?),
            ])
        };
        Ok(Self {
            draws,
            claims: claims(&members, runs, single),
            outcomes: Outcomes::all(&members, runs),
            balances: balances()?,
        })
    }

    /// The text of `claims.json`.
    pub fn to_json(&self) -> String {
        json::text(&Rows { draws: self.draws, rows: &self.claims })
    }

    /// The report with these `figures`, in HTML; `command` is the command that it names as its maker.
    pub fn to_html(&self, figures: &[PaperFigure], command: &str) -> String {
        Report { study: self, figures, command }.to_html()
    }

    fn verdicts(&self) -> Table {
        let headings = [
            Heading::word("the paper says"),
            Heading::word("as printed"),
            Heading::word("ours"),
            Heading::word("ours holds in %\n(95 % interval)"),
        ];
        Table::new(headings).with_rows(self.claims.iter().map(|claim| {
            let word = |judged: &Judged| Cell::from(judged.verdict.word());
            [claim.paper.into(), word(&claim.printed), word(&claim.ours), claim.ours.share().into()]
        }))
    }

    fn influences(&self) -> Table {
        let headings = [
            Heading::word("depends: the paper says"),
            Heading::word("on"),
            Heading::word("holds in %, by its value"),
        ];
        let depending = self.claims.iter().filter(|claim| is_open(claim));
        let rows = depending.flat_map(|claim| {
            claim.ours.influences.iter().enumerate().map(|(index, influence)| {
                let paper = if index == 0 { claim.paper } else { "" };
                [paper.into(), influence.constant.into(), influence.shares().into()]
            })
        });
        Table::new(headings).with_rows(rows)
    }
}

/// Whether the verdict on our controller depends on something.
fn is_open(claim: &Claim) -> bool {
    matches!(claim.ours.verdict, Verdict::DependsOn(_))
}

impl fmt::Display for Study {
    /// The tables in the terminal.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Draws { count, seed } = self.draws;
        writeln!(
            f,
            "The paper's section IV over {count} draws of what it does not state (seed {seed})\n"
        )?;
        write!(f, "{}", self.verdicts())?;
        let depending = self.claims.iter().filter(|claim| is_open(claim));
        let mut influences = depending.flat_map(|claim| &claim.ours.influences).peekable();
        if influences.peek().is_none() {
            return Ok(());
        }
        writeln!(f, "\n{}", self.influences())?;
        let named = |unstated: &Unstated| {
            influences.clone().any(|influence| influence.constant == unstated.name())
        };
        let mut named = Unstated::ALL.into_iter().filter(named);
        named.try_for_each(|it| writeln!(f, "{}: {}", it.name(), it.order()))
    }
}
