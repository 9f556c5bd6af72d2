//! Motion that leaves the range of the scalar, which is a result and no error.

use std::fs;

use crate::cli::place::Place;

const STIFF: &str = include_str!("../../../scenes/paper-50k-none.toml");

#[rustfmt::skip]
const CASES: &[(&str, &str, &[&str])] = &[
    ("duration = 10.0", "duration = 150.0",
        &["cut short after t = 110.23 s: the motion left the range of f64", "verdict grows: it left the range",
            "energy over 1.797e308 mJ came out"]),
    ("duration = 10.0", "scalar = \"f32\"\nduration = 100.0", &["cut short after t = ", "left the range of f32"]),
    ("position = -0.004", "position = 1e308", &["cut short at t = 0 s, before the first row"]),
    ("position = -0.004", "velocity = 1e308", &["cut short after t = 0 s"]),
    ("position = -0.004", "position = -1e308", &["verdict"]),
    ("stiffness = 50000.0", "stiffness = 1e300", &["cut short after t = ", "wall 1e300 N/m"]),
    ("stiffness = 50.0", "stiffness = 1e10", &["verdict"]),
    ("stiffness = 50.0", "stiffness = 5e-324", &["verdict"]),
    ("stiffness = 50.0", "rest = 1e308\nstiffness = 50", &["verdict"]),
    ("mass = 0.2", "mass = 1e308", &["verdict"]),
    ("mass = 0.2", "mass = 5e-324", &["verdict"]),
    ("duration = 10.0", "duration = 5e-324", &["run 4.94065646e-324 s", "verdict too short"]),
    ("duration = 10.0\nservo_rate = 100.0", "duration = 1e-3\nservo_rate = 1e8", &["run 0.001 s at 1e8 Hz"]),
    ("servo_rate = 100.0", "servo_rate = 1e-300", &["verdict too short"]),
];

#[test]
fn rows_end_where_the_range_does_and_the_terminal_says_when() {
    let place = Place::new();
    for (from, to, words) in CASES {
        assert!(STIFF.contains(from), "{from}");
        let scene = STIFF.replacen(from, to, 1);
        for stabilizer in ["", "[stabilizer.popc]", "[stabilizer.lolc]\ndamping_cap = inf"] {
            place.put("scene.toml", format!("{scene}\n{stabilizer}\n"));
            let said = place.run(["run", "scene.toml", "--csv", "rows.csv"]);
            // Only the bare wall is sure to run away.
            said.ended(0, if stabilizer.is_empty() { words } else { &["verdict"] });
            said.fits();
            assert!(!said.out.contains("NaN") && !said.out.contains("inf"), "{}", said.out);
            sound(&place.text("rows.csv"), &format!("{to} {stabilizer}"));
            fs::remove_file(place.path("rows.csv")).unwrap();
        }
    }
}

fn sound(rows: &str, scene: &str) {
    let mut lines = rows.lines();
    assert!(lines.next().is_some_and(|header| header.starts_with("t,x,")), "{scene}");
    for line in lines {
        let finite = |cell: &str| cell.parse().is_ok_and(f64::is_finite);
        assert!(line.split(',').all(finite), "{scene}: {line}");
    }
}
