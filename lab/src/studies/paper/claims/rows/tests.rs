//! Tests of the claims on runs made up by hand.

use super::*;

/// Evidence on the claim `id` from the runs that `change` makes of blank ones.
fn evidence(id: &str, change: impl Fn(&mut Runs)) -> Evidence {
    let mut runs = Runs::default();
    change(&mut runs);
    let text = SOFT.iter().chain(&STIFF).find(|text| text.id == id);
    (text.unwrap_or_else(|| panic!("no claim {id}")).judge)(&runs)
}

fn settled(settled: f64) -> Measures {
    Measures { settled: Some(settled), turns: Some(0), ..Measures::default() }
}

#[test]
fn nothing_holds_of_runs_without_numbers() {
    for text in SOFT.iter().chain(&STIFF) {
        assert!(!(text.judge)(&Runs::default()).1, "{}", text.id);
    }
}

#[test]
fn sign_and_size_of_the_controller_s_force_are_two_claims() {
    let reply = |reply: f64| {
        move |runs: &mut Runs| {
            runs.soft_lolc = Measures { force_peak: 3.0, reply, ..Measures::default() };
        }
    };
    for (force, opposite, same_size) in [
        (-1.3, true, false),
        (-2.7, true, true),
        (2.7, false, true),
        (-3.6, true, false),
        (0.0, false, false),
    ] {
        assert_eq!(evidence("force-opposite", reply(force)).1, opposite, "{force}");
        assert_eq!(evidence("force-same-size", reply(force)).1, same_size, "{force}");
    }
}

#[test]
fn an_energy_may_peak_and_come_back_and_still_fall_below_zero() {
    let run = |least: f64, end: f64| {
        move |runs: &mut Runs| {
            let energy_settled = Some(end);
            runs.soft_lolc = Measures {
                scale: 1.1,
                energy_peak: 2e-4 * 1.21,
                energy_least: least,
                energy_settled,
                ..settled(9.0)
            };
        }
    };
    let verdicts = |least, end| {
        let ids = ["energy-peak", "energy-back-to-zero", "energy-stays-at-zero"];
        ids.map(|id| evidence(id, run(least, end)).1)
    };
    assert_eq!(verdicts(-1e-5, 1e-6), [true, true, true]);
    assert_eq!(verdicts(-9.0 * 2e-4, 1e-6), [true, true, false]);
    assert_eq!(verdicts(-1e-5, 5e-5), [true, false, true]);
}

#[test]
fn more_means_more_by_a_margin_and_in_runs_that_settle() {
    let pair = |popc: Measures, lolc: Measures| {
        move |runs: &mut Runs| (runs.stiff_popc, runs.stiff_lolc) = (popc, lolc)
    };
    let step = |step: f64| Measures { largest_step: step, variation: step, ..settled(1.0) };
    for (id, popc, lolc, holds) in [
        ("popc-impulsive", 1.2, 1.0, true),
        ("popc-impulsive", 1.01, 1.0, false),
        ("lolc-smoother-energy", 0.074, 0.107, false),
        ("lolc-smoother-energy", 0.107, 0.074, true),
    ] {
        let (ratio, held) = evidence(id, pair(step(popc), step(lolc)));
        assert_eq!((ratio, held), (Some(popc / lolc), holds), "{id}");
    }
    let unsettled = Measures { settled: None, ..step(1.0) };
    assert_eq!(evidence("popc-impulsive", pair(step(9.0), unsettled)), (None, false));
    assert_eq!(evidence("popc-impulsive", pair(step(9.0), step(0.0))), (None, false));

    let never = Measures::default();
    assert!(evidence("popc-sooner", pair(settled(1.0), settled(1.2))).1);
    assert!(!evidence("popc-sooner", pair(settled(1.0), settled(1.1))).1);
    assert!(evidence("popc-sooner", pair(settled(1.0), never)).1);
    assert!(!evidence("popc-sooner", pair(never, settled(1.0))).1);
    assert!(!evidence("settles-50k", pair(settled(1.0), never)).1);
    assert_eq!(evidence("settles-50k", pair(settled(1.0), settled(2.0))), (Some(2.0), true));
}

#[test]
fn jitter_is_counted_in_turns() {
    let turns = |turns: usize| Measures { turns: Some(turns), ..settled(1.0) };
    let pair = |popc: usize, lolc: usize| {
        move |runs: &mut Runs| (runs.stiff_popc, runs.stiff_lolc) = (turns(popc), turns(lolc))
    };
    let judged = |popc, lolc| {
        ["popc-jitters", "lolc-jitters-less"].map(|id| evidence(id, pair(popc, lolc)).1)
    };
    assert_eq!(judged(1, 0), [false, true]);
    assert_eq!(judged(2, 2), [true, false]);
    assert_eq!(judged(8, 3), [true, true]);
}

#[test]
fn walls_are_counted_against_each_other() {
    let walls = |popc, lolc| {
        move |runs: &mut Runs| (runs.popc_walls, runs.lolc_walls) = (Some(popc), Some(lolc))
    };
    assert_eq!(evidence("more-walls", walls(5, 6)), (Some(1.0), true));
    assert_eq!(evidence("more-walls", walls(5, 5)), (Some(0.0), false));
    assert_eq!(evidence("more-walls", |_| ()), (None, false));
}

#[test]
fn every_claim_has_a_name_and_a_line_of_its_own() {
    let texts = || SOFT.iter().chain(&STIFF);
    let mut ids: Vec<&str> = texts().map(|text| text.id).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), texts().count());
    assert!(texts().all(|text| text.paper.chars().count() <= 46));
}
