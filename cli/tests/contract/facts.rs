//! Known facts about the paper's loops (docs/contract.md), checked on the reference and on the command.

use crate::contract::row::Row;
use crate::contract::scene::{Kind, SOFT, STIFF, Scene, Work};
use approx::abs_diff_eq;

type Run = fn(&Scene) -> Vec<Row>;

pub(crate) const ALL: [fn(Run); 8] = [
    peaks_at_the_soft_wall,
    settling_at_the_stiff_wall,
    divergence_without_a_stabilizer,
    sampled_work_is_blind,
    detection_in_the_first_contact,
    boundedness_over_a_slow_environment,
    limits_of_the_damper,
    limits_of_the_papers_credit,
];

fn lolc(scene: Scene) -> Scene {
    scene.with(Kind::MassSpringDamper, Work::Held, 0.5)
}

fn popc(scene: Scene) -> Scene {
    scene.with(Kind::Popc, Work::Held, 0.5)
}

/// Ticks from the first one in contact with the wall to the first one off it again.
pub(crate) fn first_contact(rows: &[Row]) -> std::ops::RangeInclusive<usize> {
    let touch = rows.iter().position(|row| row.x_measured > 0.0);
    let touch = touch.expect("the loop starts 4 mm before the wall and swings past it");
    let off = rows[touch..].iter().position(|row| row.x_measured <= 0.0);
    touch..=touch + off.expect("the first contact ends")
}

fn largest(rows: &[Row], column: fn(&Row) -> f64) -> f64 {
    rows.iter().map(|row| column(row).abs()).fold(0.0, f64::max)
}

fn settled_from(rows: &[Row], within: f64) -> f64 {
    let last_out = rows.iter().rposition(|row| row.x.abs() > within);
    last_out.map_or(0.0, |n| rows[n + 1].t)
}

fn near(what: &str, got: f64, want: f64, tolerance: f64) {
    assert!(
        abs_diff_eq!(got, want, epsilon = tolerance),
        "{what}: {got} is not {want} +- {tolerance}"
    );
}

fn peaks_at_the_soft_wall(run: Run) {
    let rows = run(&lolc(Scene::paper(SOFT)));
    let contact = &rows[first_contact(&rows)];
    let force = largest(contact, |row| row.f_env);
    near("first force peak", force, 2.955, 0.001);
    let energy = rows.iter().map(|row| row.observer).fold(0.0, f64::max);
    near("energy peak", energy, 2.53e-4, 0.01e-4);
}

fn settling_at_the_stiff_wall(run: Run) {
    let popc = settled_from(&run(&popc(Scene::paper(STIFF))), 2e-4);
    let lolc = settled_from(&run(&lolc(Scene::paper(STIFF))), 2e-4);
    near("POPC settles", popc, 1.36, 0.02);
    near("LOLC settles", lolc, 2.35, 0.02);
}

fn divergence_without_a_stabilizer(run: Run) {
    for wall in [SOFT, STIFF] {
        assert!(largest(&run(&Scene::paper(wall)), |row| row.x) > 1.0);
    }
}

fn sampled_work_is_blind(run: Run) {
    for wall in [SOFT, STIFF] {
        for kind in [Kind::Popc, Kind::MassSpringDamper] {
            let rows = run(&Scene::paper(wall).with(kind, Work::Sampled, 0.5));
            let blind = |row: &Row| row.alpha == 0.0 && row.observer >= 0.0;
            assert!(rows.iter().all(blind));
            assert!(largest(&rows, |row| row.x) > 1.0);
            assert!(rows[rows.len() - 1].observer > 1.0, "the sum grows");
        }
    }
}

fn detection_in_the_first_contact(run: Run) {
    for (rate, detects) in [(100.0, true), (1e3, true), (2e3, true), (1e4, false)] {
        let scene = Scene::paper(SOFT).at(rate, 1);
        let rows = run(&scene.with(Kind::Popc, Work::Held, 0.0));
        let contact_end = *first_contact(&rows).end();
        let seen = if detects { &rows[..=contact_end] } else { &rows };
        let negative = seen.iter().any(|row| row.observer < 0.0);
        assert_eq!(negative, detects, "{rate} Hz");
    }
}

fn boundedness_over_a_slow_environment(run: Run) {
    for hold in [1, 2, 5, 10, 20, 50, 100] {
        let scene = Scene::paper(SOFT).at(100.0 * hold as f64, hold);
        let rows = run(&popc(scene));
        let swing = largest(&rows, |row| row.x);
        assert!(swing <= 1.5 * 4e-3, "POPC with a hold of {hold}: {swing} m");
    }
    let swing = largest(&run(&lolc(Scene::paper(SOFT))), |row| row.x);
    assert!(swing <= 1.5 * 4e-3, "LOLC: {swing} m");
}

fn limits_of_the_damper(run: Run) {
    let uncapped = Scene::paper(STIFF).with(Kind::Popc, Work::Held, f64::INFINITY);
    let mut delayed = popc(Scene::paper(SOFT));
    delayed.delay = 2;
    for scene in [uncapped, delayed] {
        assert!(largest(&run(&scene), |row| row.x) > 1.0);
    }
}

fn limits_of_the_papers_credit(run: Run) {
    let observed = |kind| run(&Scene::paper(STIFF).at(1e3, 1).with(kind, Work::Held, 0.0));
    let negative = |row: &Row| row.observer < 0.0;
    let seen = observed(Kind::Popc);
    assert!(seen[..=*first_contact(&seen).end()].iter().any(negative));
    assert!(!observed(Kind::MassSpringDamper).iter().any(negative));

    let slow_wall = Scene::paper(STIFF).at(1e3, 10);
    assert!(largest(&run(&lolc(slow_wall.clone())), |row| row.x) > 1.0);
    assert!(settled_from(&run(&popc(slow_wall)), 5e-4) < 9.0);
}

#[test]
fn known_facts_hold_for_the_reference() {
    for fact in ALL {
        fact(crate::contract::reference::run);
    }
}
