//! The summary of the shipped scenes and of scenes with further keys.

use approx::abs_diff_eq;
use std::fs;
use std::path::Path;

use crate::cli::place::{Place, SCENE};
use crate::cli::said::Said;

/// File that one of the shipped scenes reads.
const MOTION: &str = include_str!("../../../scenes/motion-file.csv");

#[test]
fn the_summary_has_one_form() {
    let said = Place::with_scene().run(["run", "scene.toml"]);
    said.ended(0, &[]);
    let lines: Vec<&str> = said.out.lines().collect();
    assert_eq!(lines[0], "scene.toml");
    assert_eq!(lines[1], "  run          10 s at 100 Hz");
    assert_eq!(lines[2], "  wall         8000 N/m, 2 N.s/m");
    let stabilizer = "LOLC: mass-spring-damper, held work, damping cap 0.5 m / T, 15 N.s/m";
    assert_eq!(lines[3], format!("  stabilizer   {stabilizer}"));
    let rest = ["verdict", "peak force", "energy", "observed", "controller"];
    assert_eq!(lines.len(), 4 + rest.len(), "{}", said.out);
    for (line, label) in lines[4..].iter().zip(rest) {
        assert!(line.starts_with(&format!("  {label:<13}")), "{line}");
    }
}

#[test]
fn the_shipped_scenes_fit_the_terminal() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let entries = fs::read_dir(folder).unwrap().map(|it| it.unwrap());
    let mut scenes: Vec<_> =
        entries.filter(|it| it.path().extension() == Some("toml".as_ref())).collect();
    scenes.sort_by_key(fs::DirEntry::file_name);
    assert!(scenes.len() >= 35);
    for scene in scenes {
        let place = Place::new();
        place.put(scene.file_name(), fs::read(scene.path()).unwrap());
        place.put("motion-file.csv", MOTION);
        let said = place.run(["run".as_ref(), scene.file_name().as_os_str()]);
        said.ended(0, &["run", "verdict", "peak force", "energy"]);
        said.fits();
    }
}

#[test]
fn values_other_than_the_defaults_are_reported() {
    let place = Place::new();
    let scene = SCENE
        .replace("duration = 10.0", "duration = 2.5\nscalar = \"f32\"\nvelocity = \"exact\"")
        .replace("servo_rate = 100.0", "servo_rate = 1000\nenvironment_rate = 100")
        .replace("damping_cap = 0.5", "damping_cap = inf")
        .replace("work = \"held\"", "work = \"sampled\"");
    let effects = "[effects]\nencoder.resolution = 1e-5\ndelay.ticks = 2\nsaturation.force = 8";
    place.put("scene.toml", format!("{scene}\n{effects}\n"));
    let said = place.run(["run", "scene.toml"]);
    said.ended(
        0,
        &[
            "run 2.5 s at 1000 Hz, environment at 100 Hz, exact velocity, in f32",
            "LOLC: mass-spring-damper, sampled work, no damping cap",
            "effects encoder 1e-5 m, delay 2 ticks, saturation 8 N",
        ],
    );
    said.fits();
}

#[test]
fn an_integrator_other_than_exact_is_reported() {
    for (keys, words) in [
        ("integrator = \"rk4\"\nsteps_per_tick = 4", "environment at 20 Hz, rk4 in 4 steps wall"),
        (
            "integrator = \"dop853\"\ntolerance = 1e-9",
            "environment at 20 Hz, dop853 within 1e-9 wall",
        ),
    ] {
        let keys = format!("environment_rate = 20\n{keys}\nduration = 10.0");
        said_of("duration = 10.0", &keys, "").ended(0, &[words]);
    }
}

#[test]
fn without_an_operator_s_spring_the_speed_is_judged() {
    let place = Place::new();
    place.put_scene("scene.toml", "stiffness = 50.0", "stiffness = 0.0");
    let words = ["verdict settles: up to 0 mm/s", "by speed, as no spring of the operator pulls"];
    place.run(["run", "scene.toml"]).ended(0, &words);
}

#[test]
fn a_run_too_short_to_judge_says_so() {
    let words = ["verdict too short: 0.97 s is less than two swings of 0.4867 s"];
    said_of("duration = 10.0", "duration = 0.97", "").ended(0, &words);
    let delay = "[effects.delay]\nticks = 99";
    let words = ["verdict too short: 1000 ticks, and twenty answers of the environment take 2000"];
    said_of("stiffness = 8000.0\ndamping = 2.0", "stiffness = 0.0", delay).ended(0, &words);
}

/// The summary of a scene with `tables` in place of the stabilizer.
fn said_of(from: &str, to: &str, tables: &str) -> Said {
    let place = Place::new();
    place.put("scene.toml", format!("{}\n{tables}\n", SCENE.replacen(from, to, 1)));
    let said = place.run(["run", "scene.toml"]);
    said.fits();
    said
}

#[test]
fn effects_are_reported_in_words() {
    let cases = [
        ("[effects.delay]\nticks = 1", "effects delay 1 tick"),
        ("[effects.filter]\nwindow = 1", "effects window 1 tick"),
        ("[effects.friction]\ncoulomb = 0.5", "effects friction 0.5 N verdict"),
        (
            "[effects.friction]\ncoulomb = 0.5\nstatic = 1\nstribeck_velocity = 0.01",
            "effects friction 0.5 N, 1 N at rest",
        ),
        (
            "[operator.grip]\ntimes = [1]\nstiffness = [10]\ndamping = [1]",
            "operator grip changes 1 time stabilizer",
        ),
    ];
    for (tables, words) in cases {
        said_of("", "", tables).ended(0, &[words]);
    }
}

#[test]
fn a_scene_that_starts_where_it_rests_is_not_judged_by_its_start() {
    let pulse = "[effects.pulse]\nstart = 9.99\nduration = 0.01\nforce = 1";
    let said = said_of("position = -0.004", "position = 0", pulse);
    said.ended(0, &["verdict grows: up to", "by speed, as it starts where it rests"]);
}

#[test]
fn forces_and_energy_in_space_are_those_of_all_axes() {
    let place = Place::new();
    // A fall along y onto a floor, with a drift along x that nothing stops.
    let scene = "duration = 1.0\nservo_rate = 1000.0\nspace.dimensions = 2\ndevice.mass = 0.2\n\
                 initial.position = [0, 0.01]\ninitial.velocity = [0.1, -0.1]\n\
                 [environment.plane]\npoint = [0, 0]\nnormal = [0, 1]\nstiffness = 500.0\ndamping = 200.0\n";
    place.put("scene.toml", scene);
    let said = place.run(["run", "scene.toml", "--csv", "rows.csv"]);
    said.ended(0, &["in 2 dimensions"]);
    let rows = place.text("rows.csv");
    let mut lines = rows.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|it| *it == name).unwrap();
    let (y, force) = (column("y"), column("y_f_act"));
    let numbers: Vec<(f64, f64)> = lines
        .map(|line| line.split(',').map(|it| it.parse().unwrap()).collect::<Vec<f64>>())
        .map(|row| (row[y], row[force]))
        .collect();
    let energy: f64 = numbers.windows(2).map(|pair| pair[0].1 * (pair[1].0 - pair[0].0)).sum();
    let peak = numbers.iter().fold(0.0f64, |most, row| most.max(row.1.abs()));
    assert!(energy > 0.5e-3 && peak > 1.0, "{energy} J, {peak} N");
    let told = |label: &str| {
        let line = said.out.lines().find(|line| line.trim_start().starts_with(label)).unwrap();
        line[15..].split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    assert!(
        abs_diff_eq!(told("energy"), 1e3 * energy, epsilon = 1e-3 * 1e3 * energy),
        "{}",
        said.out
    );
    assert!(abs_diff_eq!(told("peak force"), peak, epsilon = 1e-3 * peak), "{}", said.out);
}

/// A hand of 200 N/m that presses on 1 kN/m: Coulomb's 0.5 N holds anywhere within 0.5 / 1200 m of the balance at 10/3 mm.
#[test]
fn a_plant_that_friction_holds_outside_its_band_is_said_to_stand() {
    let place = Place::new();
    let scene = "duration = 4\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 0.1 }\n\
        operator = { mass = 0.1, damping = 2, stiffness = 200, rest = 0.01 }\n\
        environment.wall = { position = 0.002, stiffness = 1000, damping = 1 }\n";
    place.put("free.toml", scene);
    place.put("stuck.toml", scene.to_owned() + "effects.friction.coulomb = 0.5\n");
    place
        .run(["run", "stuck.toml", "--csv", "rows.csv"])
        .ended(0, &["verdict swinging", "friction of up to 0.5 N holds it there since t = 0.11"]);
    let rows = place.text("rows.csv");
    let place_of = |row: &str| row.split(',').nth(1).and_then(|x| x.parse::<f64>().ok()).unwrap();
    let away = (place_of(rows.lines().last().unwrap()) - 0.01 / 3.0).abs();
    assert!(away > 1.667e-4 && away < 0.5 / 1200.0, "{away}");
    let free = place.run(["run", "free.toml"]);
    free.ended(0, &["verdict settles"]);
    assert!(!free.out.contains("friction"), "{}", free.out);
}
