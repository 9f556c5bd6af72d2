//! Replays of logs through stabilizers, against closed forms and an observer written out here.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use approx::assert_relative_eq;
use lyapunov_lab::observe::{Asked, LogError, NOTE, Replayed, Report, Settings, replay};
use lyapunov_lab::{Csv, Rollout, Scene};

use crate::observe::command::run;

/// Ticks of one swing, and swings of a log.
const SWING: u32 = 40;
const SWINGS: u32 = 5;
const AMPLITUDE: f64 = 0.004;
const PERIOD: f64 = 1e-3;

/// A harmonic motion from this phase on, against a two-sided spring with a damper: position and force.
fn harmonic(stiffness: f64, damping: f64, phase: f64) -> Vec<(f64, f64)> {
    let (angle, pace) = (TAU / f64::from(SWING), TAU / f64::from(SWING) / PERIOD);
    let row = |n: u32| {
        let (sin, cos) = (angle * f64::from(n) + phase).sin_cos();
        let (x, v) = (AMPLITUDE * sin, AMPLITUDE * pace * cos);
        (x, stiffness * x + damping * v)
    };
    (0..=SWING * SWINGS).map(row).collect()
}

/// `Σ f(n) (x(n+1) − x(n))` of that motion over whole swings: `N A² (b ω cos(θ/2) − k sin(θ/2)) sin(θ/2)`.
fn work(stiffness: f64, damping: f64) -> f64 {
    let angle = TAU / f64::from(SWING);
    let (sin, cos) = (0.5 * angle).sin_cos();
    let square = AMPLITUDE * AMPLITUDE;
    let ticks = f64::from(SWING * SWINGS);
    ticks * square * sin * (damping * angle / PERIOD * cos - stiffness * sin)
}

fn csv(rows: &[(f64, f64)]) -> String {
    let row = |(n, (x, f)): (usize, &(f64, f64))| format!("{:?},{x:?},{f:?}\n", n as f64 * PERIOD);
    "t,x,f\n".to_owned() + &rows.iter().enumerate().map(row).collect::<String>()
}

/// A device of 0.2 kg at 1 kHz before a wall, with further lines.
fn text(more: &str) -> String {
    let text = "duration = 1.0\nservo_rate = 1000.0\ndevice = { mass = 0.2, damping = 1.0 }\n\
        operator = { mass = 0.1, stiffness = 50.0, rest = 0.005 }\ninitial.position = -0.004\n\
        environment.wall.stiffness = 2000.0\n";
    format!("{text}{more}")
}

fn scene(more: &str) -> Scene {
    Scene::parse(&text(more), "made").unwrap_or_else(|fault| panic!("{fault}"))
}

fn asked(log: &str, scene: &Scene, names: &str) -> Result<Report, LogError> {
    let stabilizers = names.parse().unwrap();
    let asked = Asked { stabilizers, scene: scene.clone(), name: "made.toml".to_owned() };
    let observed = replay(log.as_bytes(), "log.csv", &Settings::default(), &asked);
    observed.map(|observed| observed.report)
}

#[track_caller]
fn replayed(log: &str, scene: &Scene, names: &str) -> Vec<Replayed> {
    asked(log, scene, names).unwrap().replay.unwrap().stabilizers
}

#[test]
fn nobody_takes_nothing_and_leaves_the_energy_of_the_formula() {
    for (stiffness, damping) in [(2000.0, 0.0), (2000.0, 0.4), (500.0, 0.1)] {
        let log = csv(&harmonic(stiffness, damping, 0.0));
        let report = asked(&log, &scene(""), "none").unwrap();
        let formula = work(stiffness, damping);
        assert_relative_eq!(report.energy.generated, -formula, max_relative = 1e-9);
        let [none] = report.replay.unwrap().stabilizers[..] else { panic!("one row") };
        assert_eq!((none.active_ticks, none.largest_force, none.energy_taken), (0, 0.0, 0.0));
        // Without a damper the lowest sum is the last one: the spring holds nothing there.
        if damping == 0.0 {
            assert_relative_eq!(none.energy_given, -formula, max_relative = 1e-9);
        }
    }
}

/// Who answers a debt has nothing to answer where the spring's damper burns more than the hold makes: `b ω cos(θ/2) > k
/// sin(θ/2)`, and at every tick.
#[test]
fn a_port_that_never_gives_asks_for_nothing() {
    let names = "popc,lolc-spring,popc-bounded,popc-windowed,popc-spread,popc-rate-limited,popc-rising,\
        popc-budgeted,least-norm,popc-threshold";
    // Against a damper alone, and one so strong that no stretch of a swing gives back.
    let log = csv(&harmonic(0.0, 5.0, 0.0));
    assert!(work(0.0, 5.0) > 0.0);
    for row in replayed(&log, &scene(""), names) {
        assert_eq!((row.active_ticks, row.energy_taken, row.shortfall), (0, 0.0, 0.0), "{row:?}");
        assert_eq!((row.energy_given, row.rejected, row.ticks), (0.0, 0, 201), "{row:?}");
    }
    // Ten that are equal are too long for a heading.
    let shown = asked(&log, &scene(""), names).unwrap().to_string();
    assert!(shown.contains("popc + 9"), "{shown}");
}

/// A log that is cut where a wall of 2 kN/m is pressed by 4 mm, from where it gives `share` of what it stores.
fn released(share: f64) -> String {
    let x = |n: u32| 0.004 * (1.0 - f64::from(n) / 200.0);
    // The mean force over the way to the next row gives exactly the difference of what is stored.
    let force = |n: u32| share * 2000.0 * 0.5 * (x(n) + x((n + 1).min(200)));
    csv(&(0..=200).map(|n| (x(n), force(n))).collect::<Vec<_>>())
}

/// Energy stored before the first row is no debt of the port, wherever the scene itself starts.
#[test]
fn what_is_stored_on_the_first_row_may_come_out() {
    let names = "popc-reference,reference-following,popc-budgeted";
    for row in replayed(&released(0.99), &scene(""), names) {
        assert_eq!((row.active_ticks, row.shortfall), (0, 0.0), "{row:?}");
        assert_relative_eq!(row.energy_given, 0.99 * 0.016, max_relative = 1e-9);
    }
    for row in replayed(&released(1.01), &scene(""), names) {
        assert!(row.active_ticks > 0, "{row:?}");
    }
    // What is written counts, and who has no budget answers at once.
    let none = scene("stabilizer.popc-budgeted.budget = 0.0\n");
    for row in replayed(&released(0.99), &none, "popc,popc-budgeted") {
        assert!(row.first_at.is_some_and(|at| at < 1.5 * PERIOD), "{row:?}");
    }
}

/// In single precision 1e39 N is no number: the tick that reads it has no effort to correct, and the next one no force that was held.
#[test]
fn ticks_that_a_stabilizer_cannot_take_are_counted() {
    let mut rows = harmonic(500.0, 0.1, 0.0);
    for row in [50, 90] {
        rows[row].1 = 1e39;
    }
    let [single] = replayed(&csv(&rows), &scene("scalar = 'f32'\n"), "popc")[..] else { panic!() };
    assert_eq!(single.rejected, 4);
    let [double] = replayed(&csv(&rows), &scene(""), "popc")[..] else { panic!() };
    assert_eq!(double.rejected, 0);
}

/// A log that begins and ends without a force is free of contact there, also one without any force.
#[test]
fn no_force_is_no_contact() {
    let [none, swinging] = [0.0, 2000.0]
        .map(|stiffness| asked(&csv(&harmonic(stiffness, 0.0, 0.3)), &scene(""), "none").unwrap());
    assert!(!none.starts_in_contact && !none.ends_in_contact);
    assert!(swinging.starts_in_contact && swinging.ends_in_contact);
}

/// POPC as the tick contract writes it, with its correction acting on the recorded motion.
fn by_hand(rows: &[(f64, f64)], most: f64, late: usize) -> Replayed {
    let (mut sum, mut taken, mut squares): (f64, f64, f64) = (0.0, 0.0, 0.0);
    let (mut port, mut given): (f64, f64) = (0.0, 0.0);
    let mut told = replayed(&csv(&rows[..2]), &scene(""), "none")[0];
    let mut added: Vec<f64> = Vec::new();
    for (n, (x, _)) in rows.iter().enumerate() {
        let before = n.checked_sub(1);
        let moved = before.map_or(0.0, |before| x - rows[before].0);
        let acting = n.checked_sub(1 + late).map_or(0.0, |at| added[at]);
        let held = before.map_or(0.0, |before| rows[before].1);
        sum += (held + acting) * moved;
        port += (held + acting) * moved;
        given = given.max(-port);
        taken += acting * moved;
        let v = moved / PERIOD;
        let burns = v * v * PERIOD;
        let alpha = if sum < 0.0 && burns > 0.0 { (-sum / burns).min(most) } else { 0.0 };
        told.shortfall = told.shortfall.max(-sum - alpha * burns);
        let force = alpha * v;
        squares += force * force;
        if force != 0.0 {
            told.first_at.get_or_insert(n as f64 * PERIOD);
            told.active_ticks += 1;
        }
        if force.abs() > told.largest_force {
            (told.largest_force, told.largest_force_at) = (force.abs(), Some(n as f64 * PERIOD));
        }
        added.push(force);
    }
    Replayed {
        energy_taken: taken,
        energy_given: given,
        rms_force: (squares / rows.len() as f64).sqrt(),
        ..told
    }
}

#[test]
fn popc_would_have_done_what_the_contract_says() {
    // With a peak on a tick two steps cancel, and the sum is 0 up to rounding.
    let rows = harmonic(2000.0, 0.0, 0.3);
    for (more, most, late) in [
        ("", 0.5 * 0.2 / PERIOD, 0),
        ("stabilizer.popc.damping_cap = inf\n", f64::INFINITY, 0),
        ("stabilizer.popc.damping_cap = 0.003\n", 0.003 * 0.2 / PERIOD, 0),
        ("stabilizer.popc.damping_cap = 0.02\neffects.delay.ticks = 3\n", 0.02 * 0.2 / PERIOD, 3),
    ] {
        let scene = scene(more);
        // The mass in the limit is all that moves at the port.
        let most = most * scene_mass() / 0.2;
        let [found] = replayed(&csv(&rows), &scene, "popc")[..] else { panic!("one row") };
        let expected = by_hand(&rows, most, late);
        assert!(found.active_ticks > 20, "{found:?}");
        assert_eq!(found.active_ticks, expected.active_ticks, "{more}");
        assert_eq!((found.first_at, found.rejected), (expected.first_at, 0), "{more}");
        for (found, expected) in [
            (found.largest_force, expected.largest_force),
            (found.rms_force, expected.rms_force),
            (found.energy_taken, expected.energy_taken),
            (found.energy_given, expected.energy_given),
        ] {
            assert_relative_eq!(found, expected, max_relative = 1e-9);
        }
        assert_relative_eq!(
            found.shortfall,
            expected.shortfall,
            max_relative = 1e-9,
            epsilon = 1e-15
        );
    }
}

/// The mass of operator and device, kg.
fn scene_mass() -> f64 {
    0.1 + 0.2
}

#[test]
fn a_run_in_which_it_never_acted_asks_for_nothing() {
    // A damped wall so soft that its port never gives.
    let damped = "environment.wall.damping = 4.0\nstabilizer.popc = {}\n";
    let [narrow, scene] =
        [format!("{damped}scalar = \"f32\"\n"), damped.to_owned()].map(|it| scene(&it));
    let mut rows = Csv::of(Vec::new(), &scene).unwrap();
    let mut acted = false;
    for tick in Rollout::<f64>::of(&scene).unwrap() {
        acted |= tick.correction.alpha > 0.0;
        rows.write(&tick).unwrap();
    }
    assert!(!acted, "the scene is for a stabilizer that has nothing to do");
    let log = String::from_utf8(rows.into_inner().unwrap()).unwrap();
    for scene in [scene, narrow] {
        for row in replayed(&log, &scene, "popc,lolc-spring,popc-budgeted") {
            assert_eq!(
                (row.active_ticks, row.energy_taken, row.energy_given),
                (0, 0.0, 0.0),
                "{row:?}"
            );
        }
    }
}

const LOG: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/logs/mujoco-wall.csv");
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/paper-8k-none.toml");

#[test]
fn ports_around_the_environment_are_told_by_name() {
    let ended =
        run(&[LOG, "--scene", SCENE, "--stabilizers", "popc,iss,virtual-coupling", "--json"]);
    assert_eq!((ended.status, ended.error.as_str()), (Some(0), ""));
    let json: serde_json::Value = serde_json::from_str(&ended.out).unwrap();
    let replay = &json["replay"];
    let left: Vec<&str> = replay["not_replayed"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["stabilizer"].as_str().unwrap())
        .collect();
    assert_eq!(left, ["iss", "virtual-coupling"]);
    assert_eq!(
        (&replay["stabilizers"][0]["stabilizer"], &replay["note"]),
        (&"popc".into(), &NOTE.into())
    );
    assert!(replay["stabilizers"][0]["energy_taken"].as_f64().unwrap() > 1.0);
}

#[test]
fn what_cannot_be_asked_is_refused_with_a_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let fast = folder.path().join("fast.toml");
    fs::write(&fast, text("")).unwrap();
    let space = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/sphere.toml");
    for (arguments, reasons) in [
        (
            &["--stabilizers", "popc"][..],
            &["--stabilizers needs --scene", "mass, servo period", "add --scene"][..],
        ),
        (&["--scene", SCENE], &["--stabilizers"]),
        (
            &["--scene", SCENE, "--stabilizers", "pocp"],
            &["no stabilizer is called `pocp`", "`popc`"],
        ),
        (
            &["--scene", SCENE, "--stabilizers", "iss"],
            &["iss cannot be replayed", "port around", "popc"],
        ),
        (&["--scene", space, "--stabilizers", "popc"], &["sphere.toml", "3 axes", "[space]"]),
        (
            &["--scene", fast.to_str().unwrap(), "--stabilizers", "popc"],
            &["rows are 0.01", "servo period of 0.001 s", "servo_rate = 100"],
        ),
    ] {
        let ended = run(&[&[LOG], arguments].concat());
        assert_eq!((ended.status, ended.out.as_str()), (Some(2), ""), "{}", ended.error);
        for reason in reasons {
            assert!(ended.error.contains(reason), "no `{reason}` in: {}", ended.error);
        }
    }
}

#[test]
fn the_page_of_the_documentation_shows_what_is_printed() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/observe.md");
    let page = fs::read_to_string(page).unwrap();
    let scene = Scene::load(SCENE.as_ref()).unwrap();
    let stabilizers = "popc,tank,iss".parse().unwrap();
    let asked = Asked { stabilizers, scene, name: "scenes/paper-8k-none.toml".to_owned() };
    let log = fs::File::open(LOG).unwrap();
    let report = replay(log, LOG, &Settings::default(), &asked).unwrap().report.to_string();
    let shown = report.split("\n\n").last().unwrap();
    assert!(page.contains(shown), "docs/observe.md should show:\n{shown}");
}

#[test]
fn more_than_four_forces_stand_in_two_columns() {
    let (log, scene) = (fs::read_to_string(LOG).unwrap(), Scene::load(Path::new(SCENE)).unwrap());
    let four = "none,popc,lolc-device-damping,popc-spread,popc-rate-limited";
    for (names, panels, columns) in
        [(four.to_owned(), 4, 1), (format!("{four},popc-bounded"), 5, 2)]
    {
        let replay = asked(&log, &scene, &names).unwrap().replay.unwrap();
        let figure = replay.figure("forces").unwrap();
        assert_eq!((figure.panels.len(), figure.columns), (panels, columns), "{names}");
    }
}

#[test]
fn table_page_and_figure_say_that_the_motion_would_have_been_another() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let ended = run(&[LOG, "--scene", SCENE, "--stabilizers", "all", "--out", out]);
    assert_eq!((ended.status, ended.error.as_str()), (Some(0), ""));
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(&ended.out).contains(&words(NOTE)), "{}", ended.out);
    assert!(ended.out.lines().all(|line| line.chars().count() <= 100), "{}", ended.out);
    let read = |name: &str| fs::read_to_string(Path::new(out).join(name)).unwrap();
    let page = read("report.html");
    assert!(page.contains(NOTE) && page.contains("iss, virtual-coupling: a port around"));
    assert!(page.len() < 1_000_000, "{}", page.len());
    let rows = read("stabilizers.csv");
    assert!(rows.starts_with("stabilizer,ticks,active_ticks,"), "{rows}");
    assert!(read("stabilizers.svg").starts_with("<svg") && read("observe.json").contains(NOTE));
}
