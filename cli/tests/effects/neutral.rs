//! Effects at their neutral values, which give the same bytes as their absence.

use crate::effects::run::csv_of;

const STABILIZERS: [&str; 9] = [
    "",
    "[stabilizer.popc]\nwork = \"held\"",
    "[stabilizer.popc]\nwork = \"sampled\"",
    "[stabilizer.lolc]\nwork = \"held\"",
    "[stabilizer.lolc]\nwork = \"sampled\"",
    "[stabilizer.lolc]\ncandidate = \"device-damping\"\nwork = \"held\"",
    "[stabilizer.lolc]\ncandidate = \"device-damping\"\nwork = \"sampled\"",
    "[stabilizer.lolc]\ncandidate = \"spring\"\nwork = \"held\"",
    "[stabilizer.lolc]\ncandidate = \"spring\"\nwork = \"sampled\"",
];

/// Numbers with many digits, so that one rounding more or less shows.
const BASE: &str =
    "[device]\nmass = 0.2\ndamping = 0.013\n[initial]\nposition = -0.0037\nvelocity = 0.011\n";

const OPERATOR: &str = "[operator]\nmass = 0.1\ndamping = 0.21\nstiffness = 51.3\nrest = 0.0007\n";

const WALL: &str = "[environment.wall]\nposition = 0.0003\nstiffness = 8000.1\ndamping = 2.3\n";

#[track_caller]
fn same(one: &str, other: &str, motion: Option<&str>) {
    for scalar in ["f64", "f32"] {
        for rates in ["", "environment_rate = 173.1\n"] {
            for stabilizer in STABILIZERS {
                let scene = |tables: &str| {
                    format!(
                        "duration = 0.7\nservo_rate = 519.3\nscalar = \"{scalar}\"\n{rates}{BASE}{tables}\n{stabilizer}\n"
                    )
                };
                let bytes = |tables: &str| {
                    csv_of(&scene(tables), motion).unwrap_or_else(|error| panic!("{error}"))
                };
                assert!(bytes(one) == bytes(other), "{}\nis not\n{}", scene(one), scene(other));
            }
        }
    }
}

/// Asserts that `table` changes nothing, on one mass and on two.
#[track_caller]
fn neutral(table: &str) {
    for link in ["", "[link]\nstiffness = 3000.7\ndamping = 0.4\n"] {
        let absent = format!("{WALL}{OPERATOR}{link}");
        same(&absent, &format!("{absent}{table}"), None);
    }
}

#[track_caller]
fn reduces(environment: &str, simpler: &str) {
    same(&format!("{OPERATOR}{environment}"), &format!("{OPERATOR}{simpler}"), None);
}

#[test]
fn ports() {
    neutral("[effects.delay]\nticks = 0");
    neutral("[effects.noise]\ndeviation = 0\nseed = 5");
    neutral("[effects.filter]\nwindow = 1");
}

#[test]
fn dropout() {
    neutral("[effects.dropout]\nprobability = 0\nseed = 5\npolicy = \"hold\"");
    neutral("[effects.dropout]\nprobability = 0\nseed = 5\npolicy = \"zero\"");
}

#[test]
fn pushes() {
    neutral("[effects.load]\nforce = 0");
    neutral("[effects.load]\nforce = -0.0");
    neutral("[effects.pulse]\nforce = 0\nstart = 0.1\nduration = 0.2");
    neutral("[effects.pulse]\nforce = 3\nstart = 0.1\nduration = 0");
}

#[test]
fn jitter() {
    neutral("[effects.jitter]\ndeviation = 0\nseed = 5");
    neutral(
        "[effects.jitter]\ndeviation = 0\nseed = 5\n[operator.grip]\ntimes = []\nstiffness = []\ndamping = []",
    );
}

#[test]
fn friction() {
    neutral("[effects.friction]\ncoulomb = 0");
    neutral("[effects.friction]\ncoulomb = 0\nstatic = 0\nstribeck_velocity = 0.01");
}

#[test]
fn motion() {
    let rest = 0.0007;
    neutral(&format!("[operator.motion]\nkind = \"step\"\nat = 0.2\nto = {rest}"));
    neutral(&format!("[operator.motion]\nkind = \"ramp\"\nat = 0.2\nto = {rest}\nrate = 1"));
    neutral("[operator.motion]\nkind = \"ramp\"\nat = 0.2\nto = 4\nrate = 0");
    neutral("[operator.motion]\nkind = \"sine\"\namplitude = 0\nfrequency = 3.3");
    neutral("[operator.motion]\nkind = \"sine\"\namplitude = 0.01\nfrequency = 0");
    let file = "[operator.motion]\nkind = \"file\"\npath = \"recorded/hand.csv\"";
    let absent = format!("{WALL}{OPERATOR}");
    let motion = "t,rest\n0.1,0.0007\n0.3,0.0007\n0.7,0.0007\n";
    same(&absent, &format!("{absent}{file}"), Some(motion));
}

#[test]
fn grip() {
    neutral("[operator.grip]\ntimes = []\nstiffness = []\ndamping = []");
    neutral(
        "[operator.grip]\ntimes = [0, 0.11, 0.3]\nstiffness = [51.3, 51.3, 51.3]\ndamping = [0.21, 0.21, 0.21]",
    );
    neutral("[operator.grip]\ntimes = [99]\nstiffness = [5000]\ndamping = [2]");
}

#[test]
fn walls() {
    let wall = "position = 0.0003\nstiffness = 8000.1\ndamping = 2.3\n";
    for motion in ["amplitude = 0\nfrequency = 7.7\n", "amplitude = 0.01\nfrequency = 0\n"] {
        let moving = format!("[environment.moving-wall]\n{wall}{motion}");
        // At frequency 0 the wall stands still, whatever its amplitude.
        reduces(&moving, WALL);
    }
    for (depth, lower) in [("0.0001", "8000.1"), ("0", "8000.1"), ("9", "3")] {
        let layered = format!(
            "[environment.layered-wall]\nposition = 0.0003\nstiffness = [8000.1, {lower}]\ndamping = 2.3\ndepth = {depth}\n"
        );
        reduces(&layered, WALL);
    }
    reduces(
        "[environment.layered-wall]\nposition = 0.0003\nstiffness = [5, 8000.1]\ndamping = 2.3\ndepth = 0\n",
        WALL,
    );
    reduces(
        "[environment.hunt-crossley]\nposition = 0.0003\nstiffness = 8000.1\nexponent = 1\n",
        "[environment.wall]\nposition = 0.0003\nstiffness = 8000.1\n",
    );
}

#[test]
fn springs() {
    let spring = "[environment.spring]\nposition = 0.0003\nstiffness = 410.7\n";
    let varying = "[environment.varying-spring]\nposition = 0.0003\nstiffness = 410.7\n";
    reduces(&format!("{varying}amplitude = 0\nfrequency = 7.7\n"), spring);
    reduces(&format!("{varying}amplitude = 90\nfrequency = 0\n"), spring);
    reduces("[environment.mass-spring-damper]\nposition = 0.0003\nstiffness = 410.7\n", spring);
}

/// The neutral values in two dimensions, with a solid.
#[test]
fn several_axes() {
    let base = |rest: &str| {
        format!(
            "[environment.sphere]\ncenter = [0.003, 0.001]\nradius = 0.002\nstiffness = 900\ndamping = 0.3\n[operator]\nmass = 0.1\nstiffness = 51.3\nrest = {rest}\n"
        )
    };
    let absent = base("[0.0007, 0.002]");
    for table in [
        "[operator.motion]\nkind = \"sine\"\namplitude = 0\nfrequency = 3.3",
        "[operator.motion]\nkind = \"step\"\nto = 0.0007",
        "[operator.grip]\ntimes = [0.2]\nstiffness = [51.3]\ndamping = [0]",
        "[effects.load]\nforce = 0",
        "[effects.noise]\ndeviation = 0\nseed = 1",
        "[effects.jitter]\ndeviation = 0\nseed = 1",
        "[effects.dropout]\nprobability = 0\nseed = 1\npolicy = \"zero\"",
        "[effects.filter]\nwindow = 1",
    ] {
        let space = "space.dimensions = 2";
        let scene = |tables: &str, stabilizer: &str, scalar: &str| {
            let base =
                BASE.replace("-0.0037", "[-0.0037, 0.0002]").replace("0.011", "[0.07, 0.01]");
            format!(
                "duration = 0.7\nservo_rate = 519.3\nscalar = \"{scalar}\"\n{space}\n{base}{tables}\n{stabilizer}\n"
            )
        };
        for (stabilizer, scalar) in
            STABILIZERS.into_iter().flat_map(|it| [(it, "f64"), (it, "f32")])
        {
            let bytes = |tables: &str| csv_of(&scene(tables, stabilizer, scalar), None).unwrap();
            assert!(
                bytes(&absent) == bytes(&format!("{absent}{table}")),
                "{table} {scalar} {stabilizer}"
            );
        }
    }
}

/// Rates may fail to divide each other by a billionth, which does not add up in the environment's time.
#[test]
fn rates_within_their_tolerance() {
    let wall = format!(
        "[environment.moving-wall]\nstiffness = 800\namplitude = 0.001\nfrequency = 9.7\n{OPERATOR}"
    );
    let bytes = |rate: &str| {
        let head = format!("duration = 20\nservo_rate = 1000\nenvironment_rate = {rate}\n");
        csv_of(&format!("{head}{BASE}{wall}"), None).unwrap()
    };
    assert!(bytes("100") == bytes("100.000000005"));
}
