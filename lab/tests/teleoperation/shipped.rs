//! The teleoperator files that ship.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use lyapunov_lab::Verdict;
use lyapunov_lab::compare::{Compared, Names};
use lyapunov_lab::scene::Scalar;
use lyapunov_lab::teleoperation::{Comparison, Score, Teleoperator, schema_text};
use serde_json::Value;

pub(crate) const NAMES: [&str; 3] = ["constant-delay", "varying-delay", "lossy"];

pub(crate) fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/teleoperation/{name}.toml"))
}

pub(crate) fn text(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap()
}

pub(crate) fn parsed(text: &str) -> Teleoperator {
    Teleoperator::parse(text, "test.toml").unwrap_or_else(|fault| panic!("{fault}"))
}

pub(crate) fn compared(file: &Teleoperator) -> Comparison {
    Comparison::of("test", file, &Names::default(), &|_| ControlFlow::Continue(())).unwrap()
}

pub(crate) fn scores(comparison: &Comparison) -> [Score; 8] {
    comparison.scores().copied().collect::<Vec<_>>().try_into().unwrap()
}

#[test]
fn the_schema_is_what_the_command_prints_and_takes_every_file() {
    let folder = path("x").parent().unwrap().to_owned();
    let entries = fs::read_dir(&folder).unwrap().map(|it| it.unwrap().file_name());
    assert_eq!(entries.count(), NAMES.len() + 1);
    let file = fs::read_to_string(folder.join("teleoperation.schema.json")).unwrap();
    assert_eq!(file, schema_text(), "lyapunov schema teleoperation > …/teleoperation.schema.json");
    let schema: Value = serde_json::from_str(&file).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    for name in NAMES {
        let text = text(name);
        assert!(text.starts_with("#:schema ./teleoperation.schema.json\n"), "{name}");
        let json = serde_json::to_value(toml::from_str::<toml::Value>(&text).unwrap()).unwrap();
        let faults: Vec<_> = validator.iter_errors(&json).map(|it| it.to_string()).collect();
        assert!(faults.is_empty(), "{name}: {faults:?}");
        let bad = text.replacen("mass = 0.3", "mass = -0.3", 1);
        let bad = serde_json::to_value(toml::from_str::<toml::Value>(&bad).unwrap()).unwrap();
        assert!(!validator.is_valid(&bad));
    }
}

/// The claims in the comments of the files and in docs/teleoperation.md, in both scalars.
#[test]
fn the_loop_alone_swings_up_and_the_others_hold() {
    for name in NAMES {
        for scalar in [Scalar::F64, Scalar::F32] {
            let mut file = parsed(&text(name));
            file.scalar = scalar;
            file.check().unwrap();
            let rows = scores(&compared(&file));
            let verdicts = rows.map(|row| row.verdict);
            assert_eq!(verdicts[0], Verdict::Grows, "{name} in {scalar:?}");
            assert!(verdicts[1..].iter().all(|it| it.is_bounded()), "{name} in {scalar:?}");
            let [_, alone, joined, compensated, ..] = rows.map(|row| row.drift.unwrap().abs());
            assert!(alone > 1.5 * joined && joined > compensated, "{name}: {rows:?}");
            let [_, alone, joined, ..] = rows.map(|row| row.shortfall.unwrap());
            assert!(alone > 2.0 * joined, "{name}: {rows:?}");
        }
    }
}

/// The ports generate energy, and leave a shortfall, only within the first seconds: at rest no debt arises, with or
/// without compensation.
#[test]
fn debts_do_not_grow_with_time() {
    for name in NAMES {
        let text = text(name);
        let longer = text.replace("duration = 5.0", "duration = 60.0");
        assert_ne!(longer, text);
        let [short, long] = [text, longer].map(|text| scores(&compared(&parsed(&text))));
        for (short, long) in short.iter().zip(&long).skip(1) {
            assert_eq!(long.shortfall, short.shortfall, "{name}: {}", long.stabilizer);
            let (given, before) = (long.given.unwrap(), short.given.unwrap());
            assert!(given <= before + 1e-6, "{name}: {} {given} {before} mJ", long.stabilizer);
            if let (Some(kept), Some(before)) = (long.kept, short.kept) {
                assert!(kept >= before - 1e-6, "{name}: {} {kept} {before} mJ", long.stabilizer);
            }
            assert_eq!(long.verdict, Verdict::Settles, "{name}: {}", long.stabilizer);
        }
    }
}

/// What the page says of the two-layer row's damper: a master that has it of its own needs nothing else.
#[test]
fn a_damper_of_that_size_settles_by_itself() {
    let text = text("constant-delay").replacen("damping = 1.0", "damping = 11.2", 1);
    let file = parsed(&text);
    let added = file.layers().gain * file.layers().level;
    assert!((added - 10.2).abs() < 1e-12, "{added} N.s/m");
    let [none, ..] = scores(&compared(&file));
    let (end, ideal) = (none.felt_end.unwrap(), file.ideal_force());
    assert!(
        none.verdict.is_bounded() && (end - ideal).abs() < 1e-4 && none.speed.unwrap() < 1e-3,
        "{none:?}"
    );
}

/// A neutral channel equals an absent one, and compensation without a speed equals the plain two-port.
#[test]
fn neutral_values_change_nothing() {
    let text = text("constant-delay").replace("drift-compensated.speed = 0.02\n", "");
    let absent = text.replace("[channel]\ndelay = 20\n", "");
    assert_ne!(absent, text);
    let said = format!("{absent}[channel]\ndelay = 0\nspread = 0\nloss = 0\nseed = 7\n");
    let [absent, said] = [absent, said].map(|text| compared(&parsed(&text)));
    assert_eq!(absent.sheet().csv, said.sheet().csv);
    let [_, _, joined, compensated, ..] = scores(&said);
    assert_eq!(joined, Score { stabilizer: joined.stabilizer, ..compensated });
    // Impedances that match by themselves, and filters without a time.
    let matched =
        text.replace("impedance = 8.0", "impedance = 2.0\nwave-variables.filter_time = 0");
    let [.., waves, matched, filtered] = scores(&compared(&parsed(&matched)));
    assert_eq!(waves, Score { stabilizer: waves.stabilizer, ..matched });
    assert_eq!(waves, Score { stabilizer: waves.stabilizer, ..filtered });
}

#[test]
fn a_run_is_a_function_of_its_file_and_its_seed() {
    let text = text("lossy");
    let csv = |text: &str| compared(&parsed(text)).sheet().csv;
    assert_eq!(csv(&text), csv(&text));
    assert_ne!(csv(&text), csv(&text.replace("seed = 1", "seed = 2")));
}
