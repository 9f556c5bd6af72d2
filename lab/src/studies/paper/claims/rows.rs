//! The claims, one by one.

use super::claim::{Claim, Evidence, Judged};
use super::measures::Measures;
use super::member::Member;
use super::runs::{Runs, WALLS};

/// Factor within which two lengths, times or forces are near each other, and beyond which one is more than the other. Two
/// energies are near within its square.
const NEAR: f64 = 1.15;
/// Share of the energy's peak within which the energy is zero.
const ZERO: f64 = 0.05;
/// Fewest turns of a motion that jitters.
const JITTER: usize = 2;

/// A claim without its judgement.
struct Text {
    id: &'static str,
    paper: &'static str,
    unit: &'static str,
    reading: &'static str,
    judge: fn(&Runs) -> Evidence,
}

/// The claims, each judged over the runs of `members` with the printed steps and with ours, and the two single runs at
/// the paper's numbers beside them.
pub fn claims(members: &[Member], [printed, ours]: [&[Runs]; 2], single: [Runs; 2]) -> Vec<Claim> {
    let judged = |text: &Text, runs: &[Runs], single: &Runs| {
        let evidence: Vec<Evidence> = runs.iter().map(text.judge).collect();
        Judged::of(&evidence, members, (text.judge)(single))
    };
    let texts = SOFT.iter().chain(&STIFF);
    let claim = |text: &Text| Claim {
        id: text.id,
        paper: text.paper,
        reading: text.reading,
        unit: text.unit,
        printed: judged(text, printed, &single[0]),
        ours: judged(text, ours, &single[1]),
    };
    texts.map(claim).collect()
}

fn is_near(measured: f64, paper: f64, factor: f64) -> bool {
    (paper / factor..=paper * factor).contains(&measured)
}

/// The ratio `more / less`, and whether it is above [`NEAR`]; no evidence where a number is missing.
fn exceeds(more: Option<f64>, less: Option<f64>) -> Evidence {
    let ratio = more.zip(less).filter(|(_, less)| *less != 0.0).map(|(more, less)| more / less);
    (ratio, ratio.is_some_and(|ratio| ratio > NEAR))
}

/// By how much `of` POPC exceeds that of LOLC in a pair of runs that both settle.
fn settled_pair(runs: &Runs, of: fn(&Measures) -> f64) -> Evidence {
    let number = |run: &Measures| run.settled.map(|_| of(run));
    exceeds(number(&runs.stiff_popc), number(&runs.stiff_lolc))
}

/// Evidence of one number that must fulfil a condition.
fn number(number: Option<f64>, holds: impl Fn(f64) -> bool) -> Evidence {
    (number, number.is_some_and(holds))
}

/// A quantity over the energy's peak.
fn of_peak(run: &Measures, quantity: Option<f64>) -> Option<f64> {
    quantity.filter(|_| run.energy_peak > 0.0).map(|quantity| quantity / run.energy_peak)
}

/// The controller's reply over the wall's force.
fn reply(run: &Measures) -> Option<f64> {
    (run.force_peak > 0.0).then(|| run.reply / run.force_peak)
}

const SOFT: [Text; 9] = [
    Text {
        id: "unstable-without-control",
        paper: "8 kN/m: unstable without control",
        unit: "s",
        reading: "when |x| passes ten times the start; holds where it does within 30 s",
        judge: |runs| number(runs.soft_none.left, |_| true),
    },
    Text {
        id: "constant-swing",
        paper: "8 kN/m: without control a constant swing",
        unit: "1",
        reading: "widest swing of the second half second over that of the first; holds within a factor of 1.15 of 1",
        judge: |runs| number(runs.soft_none.growth, |growth| is_near(growth, 1.0, NEAR)),
    },
    Text {
        id: "settles-8k",
        paper: "8 kN/m: the position settles with LOLC",
        unit: "s",
        reading: "from when on |x| stays within 5 % of the start for 3 s; holds where that is within 27 s",
        judge: |runs| number(runs.soft_lolc.settled, |_| true),
    },
    Text {
        id: "force-peak",
        paper: "8 kN/m: first peak of the force near 3 N",
        unit: "N",
        reading: "the wall's largest force in the first contact, scaled to a start of 4 mm; holds within a factor of \
                  1.15 of 3 N",
        judge: |runs| {
            let run = &runs.soft_lolc;
            number(Some(run.force_peak / run.scale), |peak| is_near(peak, 3.0, NEAR))
        },
    },
    Text {
        id: "force-opposite",
        paper: "8 kN/m: controller's force: opposite sign",
        unit: "1",
        reading: "the controller's largest force within 0.1 s after the first contact over the wall's peak; holds \
                  below 0",
        judge: |runs| number(reply(&runs.soft_lolc), |share| share < 0.0),
    },
    Text {
        id: "force-same-size",
        paper: "8 kN/m: controller's force: same size",
        unit: "1",
        reading: "the size of the same ratio; holds within a factor of 1.15 of 1",
        judge: |runs| {
            let size = reply(&runs.soft_lolc).map(f64::abs);
            number(size, |size| is_near(size, 1.0, NEAR))
        },
    },
    Text {
        id: "energy-peak",
        paper: "8 kN/m: energy peaks near 2e-4 J",
        unit: "J",
        reading: "largest observed energy until the end of the first contact, scaled to a start of 4 mm; holds within \
                  a factor of 1.15^2 of 2e-4 J",
        judge: |runs| {
            let run = &runs.soft_lolc;
            let peak = run.energy_peak / (run.scale * run.scale);
            number(Some(peak), |peak| is_near(peak, 2e-4, NEAR * NEAR))
        },
    },
    Text {
        id: "energy-back-to-zero",
        paper: "8 kN/m: energy comes back to zero",
        unit: "1",
        reading: "observed energy where the run has settled, over its peak; holds within 5 % of zero",
        judge: |runs| {
            let run = &runs.soft_lolc;
            number(of_peak(run, run.energy_settled), |share| share.abs() <= ZERO)
        },
    },
    Text {
        id: "energy-stays-at-zero",
        paper: "8 kN/m: energy never falls below zero",
        unit: "1",
        reading: "lowest observed energy until the run has settled or passed a thousand times the start, over its peak; \
                  holds where it is at most 5 % of the peak below zero",
        judge: |runs| {
            let run = &runs.soft_lolc;
            number(of_peak(run, Some(run.energy_least)), |share| share >= -ZERO)
        },
    },
];

const STIFF: [Text; 10] = [
    Text {
        id: "settles-50k",
        paper: "50 kN/m: the position settles with both",
        unit: "s",
        reading: "settling time of the later of the two; holds where both settle within 27 s",
        judge: |runs| {
            let both = runs.stiff_popc.settled.zip(runs.stiff_lolc.settled);
            number(both.map(|(popc, lolc)| popc.max(lolc)), |_| true)
        },
    },
    Text {
        id: "popc-sooner",
        paper: "50 kN/m: POPC settles sooner",
        unit: "1",
        reading: "settling time of LOLC over that of POPC; holds above 1.15, and where only POPC settles",
        judge: |runs| {
            let (popc, lolc) = (runs.stiff_popc.settled, runs.stiff_lolc.settled);
            let (ratio, holds) = exceeds(lolc, popc);
            (ratio, holds || popc.is_some() && lolc.is_none())
        },
    },
    Text {
        id: "popc-smaller-swing",
        paper: "50 kN/m: POPC swings less",
        unit: "1",
        reading: "largest |x| after the first contact, LOLC over POPC, either until it has settled or passed a thousand \
                  times the start; holds above 1.15",
        judge: |runs| exceeds(Some(runs.stiff_lolc.swing), Some(runs.stiff_popc.swing)),
    },
    Text {
        id: "popc-jitters",
        paper: "50 kN/m: POPC jitters once settled",
        unit: "1",
        reading: "turns of the motion in the second after settling, each by more than 0.1 % of the start; holds from 2 on",
        judge: |runs| {
            let turns = runs.stiff_popc.turns;
            (turns.map(|turns| turns as f64), turns.is_some_and(|turns| turns >= JITTER))
        },
    },
    Text {
        id: "lolc-jitters-less",
        paper: "50 kN/m: LOLC jitters less than POPC",
        unit: "1",
        reading: "the same turns with POPC less those with LOLC; holds above 0, where both settle",
        judge: |runs| {
            let turns = runs.stiff_popc.turns.zip(runs.stiff_lolc.turns);
            number(turns.map(|(popc, lolc)| popc as f64 - lolc as f64), |more| more > 0.0)
        },
    },
    Text {
        id: "popc-impulsive",
        paper: "50 kN/m: POPC's energy is more impulsive",
        unit: "1",
        reading: "largest step of the observed energy in one tick, POPC over LOLC; holds above 1.15, where both settle",
        judge: |runs| settled_pair(runs, |run| run.largest_step),
    },
    Text {
        id: "lolc-smoother-energy",
        paper: "50 kN/m: LOLC's energy flows more smoothly",
        unit: "1",
        reading: "total variation of the observed energy until settled, POPC over LOLC; holds above 1.15, where both \
                  settle",
        judge: |runs| settled_pair(runs, |run| run.variation),
    },
    Text {
        id: "less-per-sample",
        paper: "50 kN/m: LOLC dissipates less per sample",
        unit: "1",
        reading: "the most that the controller takes in one period, POPC over LOLC; holds above 1.15, where both settle",
        judge: |runs| settled_pair(runs, |run| run.taken_at_once),
    },
    Text {
        id: "less-energy",
        paper: "LOLC less conservative: takes less energy",
        unit: "1",
        reading: "energy taken by the controller at 50 kN/m until settled, POPC over LOLC; holds above 1.15, where both \
                  settle",
        judge: |runs| settled_pair(runs, |run| run.taken),
    },
    Text {
        id: "more-walls",
        paper: "LOLC less conservative: settles on more walls",
        unit: "1",
        reading: "walls of the member's eight on which the loop settles with LOLC, less those with POPC; holds above 0",
        judge: |runs| {
            let walls = runs.lolc_walls.zip(runs.popc_walls);
            number(walls.map(|(lolc, popc)| lolc as f64 - popc as f64), |more| more > 0.0)
        },
    },
];

const _: () = assert!(WALLS == 8, "the text of more-walls says eight");

#[cfg(test)]
mod tests;
