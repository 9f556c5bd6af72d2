//! Signs of a mistake: each on a scene and on a log made to show it, and none on sound ones.

use std::f64::consts::TAU;
use std::fmt::Write;

use lyapunov::{Correction, PortSample, Stabilizer};
use lyapunov_lab::compare::{Comparison, Entrants};
use lyapunov_lab::explain::Explanation;
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::observe::{Settings, observe};
use lyapunov_lab::{
    Csv, Oddity, Rollout, Row, Scene, Sign, Space, Summary, Verdict, in_space, scenes,
};

use crate::bound::systems::{Chance, scene};

pub(crate) fn summary<V: Space>(scene: &Scene) -> Summary {
    Summary::of(scene, Rollout::<V>::of(scene).unwrap())
}

pub(crate) fn of_run(scene: &Scene) -> Vec<Oddity> {
    in_space!(scene, Axes => summary::<Axes>(scene)).look_at()
}

/// The log of the run of `scene`, and whether it is complete and does not grow.
fn log(scene: &Scene) -> (String, bool) {
    let mut csv = Csv::of(Vec::new(), scene).unwrap();
    let mut summary = Summary::new(scene);
    for tick in Rollout::<f64>::of(scene).unwrap() {
        csv.write(&tick).unwrap();
        summary.add(&tick);
    }
    let text = String::from_utf8(csv.into_inner().unwrap()).unwrap();
    (text, summary.verdict() != Verdict::Grows)
}

fn of_log(log: &str, columns: &str, scales: &[&str]) -> Vec<Oddity> {
    let settings = Settings {
        columns: columns.parse().unwrap(),
        scales: scales.iter().map(|scale| scale.parse().unwrap()).collect(),
        ..Settings::default()
    };
    observe(log.as_bytes(), "made.csv", &settings).unwrap().report.look_at
}

/// The one sign, and every word in its text.
#[track_caller]
pub(crate) fn shows(signs: &[Oddity], sign: Sign, words: &[&str]) {
    let [found] = signs else { panic!("{signs:?}") };
    assert_eq!(found.sign, sign, "{found:?}");
    for word in words {
        assert!(found.text.contains(word), "{word}: {found:?}");
    }
}

const PRESS: [(&str, &str); 8] = [
    ("duration", "2.0"),
    ("servo_rate", "1000.0"),
    ("device", "{ mass = 0.2, damping = 2.0 }"),
    ("operator", "{ mass = 0.1, damping = 2.0, stiffness = 100.0, rest = 0.006 }"),
    ("initial", "{ position = -0.004 }"),
    ("environment", "{ wall = { stiffness = 800.0, damping = 1.0 } }"),
    ("stabilizer", "{ popc = {} }"),
    ("effects", "{}"),
];

/// A hand that presses on a soft wall; `changed` takes the place of these values, and nothing takes the key away.
pub(crate) fn press(changed: &[(&str, &str)]) -> Scene {
    let value = |(key, value): &(&'static str, &'static str)| {
        let changed = changed.iter().find(|it| it.0 == *key);
        (*key, changed.map_or(value.to_string(), |it| it.1.to_owned()))
    };
    let lines = PRESS.iter().map(value).filter(|it| !it.1.is_empty());
    scene(&lines.map(|(key, value)| format!("{key} = {value}\n")).collect::<String>())
}

#[test]
fn a_made_scene_shows_each_sign() {
    let told =
        |key, value, sign, words: &[&str]| shows(&of_run(&press(&[(key, value)])), sign, words);
    assert_eq!(of_run(&press(&[])), []);
    let reversed = Sign::Reversed;
    told("environment", "{ spring = { stiffness = -800.0 } }", reversed, &["-800 N/m", "100 N/m"]);
    let drives = "{ mass-spring-damper = { stiffness = 800.0, damping = -6.0 } }";
    told("environment", drives, reversed, &["damping is -6 N.s/m", "burn 4"]);
    let unit = Sign::Unit;
    told("device", "{ mass = 200.0 }", unit, &["device.mass is 200 kg", "in g?"]);
    let soft = "{ wall = { stiffness = 0.8 } }";
    told("environment", soft, unit, &["environment.wall.stiffness is 0.8 N/m", "in N/mm?"]);
    told("initial", "{ position = -4.0 }", unit, &["4.006 m", "in mm?"]);
    let fast = "{ position = -0.004, velocity = 150.0 }";
    told("initial", fast, unit, &["initial.velocity is 150 m/s", "in mm/s?"]);
    told("effects", "{ encoder = { resolution = 0.01 } }", unit, &["resolution is 0.01 m", "mm?"]);
    told("effects", "{ saturation = { force = 4e-4 } }", unit, &["force is 4e-4 N", "in kN?"]);
    let far = "{ mass = 0.1, damping = 2.0, stiffness = 100.0, motion = { kind = \"sine\", amplitude = 6.0, frequency = 0.1 } }";
    told("operator", far, unit, &["to operator.motion.amplitude are 6.004 m", "in mm?"]);
    // A spring or a damper of 0 gives nothing of its own; a damper that pushes along does.
    for (parts, told) in [
        ("stiffness = 80.0, damping = 0.0", 0),
        ("stiffness = 0.0, damping = 1.0", 0),
        ("stiffness = 80.0, damping = -0.1", 1),
    ] {
        let coupled = press(&[
            ("environment", &format!("{{ mass-spring-damper = {{ {parts} }} }}")),
            ("stabilizer", "{ virtual-coupling = {} }"),
        ]);
        let found =
            of_run(&coupled).into_iter().filter(|it| it.text.contains("passive environment"));
        assert_eq!(found.count(), told, "{parts}");
    }
    // What is just as large as a bound is not beyond it, and 0 is no other unit.
    let even = "{ mass-spring-damper = { stiffness = 800.0, damping = -4.0 } }";
    for (key, value, words) in [
        ("environment", even, "burn"),
        ("environment", "{ wall = { stiffness = 0.0 } }", "in N/mm"),
        ("initial", "{ velocity = 20.0 }", "initial.velocity"),
    ] {
        let found = of_run(&press(&[(key, value)]));
        assert!(found.iter().all(|it| !it.text.contains(words)), "{found:?}");
    }
    let away = "{ wall = { position = 20.0, stiffness = 800.0 } }";
    told("environment", away, Sign::Untouched, &["all 2001 ticks", "surface is at 20000 mm"]);
    let lost = "{ dropout = { probability = 1.0, seed = 1, policy = \"hold\" } }";
    told("effects", lost, Sign::Idle, &["effects.dropout.probability is 1"]);
    let late = of_run(&press(&[("duration", "0.5"), ("effects", "{ delay = { ticks = 900 } }")]));
    shows(&late, Sign::Idle, &["f_act is 0 on all 501 ticks", "the delay is 900 ticks"]);
    let slow = of_run(&press(&[("servo_rate", "1.0"), ("duration", "60.0")]));
    assert!(slow.iter().any(|it| it.text.contains("servo_rate is 1 Hz")), "{slow:?}");
}

/// A damper in contact only, of either sign.
struct Damper(f64);

impl Stabilizer<f64> for Damper {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let alpha = if effort > 0.5 { self.0 } else { 0.0 };
        Correction { alpha, ..Correction::none(effort + alpha * sample.velocity) }
    }
}

#[test]
fn a_stabilizer_of_the_wrong_sign_or_without_effect_is_told() {
    let under = |scene: &Scene, damping: f64| {
        let rollout = Rollout::stabilized_by(scene, Damper(damping)).unwrap();
        Summary::of(scene, rollout).look_at()
    };
    let bare = press(&[]);
    assert_eq!(under(&bare, 3.0), []);
    shows(&under(&bare, -3.0), Sign::Reversed, &["along the motion", "mJ"]);
    let clipped = press(&[("effects", "{ saturation = { force = 0.01 } }")]);
    shows(&under(&clipped, 3.0), Sign::Idle, &["saturation of 0.01 N"]);
}

/// Friction and jitter ship with a wall out of reach, and the line says so.
#[test]
fn no_shipped_scene_looks_wrong() {
    for shipped in scenes::SCENES.iter().filter(|it| it.name != "motion-file") {
        let signs = of_run(&scene(shipped.text));
        match shipped.name {
            "friction" | "jitter" => shows(&signs, Sign::Untouched, &["surface is at 500 mm"]),
            name => assert_eq!(signs, [], "{name}"),
        }
    }
    let log = include_str!("../../scenes/logs/mujoco-wall.csv");
    assert_eq!(of_log(log, "t,x,f", &[]), []);
}

/// Random scene of sound numbers about a hand and a device.
fn sound(chance: &mut Chance) -> Scene {
    let rate = chance.decades(100.0, 5000.0).round();
    let (stiffness, damping) = (chance.decades(20.0, 5e4), chance.within(0.0, 20.0));
    let (place, kind) = (chance.within(-0.02, 0.02), chance.whole(0, 3));
    // Pressed by 100 N at most, or on its way to a wall.
    let pressed = (100.0 / stiffness).min(0.1);
    let [low, high] =
        if kind > 1 && chance.happens(0.5) { [-0.1, 0.0] } else { [-pressed, pressed] };
    let mut text = format!(
        "duration = 1\nservo_rate = {rate}\ndevice = {{ mass = {}, damping = {} }}\n\
         operator = {{ mass = {}, damping = {}, stiffness = {}, rest = {} }}\n\
         initial = {{ position = {}, velocity = {} }}\n",
        chance.decades(0.02, 5.0),
        chance.within(0.0, 2.0),
        chance.within(0.0, 2.0),
        chance.within(0.0, 5.0),
        chance.decades(5.0, 500.0),
        chance.within(-0.05, 0.05),
        place + chance.within(low, high),
        chance.within(-0.5, 0.5),
    );
    text += &match kind {
        0 => format!("environment.spring = {{ position = {place}, stiffness = {stiffness} }}\n"),
        1 => format!(
            "environment.mass-spring-damper = {{ position = {place}, stiffness = {stiffness}, damping = {damping} }}\n"
        ),
        _ => format!(
            "environment.wall = {{ position = {place}, stiffness = {stiffness}, damping = {damping} }}\n"
        ),
    };
    if chance.happens(0.3) {
        text += &format!("effects.delay.ticks = {}\n", chance.whole(1, 4));
    }
    if chance.happens(0.3) {
        text += &format!("effects.encoder.resolution = {}\n", chance.decades(1e-7, 1e-4));
    }
    if chance.happens(0.3) {
        text += &format!("effects.saturation.force = {}\n", chance.decades(1.0, 100.0));
    }
    if chance.happens(0.3) {
        text += "effects.filter.window = 8\n";
    }
    text += ["", "stabilizer.popc = {}\n", "stabilizer.lolc = {}\n"][chance.whole(0, 2) as usize];
    scene(&text)
}

/// Also as a log, in which only what grows may leave what a hand does.
#[test]
fn no_sound_random_scene_looks_wrong() {
    let mut chance = Chance::new(17);
    let (mut untouched, mut logs) = (0, 0);
    for _ in 0..500 {
        let scene = sound(&mut chance);
        let touches = Rollout::<f64>::of(&scene).unwrap().rows().any(|row: Row| row.f_env != 0.0);
        let signs = of_run(&scene);
        let (log, bounded) = log(&scene);
        let in_log = of_log(&log, "t,x_measured,f_act", &[]);
        if touches {
            assert_eq!(signs, [], "{scene:?}");
        } else {
            untouched += 1;
            assert_eq!((signs.len(), in_log.len()), (1, 1), "{scene:?}");
            assert_eq!([signs[0].sign, in_log[0].sign], [Sign::Untouched; 2]);
        }
        if touches && bounded {
            logs += 1;
            assert_eq!(in_log, [], "{scene:?}");
        }
    }
    assert!((20..200).contains(&untouched) && logs > 200, "{untouched} {logs}");
}

/// A swing of 20 mm at 1 Hz into a wall of 400 N/m and 2 N·s/m, sampled at 1 kHz.
fn swing(force: impl Fn(f64, f64) -> f64) -> String {
    let mut text = String::from("t,x,f\n");
    for n in 0..3000 {
        let t = f64::from(n) * 1e-3;
        let (x, v) = (0.02 * (TAU * t).sin(), 0.02 * TAU * (TAU * t).cos());
        writeln!(text, "{t},{x},{}", force(x, v)).unwrap();
    }
    text
}

#[test]
fn a_made_log_shows_each_sign() {
    let wall = |x: f64, v: f64| if x > 0.0 { (400.0 * x + 2.0 * v).max(0.0) } else { 0.0 };
    let log = swing(wall);
    let told =
        |scale: &str, sign, words: &[&str]| shows(&of_log(&log, "t,x,f", &[scale]), sign, words);
    assert_eq!(of_log(&log, "t,x,f", &[]), []);
    told("f=-1", Sign::Reversed, &["f falls by 400 N/m of x", "--scale f=-1"]);
    told("x=-1", Sign::Reversed, &["--scale f=-1"]);
    told("x=1e3", Sign::Unit, &["x runs from -20 to 20 m", "--scale x=1e-3"]);
    told("x=1e6", Sign::Unit, &["--scale x=1e-6"]);
    told("t=1e3", Sign::Unit, &["t steps by 1 s", "--scale t=1e-3"]);
    told("t=1e6", Sign::Unit, &["t steps by 1000 s", "--scale t=1e-6"]);
    told("f=1e-3", Sign::Unit, &["--scale f=1e3"]);
    told("f=1e3", Sign::Unit, &["--scale f=1e-3"]);
    let alone = |force: &dyn Fn(f64, f64) -> f64| of_log(&swing(force), "t,x,f", &[]);
    shows(&alone(&|_, _| 0.0), Sign::Untouched, &["all 3000 rows"]);
    shows(&alone(&|_, v| -2.0 * v), Sign::Reversed, &["2 N.s/m of v"]);
    let still: String = (0..50).map(|n| format!("{}e-3,0.5,3\n", n)).collect();
    shows(&of_log(&format!("t,x,f\n{still}"), "t,x,f", &[]), Sign::Idle, &["all 50 rows"]);
    // A jump is told with its place, whichever its cause; one out and back is a bad reading.
    let moved = |rows: std::ops::Range<usize>, by: f64| {
        changed(&log, |row, x, f| (if rows.contains(&row) { x + by } else { x }, f))
    };
    let lasting = of_log(&moved(314..320, -0.9), "t,x,f", &[]);
    shows(&lasting, Sign::Unit, &["faster than any hand", "at 0.314 s"]);
    let jump = of_log(&moved(313..314, 0.9), "t,x,f", &[]);
    shows(&jump, Sign::Reading, &["x jumps by ", "mm for one row at t = 0.313 s", "a bad reading"]);
    let small = of_log(&moved(700..701, -0.004), "t,x,f", &[]);
    shows(&small, Sign::Reading, &["x jumps by -4.", "mm for one row at t = 0.7 s"]);
    assert_eq!(of_log(&moved(700..701, -0.0005), "t,x,f", &[]), []);
}

/// A log with position and force of each row changed.
fn changed(log: &str, change: impl Fn(usize, f64, f64) -> (f64, f64)) -> String {
    let row = |(at, line): (usize, &str)| {
        let fields: Vec<f64> = line.split(',').map(|it| it.parse().unwrap()).collect();
        let (x, f) = change(at, fields[1], fields[2]);
        format!("{},{x},{f}\n", fields[0])
    };
    format!("t,x,f\n{}", log.lines().skip(1).enumerate().map(row).collect::<String>())
}

/// The wall is touched in less than half of the rows, and a clipped force or one at rest is no offset.
#[test]
fn a_force_that_is_never_0_is_told() {
    let wall = |x: f64| (400.0 * (x - 0.005)).max(0.0);
    for offset in [0.3, -0.3] {
        let log = swing(|x, _| wall(x) + offset);
        let told = format!("f is {} mN in ", 1e3 * offset);
        shows(&of_log(&log, "t,x,f", &[]), Sign::Reading, &[&told, "an offset? subtract it"]);
    }
    assert_eq!(of_log(&swing(|x, _| wall(x)), "t,x,f", &[]), []);
    assert_eq!(of_log(&swing(|x, _| (400.0 * (x + 0.03)).min(6.0)), "t,x,f", &[]), []);
    let away = swing(|x, _| 400.0 * (x + 0.03));
    let rests = changed(&away, |row, x, f| if row < 500 { (x, f) } else { (0.001, 12.4) });
    assert_eq!(of_log(&rests, "t,x,f", &[]), []);
}

/// Rows of a log, and the log of them.
fn of_rows<'a>(rows: impl Iterator<Item = [&'a str; 3]>) -> Vec<Oddity> {
    let text: String = rows.map(|row| row.join(",") + "\n").collect();
    of_log(&format!("t,x,f\n{text}"), "t,x,f", &[])
}

#[test]
fn a_force_that_does_not_act_from_its_row_on_is_told() {
    for rate in ["1000.0", "3000.0"] {
        let bouncing = press(&[
            ("servo_rate", rate),
            ("device", "{ mass = 0.12, damping = 0.05 }"),
            ("operator", "{ mass = 0.15, damping = 0.7, stiffness = 120.0, rest = 0.006 }"),
            ("initial", "{ position = -0.011 }"),
            ("environment", "{ wall = { stiffness = 1200.0, damping = 3.0 } }"),
            ("stabilizer", ""),
        ]);
        let (text, _) = log(&bouncing);
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
        let place = |name: &str| heads.iter().position(|head| *head == name).unwrap();
        let places = [place("t"), place("x"), place("f_act")];
        let rows: Vec<[&str; 3]> = lines
            .map(|line| {
                let fields: Vec<&str> = line.split(',').collect();
                places.map(|at| fields[at])
            })
            .collect();
        assert_eq!(of_rows(rows.iter().copied()), []);
        let every = if rate == "1000.0" { 10 } else { 30 };
        let few = of_rows(rows.iter().copied().step_by(every));
        shows(&few, Sign::Hold, &["straight from row to row", "one row for each tick"]);
        // The force that acted before its position was read.
        let before = rows.windows(2).map(|it| [it[1][0], it[1][1], it[0][2]]);
        shows(
            &of_rows(before),
            Sign::Hold,
            &["acted until its row", "from its row until the next"],
        );
    }
}

#[test]
fn a_given_threshold_above_every_force_is_told() {
    let log = swing(|x, _| (500.0 * x).max(0.0));
    let settings = Settings { contact: Some(50.0), ..Settings::default() };
    let report = observe(log.as_bytes(), "made.csv", &settings).unwrap().report;
    shows(&report.look_at, Sign::Untouched, &["f is at most 10 N", "--contact is 50 N"]);
    assert!(report.to_string().contains("  look at     f is at most 10 N"));
    let json = serde_json::to_value(&report).unwrap();
    assert_eq!(json["look_at"][0]["sign"], "untouched");
}

#[test]
fn a_wall_that_is_never_reached_gets_no_remedies() {
    let stiff = |place: &str| {
        let wall = format!("{{ wall = {{ position = {place}, stiffness = 9e4 }} }}");
        let scene = press(&[("environment", &wall), ("stabilizer", "")]);
        Explanation::of::<f64>(&scene).unwrap()
    };
    let reached = stiff("0.0");
    assert!(!reached.remedies.is_empty() && reached.look_at.is_empty());
    let away = stiff("0.5");
    assert!(away.limits.spectral_radius.unwrap() > 1.0);
    assert_eq!(away.remedies, []);
    shows(&away.look_at, Sign::Untouched, &["surface is at 500 mm"]);
    let text = away.to_string();
    assert!(text.contains("  look at      f_env is 0") && text.contains("no force acts"), "{text}");
    assert!(!text.contains("what helps") && !text.contains("nothing that was tried"), "{text}");
    let json: serde_json::Value = serde_json::from_str(&away.to_json("away")).unwrap();
    assert_eq!(
        (&json["look_at"][0]["sign"], json["remedies"].as_array().map(Vec::len)),
        (&"untouched".into(), Some(0))
    );
}

#[test]
fn a_comparison_tells_a_sign_once_for_all() {
    let away = press(&[("environment", "{ wall = { position = 0.5, stiffness = 800.0 } }")]);
    let entrants = Entrants::<f64>::of(StabilizerNames::standard().on(&away));
    let comparison = Comparison::of("away", &away, &entrants).unwrap();
    let text = comparison.to_string();
    assert_eq!(text.matches("look at: f_env is 0 on all 2001 ticks").count(), 1, "{text}");
    let json = lyapunov_lab::compare::document(&[comparison], &[]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let told = &json["scenes"][0]["look_at"];
    assert_eq!((&told[0]["sign"], told.as_array().unwrap().len()), (&"untouched".into(), 1));
    assert!(told[0]["stabilizers"].as_array().unwrap().len() > 2);
}
