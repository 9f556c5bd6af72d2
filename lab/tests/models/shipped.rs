//! The model files that ship.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use approx::abs_diff_eq;
use lyapunov_lab::Verdict;
use lyapunov_lab::compare::{Compared, Names};
use lyapunov_lab::models::{Comparison, Entrant, Model, Score, schema_text};
use lyapunov_lab::scene::Positive;
use serde_json::Value;

pub(crate) const NAMES: [&str; 6] = [
    "van-der-pol",
    "inverted-pendulum",
    "dc-motor",
    "admittance-device",
    "two-link-arm",
    "prosthetic-leg",
];

pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/models/{name}.toml"))
}

pub(crate) fn model(name: &str) -> Model {
    Model::load(&path(name)).unwrap_or_else(|fault| panic!("{fault}"))
}

pub(crate) fn compared(model: &Model) -> Comparison {
    Comparison::of("test", model, &Names::default(), &|_| ControlFlow::Continue(())).unwrap()
}

/// V at every tick under `entrant`.
pub(crate) fn curve(comparison: &Comparison, entrant: Entrant) -> Vec<f64> {
    let (_, points) = comparison.curves().find(|(it, _)| *it == entrant).unwrap();
    points.iter().map(|(_, value)| *value).collect()
}

#[test]
fn every_plant_has_a_shipped_file_and_every_file_a_plant() {
    let folder = path("").parent().unwrap().to_owned();
    let entries = fs::read_dir(folder).unwrap().map(|it| it.unwrap().file_name());
    let mut found: Vec<_> = entries.map(|name| name.to_string_lossy().into_owned()).collect();
    found.sort();
    let files = NAMES.iter().map(|name| format!("{name}.toml"));
    let mut expected: Vec<_> = files.chain(["model.schema.json".to_owned()]).collect();
    expected.sort();
    assert_eq!(found, expected);
    for name in NAMES {
        assert_eq!(model(name).plant.name(), name);
    }
}

#[test]
fn a_rendered_mass_other_than_that_of_v_is_told() {
    let started = |derivative: &str| {
        let text = fs::read_to_string(path("admittance-device")).unwrap();
        assert!(text.contains("derivative = -5.0") && text.contains("wanted_mass = 0.2"), "{text}");
        let text = text.replace("derivative = -5.0", derivative);
        compared(&Model::parse(&text, "test").unwrap()).sheet().start
    };
    assert!(!started("derivative = -5.0").contains("renders"));
    let told = started("derivative = -2.0");
    assert!(told.ends_with("V has a mass of 0.2 kg, the controller renders 0.5 kg"), "{told}");
    assert!(started("").ends_with("the controller renders none"));
}

#[test]
fn the_schema_is_what_the_command_prints_and_takes_every_file() {
    let file = fs::read_to_string(path("x").with_file_name("model.schema.json")).unwrap();
    assert_eq!(file, schema_text(), "lyapunov schema model > scenes/models/model.schema.json");
    let schema: Value = serde_json::from_str(&file).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    for name in NAMES {
        let text = fs::read_to_string(path(name)).unwrap();
        assert!(text.starts_with("#:schema ./model.schema.json\n"), "{name}");
        let json = serde_json::to_value(toml::from_str::<toml::Value>(&text).unwrap()).unwrap();
        let faults: Vec<_> = validator.iter_errors(&json).map(|it| it.to_string()).collect();
        assert!(faults.is_empty(), "{name}: {faults:?}");
    }
    let bad: toml::Value = toml::from_str("duration = 1.0\nplant.van-der-pol.mu = -1.0").unwrap();
    assert!(!validator.is_valid(&serde_json::to_value(bad).unwrap()));
}

/// Bounds that each example, and the comment of its model file, claims of its loop.
#[test]
fn loops_are_bounded_where_their_examples_say_so() {
    for name in NAMES {
        let comparison = compared(&model(name));
        let bounded: Vec<bool> =
            comparison.scores().map(|score| score.verdict.is_bounded()).collect();
        // No effort acts on the oscillator, so the energy of its port shows nothing.
        let by_port = name != "van-der-pol";
        assert_eq!(bounded, [false, by_port, true, true], "{name}");
        let [none, .., decrease, decay] = &comparison.scores().collect::<Vec<_>>()[..] else {
            panic!("{name}: {comparison}");
        };
        assert_eq!((none.active, none.taken, none.shortfall), (0.0, Some(0.0), Some(0.0)));
        // The decrease keeps V at about its start; the decay asks for more.
        let began = comparison.began;
        assert!(decrease.end.unwrap() > 0.9 * began, "{name}");
        assert!(decay.end.unwrap() < 0.5 * began, "{name}");
    }
}

/// Both scalars agree where the loop does not run away.
#[test]
fn single_precision_agrees() {
    for name in NAMES {
        let mut single = model(name);
        single.scalar = lyapunov_lab::scene::Scalar::F32;
        single.check().unwrap();
        let (single, double) = (compared(&single), compared(&model(name)));
        for (one, other) in single.scores().zip(double.scores()).skip(2) {
            assert_eq!(one.verdict, other.verdict, "{name} {}", one.stabilizer);
            assert!(one.verdict.is_bounded(), "{name} {}", one.stabilizer);
            let (one, other) = (one.largest.unwrap(), other.largest.unwrap());
            assert!(
                abs_diff_eq!(one / other, 1.0, epsilon = 1e-3),
                "{name}: {one} against {other}"
            );
        }
    }
}

/// A delay of 0 and a controller at the servo rate are the defaults.
#[test]
fn neutral_values_change_nothing() {
    let text = fs::read_to_string(path("dc-motor")).unwrap();
    let said = text.replace("7.54506", "7.54506\nhold = 1\ndelay = 0\nderivative = 0");
    assert_ne!(said, text);
    let (one, other) = (Model::parse(&text, "").unwrap(), Model::parse(&said, "").unwrap());
    assert_eq!(compared(&one).csv(), compared(&other).csv());
}

#[test]
fn a_run_that_leaves_the_range_has_no_numbers_of_its_end() {
    let mut model = model("dc-motor");
    model.duration = Positive::new(60.0).unwrap();
    model.check().unwrap();
    let comparison = compared(&model);
    let none = comparison.scores().next().unwrap();
    assert_eq!(none.verdict, Verdict::Grows);
    assert_eq!((none.largest, none.end, none.effort), (None, None, None));
    let rest = |score: &Score| score.verdict.is_bounded() && score.end.is_some();
    assert!(comparison.scores().skip(1).all(rest));
    assert!(!comparison.csv().contains("inf") && !comparison.csv().contains("NaN"));
}
