//! The claims, one by one.

use lyapunov::ParameterError;
use serde::Serialize;

use super::area::{Grid, stable_share};
use super::ensemble::{Control, Setting, run};
use super::measures::{Measures, median};

/// Verdict of an ensemble on a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Verdict {
    /// It holds for at least 95 % of the starts.
    #[serde(rename = "reproduced")]
    Reproduced,
    /// It holds for at most 5 % of the starts.
    #[serde(rename = "not reproduced")]
    NotReproduced,
    /// It holds for some starts, or most starts have nothing to judge it by.
    #[serde(rename = "undecided")]
    Undecided,
}

impl Verdict {
    fn from_counts(held: usize, of: usize) -> Self {
        if 100 * held >= 95 * of {
            Self::Reproduced
        } else if 100 * held <= 5 * of {
            Self::NotReproduced
        } else {
            Self::Undecided
        }
    }
}

/// A claim of the paper's section IV.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Claim {
    /// A stable identifier.
    pub id: &'static str,
    /// The paper's statement.
    pub paper: &'static str,
    /// The median over the starts.
    pub measured: Option<f64>,
    /// The unit of `measured`.
    pub unit: &'static str,
    /// The exact quantity that was looked at.
    pub reading: &'static str,
    /// The number of starts for which the claim holds.
    pub held: usize,
    /// The number of all starts.
    pub of: usize,
    /// The verdict.
    pub verdict: Verdict,
}

impl Claim {
    /// The median over the starts with its unit, to four digits; a dash where there is none.
    pub fn measured(&self) -> String {
        let unit = if self.unit == "1" { String::new() } else { format!(" {}", self.unit) };
        self.measured.map_or("–".to_owned(), |value| number(value) + &unit)
    }
}

/// Four significant digits.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&size) {
        let decimals = (3 - size.log10().floor() as i32).clamp(0, 6) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.3e}")
    }
}

/// Factor within which a force is near one in the paper; an energy is near within its square.
const NEAR: f64 = 1.15;

fn is_near(measured: f64, paper: f64, factor: f64) -> bool {
    (paper / factor..=paper * factor).contains(&measured)
}

/// Evidence on a claim: for each start a number and whether the claim holds; none where there is nothing to judge by.
type Evidence = Vec<(Option<f64>, Option<bool>)>;

/// Evidence of one start, which cannot be judged without its number.
fn judged((number, holds): (Option<f64>, bool)) -> (Option<f64>, Option<bool>) {
    (number, number.map(|_| holds))
}

struct Text {
    id: &'static str,
    paper: &'static str,
    unit: &'static str,
    reading: &'static str,
}

impl Text {
    fn judge(self, evidence: Evidence) -> Claim {
        let Self { id, paper, unit, reading } = self;
        let of = evidence.len();
        let held = evidence.iter().filter(|(_, holds)| *holds == Some(true)).count();
        let judged = evidence.iter().filter(|(_, holds)| holds.is_some()).count();
        let numbers: Vec<f64> = evidence.iter().filter_map(|(number, _)| *number).collect();
        let measured = (2 * numbers.len() > of).then(|| median(numbers.into_iter())).flatten();
        let verdict = match 2 * judged > of {
            true => Verdict::from_counts(held, of),
            false => Verdict::Undecided,
        };
        Claim { id, paper, measured, unit, reading, held, of, verdict }
    }
}

/// Measures of the paper's two walls under one reading.
pub(super) struct Loops {
    pub(super) plain8k: Vec<Measures>,
    pub(super) lolc8k: Vec<Measures>,
    pub(super) popc50k: Vec<Measures>,
    pub(super) lolc50k: Vec<Measures>,
}

impl Loops {
    /// Loops under the reading that `reading` makes of this repository's.
    pub(super) fn of(
        starts: &[f64],
        reading: impl Fn(Setting) -> Setting,
    ) -> Result<Self, ParameterError> {
        let soft = |control| measured(reading(Setting::read(8e3, 2.0, control)), starts);
        let stiff = |control| measured(reading(Setting::read(50e3, 20.0, control)), starts);
        Ok(Self {
            plain8k: soft(Control::None)?,
            lolc8k: soft(Control::Lolc)?,
            popc50k: stiff(Control::Popc)?,
            lolc50k: stiff(Control::Lolc)?,
        })
    }

    /// The claims about the two walls.
    pub(super) fn claims(&self) -> Vec<Claim> {
        let mut claims = soft_wall(self);
        claims.extend(stiff_wall(self));
        claims
    }

    /// Both stabilizers at 50 kN/m, start by start, POPC first.
    fn both(&self, judge: impl Fn(&Measures, &Measures) -> (Option<f64>, bool)) -> Evidence {
        let pairs = self.popc50k.iter().zip(&self.lolc50k);
        pairs.map(|(popc, lolc)| judged(judge(popc, lolc))).collect()
    }
}

/// Measures of each start.
pub(super) fn measured(setting: Setting, starts: &[f64]) -> Result<Vec<Measures>, ParameterError> {
    Ok(run(&setting, starts)?.iter().map(Measures::of).collect())
}

/// Ratio `more / less`, and whether it is above 1, which is false where a number is missing.
fn ratio(more: Option<f64>, less: Option<f64>) -> (Option<f64>, bool) {
    match (more, less) {
        (Some(more), Some(less)) if less != 0.0 => (Some(more / less), more > less),
        (Some(more), Some(_)) => (None, more > 0.0),
        _ => (None, false),
    }
}

/// The claims, each judged over `starts`, the stable area over `grid`.
///
/// # Errors
/// A number that a part rejects.
pub fn claims(starts: &[f64], grid: Grid) -> Result<Vec<Claim>, ParameterError> {
    let loops = Loops::of(starts, |setting| setting)?;
    let popc_area = stable_share(Control::Popc, grid, starts)?;
    let lolc_area = stable_share(Control::Lolc, grid, starts)?;
    let as_printed = Setting { printed: true, ..Setting::read(8e3, 2.0, Control::Lolc) };
    let mut claims = loops.claims();
    claims.push(less_conservative(&loops, &popc_area, &lolc_area));
    claims.push(printed(&measured(as_printed, starts)?));
    Ok(claims)
}

fn each(runs: &[Measures], judge: impl Fn(&Measures) -> (Option<f64>, bool)) -> Evidence {
    runs.iter().map(|run| judged(judge(run))).collect()
}

/// Evidence that runs settle: one that does not has no settling time and fails the claim.
fn settles(evidence: Evidence) -> Evidence {
    evidence.into_iter().map(|(time, _)| (time, Some(time.is_some()))).collect()
}

fn soft_wall(runs: &Loops) -> Vec<Claim> {
    vec![
        Text {
            id: "unstable-without-control",
            paper: "8 kN/m: unstable without control",
            unit: "m",
            reading: "largest |x| after the first contact; holds where |x| passes ten times the start",
        }
        .judge(each(&runs.plain8k, |run| (Some(run.swing), !run.bounded))),
        Text {
            id: "settles-8k",
            paper: "8 kN/m: the position settles with LOLC",
            unit: "s",
            reading: "from when on |x| stays within 5 % of the start; holds where it does within 30 s",
        }
        .judge(settles(each(&runs.lolc8k, |run| (run.settled, true)))),
        Text {
            id: "force-peak",
            paper: "8 kN/m: first peak of the wall's force near 3 N",
            unit: "N",
            reading: "largest force of the first contact, scaled to a start of 4 mm; holds within a factor of 1.15 of 3 N",
        }
        .judge(each(&runs.lolc8k, |run| {
            let peak = run.force_peak / run.scale;
            (Some(peak), is_near(peak, 3.0, NEAR))
        })),
        Text {
            id: "force-opposes",
            paper: "8 kN/m: the controller's force opposes the wall's",
            unit: "1",
            reading: "largest controller force within 0.1 s after the first contact over the wall's peak; \
                      holds below 0. (The paper has them equally large: that would be -1.)",
        }
        .judge(each(&runs.lolc8k, |run| {
            let share = run.reply / run.force_peak;
            (Some(share), share < 0.0)
        })),
        Text {
            id: "energy-peak",
            paper: "8 kN/m: energy peaks near 2e-4 J, then back to zero",
            unit: "J",
            reading: "largest observed energy, scaled to a start of 4 mm; holds within a factor of 1.15^2 of 2e-4 J, \
                      and within 5 % of the peak about zero at 30 s",
        }
        .judge(each(&runs.lolc8k, |run| {
            let peak = run.energy_peak / (run.scale * run.scale);
            let near = is_near(peak, 2e-4, NEAR * NEAR);
            (Some(peak), near && run.energy_end.abs() <= 0.05 * run.energy_peak)
        })),
    ]
}

fn stiff_wall(runs: &Loops) -> Vec<Claim> {
    vec![
        Text {
            id: "settles-50k",
            paper: "50 kN/m: the position settles with both",
            unit: "s",
            reading: "settling time of the later of the two; holds where both settle within 30 s",
        }
        .judge(settles(runs.both(|popc, lolc| {
            let later = popc.settled.zip(lolc.settled).map(|(popc, lolc)| popc.max(lolc));
            (later, true)
        }))),
        Text {
            id: "popc-sooner",
            paper: "50 kN/m: POPC settles sooner",
            unit: "1",
            reading: "settling time of LOLC over that of POPC; holds above 1",
        }
        .judge(runs.both(|popc, lolc| ratio(lolc.settled, popc.settled))),
        Text {
            id: "popc-smaller-swing",
            paper: "50 kN/m: POPC swings less",
            unit: "1",
            reading: "largest |x| after the first contact, LOLC over POPC; holds above 1",
        }
        .judge(runs.both(|popc, lolc| ratio(Some(lolc.swing), Some(popc.swing)))),
        Text {
            id: "popc-jitters",
            paper: "50 kN/m: POPC jitters once settled, LOLC less",
            unit: "1",
            reading: "RMS velocity over the second after settling, POPC over LOLC; holds above 1",
        }
        .judge(runs.both(|popc, lolc| ratio(popc.jitter, lolc.jitter))),
        Text {
            id: "popc-impulsive",
            paper: "50 kN/m: POPC's energy is impulsive, LOLC's smooth",
            unit: "1",
            reading: "largest |dL| over the median |dL| of active ticks, dL as booked, POPC over LOLC; holds above 1",
        }
        .judge(runs.both(|popc, lolc| ratio(popc.impulsiveness, lolc.impulsiveness))),
        Text {
            id: "less-per-sample",
            paper: "50 kN/m: LOLC dissipates less per sample",
            unit: "1",
            reading: "energy taken by the controller for each active tick, POPC over LOLC; holds above 1",
        }
        .judge(runs.both(|popc, lolc| ratio(popc.taken_per_sample, lolc.taken_per_sample))),
    ]
}

fn less_conservative(runs: &Loops, popc_area: &[f64], lolc_area: &[f64]) -> Claim {
    let areas = popc_area.iter().zip(lolc_area);
    let evidence = runs.both(|popc, lolc| {
        let (share, less) = ratio(Some(popc.taken), Some(lolc.taken));
        (share, less && popc.bounded && lolc.bounded)
    });
    let evidence = evidence.into_iter().zip(areas);
    Text {
        id: "less-conservative",
        paper: "LOLC is less conservative than POPC",
        unit: "1",
        reading: "energy taken by the controller at 50 kN/m, POPC over LOLC; holds where it is above 1, both stay \
                  bounded and LOLC settles on more walls of the grid than POPC",
    }
    .judge(
        evidence
            .map(|((share, less), (popc, lolc))| (share, less.map(|less| less && lolc > popc)))
            .collect(),
    )
}

fn printed(runs: &[Measures]) -> Claim {
    Text {
        id: "printed-recursion",
        paper: "steps 4 to 6 as printed stabilize at 100 Hz",
        unit: "1",
        reading: "share of ticks on which the printed LOLC acts at 8 kN/m; holds where the loop stays bounded \
                  and settles",
    }
    .judge(each(runs, |run| (Some(run.active), run.bounded && run.settled.is_some())))
}
