//! Outcomes of the runs: how many settle and how many grow, by the observer's rate.

use super::measures::Measures;
use super::member::{Member, RATES};
use super::runs::Runs;
use crate::measure::quantile::median;

/// Outcomes of one loop over the ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcomes {
    /// The wall, in words.
    pub wall: &'static str,
    /// The stabilizer, in words.
    pub stabilizer: &'static str,
    /// The runs at each rate of the observer.
    pub rates: [Share; RATES.len()],
}

/// Runs at one rate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// The number of runs that settle.
    pub settle: usize,
    /// The number of runs that grow. The rest is still swinging after 30 s.
    pub grow: usize,
    /// The number of all runs.
    pub of: usize,
    /// Median settling time of those that settle, s.
    pub settling_time: Option<f64>,
}

impl Outcomes {
    /// The outcomes of every loop, with the printed steps and with ours.
    pub(in super::super) fn all(members: &[Member], [printed, ours]: [&[Runs]; 2]) -> Vec<Self> {
        type Loop<'a> = (&'static str, &'static str, &'a [Runs], fn(&Runs) -> &Measures);
        let (soft, stiff) = ("8 kN/m", "50 kN/m");
        let loops: [Loop<'_>; 10] = [
            (soft, "none", ours, |runs| &runs.soft_none),
            (soft, "POPC, ours", ours, |runs| &runs.soft_popc),
            (soft, "LOLC, ours", ours, |runs| &runs.soft_lolc),
            (soft, "POPC, printed", printed, |runs| &runs.soft_popc),
            (soft, "LOLC, printed", printed, |runs| &runs.soft_lolc),
            (stiff, "none", ours, |runs| &runs.stiff_none),
            (stiff, "POPC, ours", ours, |runs| &runs.stiff_popc),
            (stiff, "LOLC, ours", ours, |runs| &runs.stiff_lolc),
            (stiff, "POPC, printed", printed, |runs| &runs.stiff_popc),
            (stiff, "LOLC, printed", printed, |runs| &runs.stiff_lolc),
        ];
        let all = loops.map(|(wall, stabilizer, runs, of)| {
            let at = |rate: f64| {
                let alike = members.iter().zip(runs).filter(|(member, _)| member.rate() == rate);
                Share::of(alike.map(|(_, runs)| of(runs)))
            };
            Self { wall, stabilizer, rates: RATES.map(at) }
        });
        all.to_vec()
    }
}

impl Share {
    fn of<'a>(runs: impl Iterator<Item = &'a Measures> + Clone) -> Self {
        Self {
            settle: runs.clone().filter(|run| run.settled.is_some()).count(),
            grow: runs.clone().filter(|run| run.grows).count(),
            of: runs.clone().count(),
            settling_time: median(runs.filter_map(|run| run.settled)),
        }
    }
}
