//! Numbers that stay: what every shipped scene gave, to the bit, in `scenes/golden.csv`.
//!
//! `cargo test -p lyapunov-lab --test library -- --ignored golden` writes the file anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use lyapunov_lab::scene::Scalar;
use lyapunov_lab::scenes::SCENES;
use lyapunov_lab::{Rollout, Scene, Summary, in_space, row_numbers};

use crate::shipped::rows::{edited, folder, scene};

const HEADS: &str = "scene,scalar,rows,bits,verdict,settled,absorbed,observed_energy_least,\
                     observed_energy_most,injected,shortfall,environment_peak,acting_peak,active";

fn file() -> PathBuf {
    folder().join("golden.csv")
}

/// FNV-1a.
pub(crate) fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    let next = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
    bytes.into_iter().fold(0xCBF2_9CE4_8422_2325, next)
}

/// The hash of the bits of every number of every row.
fn bits(scene: &Scene) -> u64 {
    in_space!(scene, Axes => {
        let numbers = Rollout::<Axes>::of(scene).unwrap().flat_map(|tick| row_numbers(&tick).collect::<Vec<_>>());
        hash(numbers.flat_map(|number| number.to_bits().to_le_bytes()))
    })
}

/// What a scene gives in both scalars, as lines of the file, with the digits that tell every `f64` apart.
fn lines() -> Vec<String> {
    let line = |name: &str, scalar: Scalar| {
        let scene = edited(&scene(name), |draft| draft.scalar = scalar);
        let run =
            in_space!(scene, Axes => Summary::of(&scene, Rollout::<Axes>::of(&scene).unwrap()));
        let settled = run.settled.map_or(String::new(), |time| format!("{time:?}"));
        let numbers = [
            run.absorbed,
            run.observed_energy_least,
            run.observed_energy_most,
            run.asked,
            run.shortfall,
            run.environment_peak,
            run.acting_peak,
        ]
        .map(|number| format!("{number:?}"))
        .join(",");
        let (word, rows, active) = (run.verdict().word(), run.rows, run.active);
        let scalar = format!("{scalar:?}").to_lowercase();
        let bits = bits(&scene);
        format!("{name},{scalar},{rows},{bits:016x},{word},{settled},{numbers},{active}")
    };
    SCENES
        .iter()
        .flat_map(|it| [Scalar::F64, Scalar::F32].map(|scalar| line(it.name, scalar)))
        .collect()
}

#[test]
fn every_scene_gives_what_it_gave() {
    let kept = fs::read_to_string(file()).expect("scenes/golden.csv");
    let mut kept = kept.lines();
    assert_eq!(kept.next(), Some(HEADS), "the columns of scenes/golden.csv");
    let key = |line: &str| line.splitn(3, ',').take(2).collect::<Vec<_>>().join(" in ");
    let kept: BTreeMap<String, &str> = kept.map(|line| (key(line), line)).collect();
    let lines = lines();
    let changed: Vec<String> = lines
        .iter()
        .filter(|line| kept.get(&key(line)) != Some(&line.as_str()))
        .map(|line| {
            let before = kept.get(&key(line)).unwrap_or(&"nothing");
            format!("{}\n  gave  {before}\n  gives {line}", key(line))
        })
        .collect();
    assert!(
        changed.is_empty(),
        "{}\n{} of {} lines of scenes/golden.csv differ. A change is a decision with a page: docs/decisions/0072",
        changed.join("\n"),
        changed.len(),
        lines.len()
    );
    assert_eq!(kept.len(), lines.len(), "scenes/golden.csv has scenes that are not shipped");
}

#[test]
#[ignore = "writes scenes/golden.csv; a change there is a decision with a page"]
fn golden_numbers_are_written() {
    fs::write(file(), [vec![HEADS.to_owned()], lines(), vec![String::new()]].concat().join("\n"))
        .expect("scenes/golden.csv is written");
}
