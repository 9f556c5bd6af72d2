//! Teleoperator files that are refused, and the words of the refusal.

use lyapunov_lab::Scene;
use lyapunov_lab::models::Model;
use lyapunov_lab::teleoperation::Teleoperator;

use crate::teleoperation::shipped::{NAMES, text};

/// A part of the file with a varying delay, its replacement, the key at fault, and words of the message.
#[rustfmt::skip]
const CASES: &[(&str, &str, &str, &[&str])] = &[
    ("mass = 0.3", "mass = -0.3", "master.mass",
        &["must be finite and greater than 0, not -0.3", "the unit is kg", "mass = 0.3"]),
    ("hand_stiffness = 100.0\n", "", "master.hand_stiffness", &["missing key", "in N/m"]),
    ("hand_stiffness", "hand_stifness", "master.hand_stifness", &["did you mean `hand_stiffness`?"]),
    ("start = -0.01", "start = 0", "master.start", &["stores 0.0 J", "above 0 and finite", "`start = -0.01`"]),
    ("start = -0.01", "start = -1e-170", "master.start", &["stores 0.0 J", "`hand_stiffness = 100.0`"]),
    ("start = -0.01", "start = 1e200", "master.start", &["stores inf J", "above 0 and finite"]),
    ("hand_stiffness = 100.0", "hand_stiffness = 1e308", "master.hand_stiffness",
        &["beyond the range of f64", "master.hand_stiffness is 1e308"]),
    ("damping = 1.0\nhand", "damping = 1e308\nhand", "master.damping", &["master.damping is 1e308"]),
    ("[slave]\nmass = 0.3\ndamping = 1.0", "[slave]\nmass = 0.3\ndamping = 1e308", "slave.damping", &["slave.damping is 1e308"]),
    ("start = -0.01", "start = nan", "master.start", &["must be finite, not NaN"]),
    ("start = -0.01", "start = -0.01\nstart = 0.01", "master.start", &["given twice"]),
    ("position = -0.005", "position = -0.02", "slave.wall.position",
        &["starts at -0.01 m, within the wall at -0.02 m", "at -0.01 m or beyond"]),
    ("stiffness = 2000.0, position", "stiffness = 3.1e5, position", "slave.wall.stiffness",
        &["within a tick or two", "at most mass · servo_rate² = 300000.0 N/m"]),
    ("stiffness = 2000.0, position", "position", "slave.wall.stiffness", &["missing key"]),
    ("stiffness = 2000.0, position", "stiffness = 2000.0, damping = 1.0, position", "slave.wall.damping",
        &["unknown key `damping` in [slave.wall]"]),
    ("[coordination]\nstiffness = 200.0\ndamping = 2.0\n", "", "coordination.stiffness", &["there is no [coordination]"]),
    ("stiffness = 200.0\ndamping = 2.0", "stiffness = 200.0\n# without [stabilizer.wave-variables]", "coordination.damping",
        &["as their impedance, and it is 0", "damping = 5.0", "`impedance = 5.0`"]),
    ("delay = 10", "delay = 1025", "channel.delay", &["from 0 to 1024, not 1025"]),
    ("spread = 40", "spread = -1", "channel.spread", &["from 0 to 1024, not -1"]),
    ("seed = 1", "seed = -1", "channel.seed", &["0 or more"]),
    ("seed = 1\n", "", "channel.seed", &["is random", "seed = 1"]),
    ("seed = 1", "seed = 1\nloss = 1.5", "channel.loss", &["from 0 to 1, not 1.5"]),
    ("damping_cap = 0.5", "damping_cap = nan", "stabilizer.damping_cap", &["0 or greater"]),
    ("speed = 0.02", "speed = -1", "stabilizer.drift-compensated.speed", &["0 or greater", "m/s"]),
    ("impedance = 8.0", "impedance = 0", "stabilizer.wave-variables.impedance", &["greater than 0"]),
    ("impedance = 8.0", "filter_time = -1", "stabilizer.wave-variables.filter_time", &["0 or greater", "the unit is s"]),
    ("wave-variables.impedance = 8.0", "two-layer.share = 1.5", "stabilizer.two-layer.share", &["at most 1"]),
    ("wave-variables.impedance = 8.0", "two-layer.level = 0", "stabilizer.two-layer.level", &["greater than 0"]),
    ("wave-variables.impedance = 8.0", "two-layer.gain = inf", "stabilizer.two-layer.gain", &["finite"]),
    ("wave-variables.impedance = 8.0", "two-layers.gain = 1", "stabilizer.two-layers", &["did you mean `two-layer`?"]),
    ("duration = 5.0", "duration = 1e9", "duration", &["a run has at most 1e9 ticks"]),
    ("servo_rate = 1000.0", "servo_rate = 1e-320", "servo_rate", &["too small"]),
    ("mass = 0.3", "mass = 1e-320", "master.mass", &["beyond the range of f64"]),
    ("servo_rate = 1000.0", "servo_rate = 1000.0\nscalar = \"f32\"\nstabilizer.wave-variables.impedance = 1e-60",
        "stabilizer.wave-variables.impedance", &["f32"]),
];

#[test]
fn a_fault_is_named_with_its_key_its_place_and_its_remedy() {
    let file = text("varying-delay");
    for (from, to, key, words) in CASES {
        assert!(file.contains(from), "{from}");
        let mut text = file.replacen(from, to, 1);
        if to.contains("stabilizer.wave") {
            text = text.split("[stabilizer]").next().unwrap().to_owned();
        }
        let fault = Teleoperator::parse(&text, "test.toml").expect_err(to);
        let shown = fault.to_string();
        assert_eq!(fault.key(), Some(*key), "{shown}");
        assert!(fault.line().is_some() && !fault.help().is_empty(), "{shown}");
        let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        for word in *words {
            assert!(unfolded.contains(word), "no {word:?} in:\n{shown}");
        }
        for line in shown.lines().skip(1) {
            assert!(line.chars().count() <= 100, "too wide: {line}");
        }
    }
    let empty = Teleoperator::parse("", "test.toml").unwrap_err().to_string();
    assert!(empty.contains("the smallest teleoperator is") && empty.contains("[coordination]"));
}

#[test]
fn kinds_of_files_are_distinguished() {
    for name in NAMES {
        let text = text(name);
        assert!(Teleoperator::is_in(&text) && !Model::is_in(&text));
        let fault = Scene::parse(&text, name).unwrap_err().to_string();
        assert!(fault.contains("a teleoperator, not a scene"), "{fault}");
        assert!(fault.contains("lyapunov compare"), "{fault}");
    }
    for scene in lyapunov_lab::scenes::SCENES {
        assert!(!Teleoperator::is_in(scene.text), "{}", scene.name);
    }
}
