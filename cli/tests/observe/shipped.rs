//! Tests on the shipped log of MuJoCo, against our own simulation of the same scene and against its own rows.

use approx::assert_relative_eq;
use lyapunov::{DampingLimit, Popc, PortEnergy};
use lyapunov_lab::bound::Limits;
use lyapunov_lab::observe::{Report, Settings, observe};
use lyapunov_lab::{Rollout, Row, Scene, Summary, Verdict};

use crate::observe::command::run;

const LOG: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/logs/mujoco-wall.csv");
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/paper-8k-none.toml");

fn report() -> Report {
    observe(std::fs::File::open(LOG).unwrap(), LOG, &Settings::default()).unwrap().report
}

/// The same scene in the lab, under a POPC that may inject no damping.
fn rollout(rows: usize) -> Vec<Row> {
    let scene = Scene::load(SCENE.as_ref()).unwrap();
    let watch: Popc<f64> = Popc::new(PortEnergy, DampingLimit::of_mass(0.0, 0.3, 0.01).unwrap());
    Rollout::<f64>::stabilized_by(&scene, watch).unwrap().rows().take(rows).collect()
}

#[test]
fn the_observer_agrees_with_our_own_simulation() {
    let (report, rows) = (report(), rollout(201));
    assert_eq!((report.rows, report.bad_rows.count, report.gaps.count), (201, 0, 0));
    let first = rows.iter().find(|row| row.observed_energy < 0.0).unwrap();
    assert_eq!(report.observed_energy.negative_at, Some(first.t));
    assert_eq!(report.observed_energy.debts, 1);

    // The simulators agree within 2e-15 m in the first contact and, as the loop diverges, 6e-12 m at the end.
    const SHARE: f64 = 1e-9;
    assert_relative_eq!(
        report.observed_energy.last,
        rows[200].observed_energy,
        max_relative = SHARE
    );
    let lowest = rows.iter().map(|row| row.observed_energy).fold(0.0, f64::min);
    assert_relative_eq!(report.observed_energy.lowest, lowest, max_relative = SHARE);
    let works: Vec<f64> =
        rows.windows(2).map(|pair| pair[0].f_act * (pair[1].x - pair[0].x)).collect();
    assert_relative_eq!(
        report.energy.absorbed,
        works.iter().filter(|work| **work > 0.0).sum::<f64>(),
        max_relative = SHARE
    );
    assert_relative_eq!(
        -report.energy.released,
        works.iter().filter(|work| **work < 0.0).sum::<f64>(),
        max_relative = SHARE
    );

    // The paper's printed observer misses the debt, as docs/paper.md says of this scene.
    let printed: f64 = rows.iter().map(|row| row.f_env * row.v * 0.01).sum();
    assert_relative_eq!(report.printed.last, printed, max_relative = SHARE);
    assert_eq!(report.printed.negative_at, None);
}

#[test]
fn every_contact_of_the_log_is_reported() {
    let report = report();
    let rows = rollout(201);
    let mut starts: Vec<f64> = rows
        .windows(2)
        .filter(|pair| pair[0].f_env == 0.0 && pair[1].f_env > 0.0)
        .map(|pair| pair[1].t)
        .collect();
    let mut told: Vec<f64> = report.contacts.worst.iter().map(|contact| contact.start).collect();
    told.sort_by(f64::total_cmp);
    starts.truncate(told.len());
    assert_eq!((told, report.contacts.count), (starts, 8));

    // The first contact by hand: rows 13 and 14 push with 2.578 N and 2.955 N.
    let first = report.contacts.worst.iter().find(|contact| contact.start < 0.2).unwrap();
    let (x13, x14, x15) = (3.098793486469987e-4, 3.679292665456425e-4, -4.983898040727688e-4);
    let (into, out) = (2.577954633330946 * (x14 - x13), 2.9550441159448697 * (x14 - x15));
    assert_relative_eq!(first.absorbed, into, max_relative = 1e-12);
    assert_relative_eq!(first.released, out, max_relative = 1e-12);
    assert_relative_eq!(first.peak_force, 2.9550441159448697, max_relative = 1e-15);
    let motion = ((x14 - x13) * (x14 - x13) + (x15 - x14) * (x15 - x14)) / 0.01;
    assert_relative_eq!(first.damping.unwrap(), (out - into) / motion, max_relative = 1e-9);
}

#[test]
fn the_command_prints_the_same_as_json() {
    let ended = run(&[LOG, "--json"]);
    assert_eq!((ended.status, ended.error.as_str()), (Some(0), ""));
    let json: serde_json::Value = serde_json::from_str(&ended.out).unwrap();
    let report = report();
    assert_eq!(json["observed_energy"]["final"], report.observed_energy.last);
    assert_eq!(json["observed_energy"]["negative_at"], 0.15);
    assert_eq!(json["contacts"]["worst"][0]["generated"], report.contacts.worst[0].generated);
    assert_eq!(json["candidate"]["name"], "spring");
    let ended = run(&[LOG]);
    assert_eq!((ended.out, ended.error.as_str()), (format!("{report}\n"), ""));
}

#[test]
fn a_credit_as_large_as_the_damper_leaves_no_debt() {
    let needed = report().damper.damping.unwrap();
    for (share, debts) in [(1.001, 0), (0.99, 1)] {
        let damping = (needed * share).to_string();
        let credited = ["--candidate", "device-damping", "--damping", &damping];
        let ended = run(&[&[LOG, "--json"], &credited[..]].concat());
        let json: serde_json::Value = serde_json::from_str(&ended.out).unwrap();
        assert_eq!(json["observed_energy"]["debts"], debts, "{damping}");
    }
}

/// The damper that the debts ask for over the recorded motion is no repair of the loop.
#[test]
fn with_the_damper_of_the_log_its_loop_still_grows() {
    let needed = report().damper.damping.unwrap();
    let text = std::fs::read_to_string(SCENE).unwrap();
    let with = |from: &str, damping: f64| {
        assert_eq!(text.matches(from).count(), 1);
        let text = text.replace(from, &format!("damping = {damping}"));
        Scene::parse(&text, "damped").unwrap()
    };
    // Rendered by the controller, late and from samples, as the wall's own damper.
    let rendered = with("damping = 2.0", 2.0 + needed);
    let summary = Summary::of(&rendered, Rollout::<f64>::of(&rendered).unwrap());
    assert_eq!(summary.verdict(), Verdict::Grows);
    // In the device: the linear loop is still not stable.
    let limits = Limits::of(&with("damping = 0.001", 0.001 + needed));
    assert!(limits.spectral_radius.unwrap() > 1.3);
}

#[test]
fn the_page_shows_what_is_printed() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/observe.md");
    let page = std::fs::read_to_string(page).unwrap();
    let name = "scenes/logs/mujoco-wall.csv";
    let shown = Report { log: name.to_owned(), ..report() }.to_string();
    assert!(page.contains(&shown), "docs/observe.md should show:\n{shown}");
}
