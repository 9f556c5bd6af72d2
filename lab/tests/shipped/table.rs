//! The table of shipped scenes.

use std::collections::BTreeSet;
use std::fs;

use lyapunov_lab::scene::{Effects, Scalar};
use lyapunov_lab::scenes::SCENES;
use lyapunov_lab::{Rollout, in_space};

use crate::shipped::rows::{edited, folder, scene};

/// Test whether a certain effect is among the effects.
type Has = fn(&Effects) -> bool;

#[test]
fn the_table_lists_the_folder() {
    let files = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let scenes = files.filter(|path| path.extension() == Some("toml".as_ref()));
    let names: BTreeSet<String> =
        scenes.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    assert_eq!(names, SCENES.iter().map(|scene| scene.name.to_owned()).collect());
    assert_eq!(names.len(), SCENES.len());
}

#[test]
fn each_begins_with_its_schema_and_two_lines_of_comment() {
    for scene in SCENES {
        let lines: Vec<&str> = scene.text.lines().take(4).collect();
        assert_eq!(lines[0], "#:schema ./scene.schema.json", "{}", scene.name);
        assert_eq!(scene.comment(), [&lines[1][2..], &lines[2][2..]], "{}", scene.name);
        assert!(lines[2].starts_with("# Look at "), "{}: {}", scene.name, lines[2]);
        assert!(!lines[3].starts_with('#'), "{}: {}", scene.name, lines[3]);
        assert!(scene.comment().iter().all(|line| line.ends_with('.')), "{}", scene.name);
    }
}

#[test]
fn each_runs_to_its_end_within_range_in_both_scalars() {
    for shipped in SCENES {
        let scene = scene(shipped.name);
        for scalar in [Scalar::F64, Scalar::F32] {
            let scene = edited(&scene, |draft| draft.scalar = scalar);
            let rows = in_space!(scene, Axes => Rollout::<Axes>::of(&scene).unwrap().count());
            assert_eq!(rows as u64, scene.ticks() + 1, "{} in {scalar:?}", shipped.name);
        }
    }
}

#[test]
fn each_effect_has_a_scene_of_its_own() {
    let names: [(&str, Has); 11] = [
        ("encoder", |it| it.encoder.is_some()),
        ("delay", |it| it.delay.is_some()),
        ("saturation", |it| it.saturation.is_some()),
        ("filter-cutoff", |it| it.filter.is_some()),
        ("filter-window", |it| it.filter.is_some()),
        ("noise", |it| it.noise.is_some()),
        ("jitter", |it| it.jitter.is_some()),
        ("dropout", |it| it.dropout.is_some()),
        ("friction", |it| it.friction.is_some()),
        ("load", |it| it.load.is_some()),
        ("pulse", |it| it.pulse.is_some()),
    ];
    for (name, has) in names {
        assert!(has(&scene(name).effects), "{name}");
    }
    let environments = SCENES.iter().map(|shipped| scene(shipped.name).environment.name());
    assert_eq!(environments.collect::<BTreeSet<_>>().len(), 11);
}
