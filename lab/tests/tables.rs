//! Tables of stabilizers in scene files: every key, every default, and what is refused.

use std::collections::BTreeSet;

use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::hard::soak::Soak;
use lyapunov_lab::map::{Axis, Grid};
use lyapunov_lab::scene::{Member, Parameter, Spacing};
use lyapunov_lab::scenes::{SCENES, text_of};
use lyapunov_lab::{Rollout, Row, SVector, Scene};

/// A hand of 0.5 kg on 50 N/m that is let go 40 mm before a wall at 250 Hz: it swings through the wall and back.
const LOOP: &str = "
duration = 1.5
servo_rate = 1000.0
environment_rate = 250.0
operator = { mass = 0.2, damping = 0.1, stiffness = 50.0 }
device = { mass = 0.3, damping = 0.25 }
initial.position = -0.04
environment.wall = { position = 0.001, stiffness = 20000.0, damping = 1.0 }
effects.encoder.resolution = 1e-5
";

fn scene(text: &str) -> Scene {
    Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}"))
}

fn rows(scene: &Scene) -> Vec<Row> {
    Rollout::<f64>::of(scene).unwrap().rows().collect()
}

fn members() -> impl Iterator<Item = StabilizerName> {
    Member::ALL.iter().copied().map(StabilizerName::Member)
}

fn tabled(text: &str, name: StabilizerName) -> String {
    format!("{text}\n[stabilizer.{name}]\n")
}

/// The numbers that have a default, by their keys.
fn defaults(parameters: &[Parameter]) -> Vec<(&'static str, f64)> {
    parameters.iter().filter_map(|it| Some((it.name(), it.default?))).collect()
}

/// To the bit: what is left out is what the page says, whether by table, by name, or written out and read back.
#[test]
fn a_default_is_the_number_that_a_table_may_write() {
    for text in [LOOP.to_owned(), format!("{LOOP}effects.delay.ticks = 3\n")] {
        let bare = scene(&text);
        for name in members() {
            let short = scene(&tabled(&text, name));
            let parameters = name.parameters(&short);
            let numbers = defaults(&parameters);
            assert_eq!(numbers.len(), parameters.len(), "{name} lacks a default: {parameters:?}");
            let whole = name.written_in(&short, &numbers).unwrap();
            let written = toml::to_string(&whole).unwrap();
            for (key, _) in &numbers {
                assert!(written.contains(&format!("\n{key} = ")), "{name}.{key}: {written}");
            }
            let ours = rows(&short);
            assert_eq!(ours, rows(&whole), "{name} written out");
            assert_eq!(ours, rows(&scene(&written)), "{name} read back");
            let named = Rollout::<f64>::under(&bare, name).unwrap().rows().collect::<Vec<_>>();
            assert_eq!(ours, named, "{name} by name");
        }
    }
}

/// Numbers below and above the middle of the range to search; without a range a share of the default, or little.
fn others(parameter: &Parameter) -> [f64; 2] {
    let default = parameter.default.unwrap();
    [0.3, 0.7].map(|share: f64| match parameter.search {
        Some(search) => {
            let inner = match search.spacing {
                Spacing::Linear => (1.0 - share) * search.lower + share * search.upper,
                Spacing::Logarithmic => search.lower.powf(1.0 - share) * search.upper.powf(share),
            };
            if parameter.is_whole { inner.round() + 3.0 } else { inner }
        }
        None if default > 0.0 => share * default,
        None => share * 5e-4,
    })
}

/// No key is read and then forgotten.
#[test]
fn every_number_of_a_table_changes_the_run() {
    // Also a wall that gives back late, and one whose force rises at rest.
    let pressed = LOOP.replace("position = -0.04", "position = 0.004").replace("20000.0", "4000.0");
    let swinging = LOOP.replace(
        "environment.wall = { position = 0.001,",
        "environment.moving-wall = { amplitude = 0.005, frequency = 3.0, position = -0.005,",
    );
    // And one into which a pulse presses the hand with much more than the energy of the start.
    let soft = LOOP.replace("position = -0.04", "position = -0.002").replace("20000.0", "500.0");
    let pushed = format!("{soft}effects.pulse = {{ start = 0.3, duration = 0.7, force = 5.0 }}\n");
    for name in members() {
        let mut dead: BTreeSet<&str> =
            name.parameters(&scene(LOOP)).iter().map(Parameter::name).collect();
        for text in [LOOP, &pressed, &swinging, &pushed] {
            let base = scene(&tabled(text, name));
            let usual = rows(&base);
            for parameter in name.parameters(&base) {
                for number in others(&parameter) {
                    // A tank that starts empty has no room for a floor.
                    let Ok(changed) = name.written_in(&base, &[(parameter.name(), number)]) else {
                        continue;
                    };
                    if rows(&changed) != usual {
                        dead.remove(parameter.name());
                    }
                }
            }
        }
        assert!(dead.is_empty(), "{name}: nothing depends on {dead:?}");
    }
}

/// Ends and inside of every range are stabilizers, and the default is one of those that a search should know.
#[test]
fn every_range_is_worth_a_search() {
    let base = scene(LOOP);
    for name in StabilizerName::ALL {
        for parameter in name.parameters(&base) {
            let Some(search) = parameter.search else { continue };
            let (key, default) = (parameter.name(), parameter.default.unwrap());
            assert!(search.lower < search.upper && search.upper.is_finite(), "{name}.{key}");
            assert!(search.lower > 0.0 || search.spacing == Spacing::Linear, "{name}.{key}");
            let is_off = default.is_infinite() || default == 0.0;
            let is_within = (search.lower..=search.upper).contains(&default);
            assert!(is_within || is_off, "{name}.{key}: {default} in {search:?}");
            let [below, above] = others(&parameter);
            for value in [search.lower, below, above, search.upper] {
                let value = if parameter.is_whole { value.round() } else { value };
                let made = name.written_in(&base, &[(key, value)]);
                assert!(made.is_ok(), "{name}.{key} = {value}: {made:?}");
            }
        }
    }
}

/// A scene's own table serves its name in comparisons, and its cap every other name.
#[test]
fn a_name_takes_the_table_of_the_scene() {
    let own =
        scene(&format!("{}start = 2e-3\npower = 0.5\n", tabled(LOOP, "tank".parse().unwrap())));
    let named = |scene: &Scene, name: &str| -> Vec<Row> {
        Rollout::<f64>::under(scene, name.parse().unwrap()).unwrap().rows().collect()
    };
    assert_eq!(rows(&own), named(&own, "tank"));
    assert_ne!(rows(&own), named(&scene(LOOP), "tank"));
    let capped =
        scene(&format!("{LOOP}stabilizer.popc-spread = {{ damping_cap = 0.05, ticks = 9 }}\n"));
    assert_eq!(rows(&capped), named(&capped, "popc-spread"));
    for name in ["popc", "lolc-spring", "popc-rising", "least-norm"] {
        let written = scene(&format!("{LOOP}stabilizer.popc.damping_cap = 0.05\n"));
        assert_eq!(named(&capped, name), named(&written, name), "{name}");
        assert_ne!(named(&capped, name), named(&scene(LOOP), name), "{name}");
    }
}

/// What a wrong table says: the key, its place, the value and what would be right.
#[rustfmt::skip]
const WRONG: &[(&str, &str, &[&str])] = &[
    ("[stabilizer.tank]\nstrat = 1e-3", "stabilizer.tank.strat", &["did you mean `start`", "floor"]),
    ("[stabilizer.tank]\nstart = -1e-3", "stabilizer.tank.start", &["-0.001", "0 or greater", "the unit is J", "start = 1e-3"]),
    ("[stabilizer.tank]\nstart = 1e-3\nfloor = 2e-3", "stabilizer.tank.floor", &["0.002", "0.001", "at most what it starts with"]),
    ("[stabilizer.tank]\nstart = 1e-3\nceiling = 5e-4", "stabilizer.tank.ceiling", &["0.0005", "at least what it starts with"]),
    ("[stabilizer.popc-spread]\nticks = 0", "stabilizer.popc-spread.ticks", &["from 1 to 1000000", "servo ticks"]),
    ("[stabilizer.popc-spread]\nticks = 2.5", "stabilizer.popc-spread.ticks", &["whole number"]),
    ("[stabilizer.popc-bounded]\ncredit = \"1 mJ\"", "stabilizer.popc-bounded.credit", &["a number", "credit = 1e-3"]),
    ("[stabilizer.popc-windowed]\nwindow = 0", "stabilizer.popc-windowed.window", &["greater than 0", "the unit is s"]),
    ("[stabilizer.energy-bounding]\nc1 = 100.0\nc2 = 200.0", "stabilizer.energy-bounding.c2", &["200.0", "100.0", "at most `c1`"]),
    ("[stabilizer.least-norm]\ndecay = 1.5", "stabilizer.least-norm.decay", &["at most 1", "1.5"]),
    ("[stabilizer.iss]\nslope = 0", "stabilizer.iss.slope", &["greater than 0", "N/m"]),
    ("[stabilizer.iss]\nmu = 1.0", "stabilizer.iss.mu", &["slope", "feed"]),
    ("[stabilizer.directed-damping]\ndirection = [1.0, 0.0]", "stabilizer.directed-damping.direction", &["2 numbers", "1 dimension"]),
    ("[stabilizer.directed-damping]\ndirection = 0.0", "stabilizer.directed-damping.direction", &["no direction"]),
    ("[stabilizer.tanc]", "stabilizer.tanc", &["did you mean `tank`"]),
    ("[stabilizer.tank]\n[stabilizer.popc]", "stabilizer", &["only one"]),
];

#[test]
fn a_wrong_table_names_key_place_value_and_remedy() {
    for (table, key, words) in WRONG {
        let fault = Scene::parse(&format!("{LOOP}\n{table}\n"), "test").unwrap_err();
        let shown = fault.to_string();
        assert_eq!(fault.key(), Some(*key), "{shown}");
        assert!(fault.line().is_some(), "{shown}");
        words.iter().for_each(|word| assert!(shown.contains(word), "{word}: {shown}"));
        assert!(shown.lines().all(|line| line.chars().count() <= 120), "{shown}");
    }
}

/// Laws that rely on the device's damping say so where it has none, and take the number that is written instead.
#[test]
fn a_law_without_its_damping_says_what_it_lacks() {
    let bare = LOOP.replace(", damping = 0.25", "");
    for (name, instead) in [
        ("energy-bounding", "c1 = 500.0"),
        ("slope-bound", "slope = 500.0"),
        ("virtual-coupling", "stiffness = 500.0"),
    ] {
        let fault = Scene::parse(&format!("{bare}[stabilizer.{name}]\n"), "test").unwrap_err();
        let shown = fault.to_string();
        assert_eq!(fault.key(), Some("device.damping"), "{shown}");
        assert!(shown.contains(name) && shown.contains("0.0"), "{shown}");
        let written = scene(&format!("{bare}[stabilizer.{name}]\n{instead}\n"));
        assert!(!rows(&written).is_empty());
    }
}

/// In a plane: what works there runs, and what does not is refused by name.
#[test]
fn tables_work_in_a_plane() {
    let plane = "
duration = 0.5
servo_rate = 1000.0
space.dimensions = 2
operator = { mass = 0.1, damping = 0.5, stiffness = 100.0, rest = [0.02, -0.01] }
device = { mass = 0.2, damping = 0.2 }
initial.position = [0.0, 0.01]
environment.plane = { point = [0.0, 0.0], normal = [0.6, 0.8], stiffness = 3000.0, damping = 1.0 }
";
    let mut refused = Vec::new();
    for name in members() {
        match Scene::parse(&tabled(plane, name), "test") {
            Ok(scene) => {
                let ticks: Vec<_> = Rollout::<SVector<f64, 2>>::of(&scene).unwrap().collect();
                assert_eq!(ticks.len(), 501, "{name}");
            }
            Err(fault) => {
                assert_eq!(fault.key(), Some(&*format!("stabilizer.{name}")), "{fault}");
                assert!(fault.to_string().contains("one dimension only"), "{fault}");
                refused.push(name.name());
            }
        }
    }
    let lines = [
        "popc-contact-reset",
        "popc-reference",
        "memory-based",
        "reference-following",
        "path-memory",
    ];
    assert_eq!(refused, lines);
}

/// The damping of a plane's device acts along the plane's normal, and nowhere else.
#[test]
fn directed_damping_takes_the_normal_of_a_plane() {
    let text = "
duration = 0.5
servo_rate = 1000.0
space.dimensions = 2
device = { mass = 0.2 }
operator = { mass = 0.1, stiffness = 100.0, rest = [-0.01, -0.01] }
initial.position = [0.0, 0.01]
environment.plane = { point = [0.0, 0.0], normal = [0.6, 0.8], stiffness = 30000.0 }
[stabilizer.directed-damping]
";
    let ticks = Rollout::<SVector<f64, 2>>::of(&scene(text)).unwrap();
    let mut acted = 0;
    for tick in ticks {
        let added = tick.command - tick.environment;
        let across = added.x * 0.8 - added.y * 0.6;
        assert!(across.abs() <= 1e-12 * (1.0 + added.norm()), "{across}");
        acted += usize::from(added.norm() > 0.1);
    }
    assert!(acted > 10, "{acted}");
}

/// On a line there is one direction, and damping along it is POPC.
#[test]
fn directed_damping_on_a_line_is_popc() {
    let rows = |name: &str| -> Vec<Row> {
        Rollout::<f64>::under(&scene(LOOP), name.parse().unwrap()).unwrap().rows().collect()
    };
    let (directed, popc) = (rows("directed-damping"), rows("popc"));
    // Rounding errors grow; the first contact is at 0.157 s.
    for (one, other) in directed.iter().zip(&popc).take(300) {
        assert!(
            (one.f_out - other.f_out).abs() <= 1e-6 * (1.0 + one.f_out.abs()),
            "{one:?} {other:?}"
        );
    }
    assert!(popc.iter().take(300).any(|row| row.alpha > 0.0));
}

/// Every key of a table below `path`, with its value; whole numbers as others.
fn leaves(path: &str, value: &toml::Value) -> Vec<(String, String)> {
    match value {
        toml::Value::Table(table) => {
            let below =
                table.iter().flat_map(|(key, value)| leaves(&format!("{path}.{key}"), value));
            below.collect()
        }
        toml::Value::Integer(number) => vec![(path.to_owned(), format!("{:?}", *number as f64))],
        toml::Value::Array(each) => {
            let below = each.iter().flat_map(|value| leaves(path, value));
            below.collect()
        }
        other => vec![(path.to_owned(), other.to_string())],
    }
}

#[test]
fn a_scene_that_is_written_has_every_key_that_was_read() {
    for shipped in SCENES.iter().filter(|it| it.name != "motion-file") {
        let written = toml::Value::try_from(scene(shipped.text)).unwrap();
        let written = leaves("", &written);
        let read: toml::Table = shipped.text.parse().unwrap();
        for leaf in leaves("", &toml::Value::Table(read)) {
            assert!(written.contains(&leaf), "{}: {leaf:?} is not in {written:?}", shipped.name);
        }
    }
}

#[test]
fn a_scene_that_is_written_is_read_as_it_was() {
    let soak = Soak { seed: 3, stabilizer: None };
    let plane = text_of("plane").unwrap();
    let directed = |of: &str, direction: &str| {
        scene(&format!("{of}\n[stabilizer.directed-damping]\ndirection = {direction}\n"))
    };
    let made = (0..300).map(|case| soak.scene(case).unwrap());
    for scene in made.chain([directed(LOOP, "-2.0"), directed(plane, "[0.6, 0.8]")]) {
        let text = toml::to_string(&scene).unwrap();
        // With what it left to the defaults.
        let again = Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        assert_eq!(toml::to_string(&again).unwrap(), text);
        if let Some(table) = text.split_once("direction = ") {
            assert!(table.1.starts_with("-2.0") || table.1.starts_with("[0.6, 0.8]"), "{text}");
        }
    }
}

/// An axis of a map: numbers of a table that the scene has, written or not, whole or not.
#[test]
fn a_number_of_a_table_makes_an_axis() {
    let base = scene(&tabled(LOOP, "popc-spread".parse().unwrap()));
    let axis = |text: &str| text.parse::<Axis>().unwrap();
    let grid = |x: &str, y: &str| {
        Grid::new(
            base.clone(),
            axis(x),
            axis(y),
            ["popc-spread".parse::<StabilizerName>().unwrap()],
        )
    };
    let ticks = "stabilizer.popc-spread.ticks=2..6:3";
    let cells = grid(ticks, "stabilizer.popc-spread.damping_cap=0.1..0.4:2").unwrap();
    let written =
        scene(&format!("{LOOP}stabilizer.popc-spread = {{ ticks = 4, damping_cap = 0.4 }}\n"));
    assert_eq!(rows(&cells.scene_of(4).unwrap()), rows(&written));
    let halves = grid("stabilizer.popc-spread.ticks=2..3:3", "device.mass=0.1..0.2:2").unwrap();
    let said = halves.scene_of(1).unwrap_err();
    assert!(said.to_string().contains("whole number"), "{said}");
    let said = grid("stabilizer.tank.start=1e-4..1e-3:3", ticks).unwrap_err().to_string();
    assert!(said.contains("stabilizer.tank.start"), "{said}");
}
