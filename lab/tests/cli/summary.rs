//! What the summary says of the shipped scenes and of those with more in them.

use std::fs;
use std::path::Path;

use crate::place::{Place, SCENE};

#[test]
fn the_summary_has_one_form() {
    let said = Place::with_scene().run(["run", "scene.toml"]);
    said.ended(0, &[]);
    let lines: Vec<&str> = said.out.lines().collect();
    assert_eq!(lines[0], "scene.toml");
    assert_eq!(lines[1], "  run          10 s at 100 Hz");
    assert_eq!(lines[2], "  wall         8000 N/m, 2 N.s/m");
    let stabilizer = "LOLC: mass-spring-damper, held work, damping cap 0.5 m / T";
    assert_eq!(lines[3], format!("  stabilizer   {stabilizer}"));
    let rest = ["settled", "peak force", "energy", "observer", "controller"];
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
    assert!(scenes.len() >= 6);
    for scene in scenes {
        let place = Place::new();
        place.put(scene.file_name(), fs::read(scene.path()).unwrap());
        let said = place.run(["run".as_ref(), scene.file_name().as_os_str()]);
        said.ended(0, &["run", "settled", "peak force", "energy"]);
        said.fits();
    }
}

#[test]
fn what_is_not_the_default_is_told() {
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
fn a_plant_that_nothing_pulls_has_nowhere_to_settle() {
    let place = Place::new();
    place.put_scene("scene.toml", "stiffness = 50.0", "stiffness = 0.0");
    place.run(["run", "scene.toml"]).ended(0, &["without an operator's spring"]);
}
