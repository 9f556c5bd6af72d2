//! What a log cannot tell is said.

use lyapunov_lab::identify::{Identified, Settings, identify};
use lyapunov_lab::observe::LogError;
use lyapunov_lab::{Scene, identify as study};

use super::loops::{Chance, PLAIN, Truth};

fn fitted(log: &str) -> Result<Identified, LogError> {
    identify(log.as_bytes(), "log.csv", &Settings::default())
}

fn of(truth: Truth, rows: usize) -> Identified {
    fitted(&truth.log(rows, &mut Chance::new(7))).unwrap()
}

fn says(found: &Identified, words: &str) -> bool {
    found.report.notes.iter().any(|note| note.contains(words))
}

#[test]
fn a_hand_that_stays_is_no_unknown_push() {
    let found = of(Truth { encoder: 1e-5, ..PLAIN }, 800);
    assert!(!found.report.residual.is_pushed && !says(&found, "late") && !says(&found, "no wall"));
    assert_eq!(found.report.notes.len(), 1, "{:?}", found.report.notes);
}

#[test]
fn a_log_in_another_unit_is_told_from_its_own_numbers() {
    let log = PLAIN.log(800, &mut Chance::new(7));
    assert_eq!(fitted(&log).unwrap().report.look_at, []);
    let in_mm = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let x: f64 = fields[1].parse().unwrap();
        format!("{},{:?},{}\n", fields[0], 1e3 * x, fields[2])
    };
    let (names, rows) = log.split_once('\n').unwrap();
    let log = format!("{names}\n{}", rows.lines().map(in_mm).collect::<String>());
    let found = fitted(&log).unwrap().report.look_at;
    assert!(found.len() == 1 && found[0].text.contains("--scale x=1e-3"), "{found:?}");
}

#[test]
fn a_log_far_from_0_tells_the_same_numbers() {
    let log = PLAIN.log(800, &mut Chance::new(7));
    let (names, rows) = log.split_once('\n').unwrap();
    for place in [10.0, -10.0, 1000.0] {
        let moved = |line: &str| {
            let fields: Vec<&str> = line.split(',').collect();
            let x: f64 = fields[1].parse().unwrap();
            format!("{},{:?},{}\n", fields[0], place + x, fields[2])
        };
        let found = fitted(&format!("{names}\n{}", rows.lines().map(moved).collect::<String>()));
        let found = found.unwrap();
        let wall = found.report.wall.unwrap();
        let [position, stiffness, damping] = PLAIN.wall;
        // An `f64` tells a place to 2e-16 of it, and the depth is some millimetres.
        let digits = place.abs() * 1e-12;
        assert!((wall.position.value - place - position).abs() < 0.1 * digits, "{wall:?}");
        assert!((wall.stiffness.value / stiffness - 1.0).abs() < digits, "{wall:?}");
        assert!((wall.damping.value / damping - 1.0).abs() < digits, "{wall:?}");
        let report = &found.report;
        let rest = report.rest.unwrap();
        assert!((rest.value - place - PLAIN.rest).abs() < 1e-7, "{rest:?}");
        assert!((report.mass.value / PLAIN.mass - 1.0).abs() < 1e-6, "{report:?}");
        assert!((report.stiffness.value / PLAIN.stiffness - 1.0).abs() < 1e-6, "{report:?}");
        assert!(report.replayed.unwrap() < 1e-8, "{report:?}");
        assert!(!says(&found, "late"), "{:?}", found.report.notes);
    }
}

/// A log whose hand moves is fitted over short stretches, however little noise there is.
#[test]
fn a_clean_log_of_a_hand_that_moves_tells_its_mass() {
    for swing in [0.004, 0.02] {
        let found = of(Truth { swing, ..PLAIN }, 3000);
        let mass = found.report.mass;
        assert!(found.report.residual.is_pushed, "{swing}");
        assert!((mass.low..=mass.high).contains(&0.3), "{swing}: {mass:?}");
    }
}

/// Stamps in whole microseconds of a clock of 333 Hz, whose median step is 3.003 ms and mean step 3.003003 ms.
#[test]
fn the_scene_has_the_clock_of_its_log_and_lasts_as_long() {
    let log = PLAIN.log(1500, &mut Chance::new(7));
    let stamped = |(row, line): (usize, &str)| {
        let fields = line.split_once(',').unwrap().1;
        let time = (1e6 * row as f64 / 333.0).round() / 1e6;
        format!("{time:?},{fields}\n")
    };
    let (names, rows) = log.split_once('\n').unwrap();
    let rows: String = rows.lines().enumerate().map(stamped).collect();
    let found = fitted(&format!("{names}\n{rows}")).unwrap();
    let scene = Scene::parse(&found.scene, "scene").unwrap();
    assert!((scene.servo_rate.get() - 333.0).abs() < 1e-4, "{}", found.scene);
    assert!(scene.end() >= 1499.0 / 333.0 - 1e-6, "{}", found.scene);
    assert_eq!(scene.ticks(), 1499);
}

#[test]
fn a_hand_that_moves_is_said() {
    for (swing, told) in [(0.004, 2.0), (0.001, 0.1), (1e-4, 0.03)] {
        let found = of(Truth { swing, noise: 1e-6, ..PLAIN }, 2000);
        assert!(found.report.residual.is_pushed && says(&found, "something pushes"), "{swing}");
        // The wall is another column's affair.
        let wall = found.report.wall.unwrap();
        assert!((wall.stiffness.value - 1000.0).abs() < 1e-3);
        // The more the hand moves, the less is told, and the truth stays inside.
        let mass = found.report.mass;
        assert!((mass.low..=mass.high).contains(&0.3), "{swing}: {mass:?}");
        assert!((mass.value - 0.3).abs() < told * 0.3, "{swing}: {mass:?}");
    }
}

#[test]
fn a_force_that_acts_late_is_a_delay() {
    let found = of(Truth { late: 3, encoder: 1e-5, ..PLAIN }, 800);
    assert_eq!(found.report.acts_late, 3);
    assert!(says(&found, "f acts 3 rows (3 ms) late"), "{:?}", found.report.notes);
    assert!(found.scene.contains("[effects.delay]\nticks = 3\n"));
}

/// A motor shakes the device where nothing stands.
fn shaken(mut force: impl FnMut(f64) -> f64) -> String {
    let (mass, damping) = (0.5, 3.0);
    let (mut x, mut v) = (0.0, 0.0);
    let mut log = String::from("t,x,f\n");
    for row in 0..500 {
        let time = 1e-3 * f64::from(row);
        let acting = force(time);
        log += &format!("{time:?},{x:?},{acting:?}\n");
        // Exact under a held force.
        let (decay, end) = ((-damping / mass * 1e-3_f64).exp(), -acting / damping);
        x += end * 1e-3 + (v - end) * mass / damping * (1.0 - decay);
        v = end + (v - end) * decay;
    }
    log
}

#[test]
fn without_a_wall_the_scene_has_none() {
    let found = fitted(&shaken(|t| 2.0 * (40.0 * t).sin() + (97.0 * t).cos())).unwrap();
    assert!(says(&found, "no wall") && found.report.wall.is_none());
    assert!((found.report.mass.value - 0.5).abs() < 1e-6);
    assert!((found.report.damping.value - 3.0).abs() < 1e-5);
    assert!(Scene::parse(&found.scene, "found").is_ok());
    assert!(found.scene.contains("[environment.wall]") && found.scene.contains("stiffness = 0.0"));
}

#[test]
fn what_tells_nothing_is_refused_with_a_remedy() {
    let row = |n: u32, x: f64, f: f64| format!("{:?},{x:?},{f:?}\n", 1e-3 * f64::from(n));
    let log = |of: &dyn Fn(u32) -> (f64, f64)| {
        let rows = (0..100).map(of).enumerate();
        rows.fold(String::from("t,x,f\n"), |log, (n, (x, f))| log + &row(n as u32, x, f))
    };
    let cases = [
        (log(&|_| (0.001, 1.0)), "same in all rows"),
        (log(&|n| (1e-3 * f64::from(n), 0.0)), "f is 0 in all rows"),
        (String::from("t,x,f\n0,0,0\n1,1,1\n"), "too few rows"),
        (String::from("t,x,f\n0,0,0\n"), "fewer than two good rows"),
        (log(&|n| (1e-3 * f64::from(n * 7919 % 13), 1e-6)), "does not tell the mass"),
    ];
    for (log, words) in cases {
        let error = fitted(&log).unwrap_err();
        assert!(error.message().contains(words), "{error}");
        assert!(error.help().is_some(), "{error}");
    }
}

#[test]
fn rows_that_cannot_be_read_are_told_where_they_may_be_why() {
    let log = Truth { wall: [0.012, 1000.0, 10.0], ..PLAIN }.log(600, &mut Chance::new(11));
    let with_units = |row: &str| {
        let is_contact = !row.starts_with('t') && !row.ends_with(",0.0");
        if is_contact { format!("{row} N\n") } else { format!("{row}\n") }
    };
    let error = fitted(&log.lines().map(with_units).collect::<String>()).unwrap_err();
    let bad = log.lines().skip(1).filter(|row| !row.ends_with(",0.0")).count();
    let first = log.lines().skip(1).position(|row| !row.ends_with(",0.0")).unwrap() + 2;
    let told = format!("; {bad} rows are bad, the first at line {first}: f is `");
    assert!(error.message().contains("f is 0 in all rows"), "{error}");
    assert!(error.help().is_some_and(|it| it.contains(&told)), "{error}");
}

/// In lasting contact the wall's force bends a larger mass on a larger spring in the same way: 0.3 kg at 200 + 1000 N/m move as
/// 0.25 kg at 1000 N/m.
#[test]
fn a_contact_that_never_ends_is_refused_with_a_remedy() {
    for (damping, encoder) in [(0.0, 0.0), (3.0, 0.0), (10.0, 0.0), (0.0, 1e-6), (10.0, 1e-5)] {
        let pressed =
            Truth { rest: 0.1, wall: [-0.02, 1000.0, damping], encoder, late: 1, ..PLAIN };
        let error = fitted(&pressed.log(800, &mut Chance::new(7))).unwrap_err();
        assert!(error.message().contains("f is the force of one spring and damper"), "{error}");
        assert!(error.help().is_some_and(|it| it.contains("free motion")), "{error}");
        // Contact and free motion tell the mass.
        let tapped = Truth { rest: PLAIN.rest, wall: PLAIN.wall, ..pressed };
        let mass = of(tapped, 800).report.mass;
        assert!((mass.low..=mass.high).contains(&0.3), "{damping} {encoder}: {mass:?}");
    }
}

/// A single short contact in a long log is none that lasts.
#[test]
fn a_short_tap_is_no_feedback() {
    let hard = Truth { wall: [0.0149, 5e4, 0.0], ..PLAIN };
    let log = hard.log(60_000, &mut Chance::new(7));
    let touched = log.lines().filter(|line| !line.ends_with(",0.0")).count() - 1;
    assert!((3..60).contains(&touched), "{touched} rows of contact");
    let mass = fitted(&log).unwrap().report.mass;
    assert!((mass.low..=mass.high).contains(&0.3), "{mass:?}");
}

/// Numbers of any size end in a result or an error.
#[test]
fn hostile_logs_end_without_a_panic() {
    let mut chance = Chance::new(3);
    for size in [1e-45, 1e-9, 1.0, 1e9, 1e45] {
        for force in [1e-40, 1.0, 1e48] {
            let mut log = String::from("t,x,f\n");
            for n in 0..60 {
                let bad = if n % 17 == 5 { "NaN" } else { "" };
                let (x, f) = (size * chance.even(), force * (chance.even() - 0.3));
                log += &format!("{:?},{x:?}{bad},{f:?}\n", 0.1 * f64::from(n));
            }
            let _ = fitted(&log);
        }
    }
}

#[test]
fn gaps_cut_the_log() {
    let log = PLAIN.log(900, &mut Chance::new(5));
    let lines: Vec<_> = log.lines().collect();
    let cut: Vec<_> = lines[..400].iter().chain(&lines[470..]).copied().collect();
    let found = fitted(&cut.join("\n")).unwrap();
    assert_eq!(found.report.stretches, 2);
    assert!(says(&found, "a gap cut the log into 2 stretches"), "{:?}", found.report.notes);
    assert!((found.report.mass.value - 0.3).abs() < 1e-6);
}

/// Two rows that are missing about the largest force leave a few rows between them.
#[test]
fn gaps_about_the_largest_force_mislead_nobody() {
    let log = PLAIN.log(900, &mut Chance::new(5));
    let lines: Vec<_> = log.lines().collect();
    let force = |line: &&str| line.rsplit(',').next().and_then(|it| it.parse::<f64>().ok());
    let forces: Vec<f64> = lines.iter().map(|line| force(line).unwrap_or(0.0)).collect();
    let most = forces.iter().copied().fold(0.0, f64::max);
    let at = forces.iter().position(|it| *it == most).unwrap();
    let missing = [at - 5, at + 5];
    let kept = lines.iter().enumerate().filter(|(line, _)| !missing.contains(line));
    let found = fitted(&kept.map(|(_, line)| *line).collect::<Vec<_>>().join("\n")).unwrap();
    assert_eq!(found.report.stretches, 3);
    for (told, truth) in [(found.report.mass, 0.3), (found.report.damping, PLAIN.damping)] {
        assert!((told.value - truth).abs() < 1e-6 * truth, "{told:?}");
    }
    assert!(!says(&found, "late") && !says(&found, "pushes"), "{:?}", found.report.notes);
}

#[test]
fn a_page_holds_figure_numbers_and_scene() {
    let found: study::Identified = of(PLAIN, 400);
    let page = found.to_html("lyapunov identify log.csv");
    for part in ["<svg", "environment.wall", "identify.toml", "Fitted to log.csv"] {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(found.csv().lines().count(), 8);
}

#[test]
fn axes_that_are_not_read_are_told() {
    let log = PLAIN.log(800, &mut Chance::new(7));
    let (names, rows) = log.split_once('\n').unwrap();
    let rows: String = rows.lines().map(|row| format!("{row},0,0\n")).collect();
    let found = fitted(&format!("{names},y,fy\n{rows}")).unwrap();
    assert!(
        says(&found, "further axes (y, fy): only the first axis is read"),
        "{:?}",
        found.report.notes
    );
}

#[test]
fn bad_rows_stand_in_lines_of_the_page() {
    let log = PLAIN.log(800, &mut Chance::new(7)).replacen("\n", "\n0,0\n0,one,0\n", 1);
    let page = fitted(&log).unwrap().to_html("lyapunov identify log.csv");
    assert!(page.contains(
        "2, left out\nline 2: 2 fields, not 3\nline 3: x is <code>one</code>, no number\n= "
    ));
}
