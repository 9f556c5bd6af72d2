//! Keys of axes: a number that an axis does not reach is an error, and not a map of equal cells.

use crate::cli::place::Place;

const SHIPPED_PLANE: &str = include_str!("../../../scenes/plane.toml");

#[test]
fn an_empty_part_of_a_key_is_refused() {
    let place = Place::with_scene();
    let damping = "environment.wall.damping=0..100:2";
    for key in [
        "environment..wall.stiffness",
        "environment.wall..stiffness",
        ".environment.wall.stiffness",
        "environment.wall.stiffness.",
        "stabilizer.lolc..damping_cap",
        ".",
        "",
    ] {
        let axis = format!("{key}=1..2:2");
        let words = [&format!("`{key}` has an empty part")[..], "one dot stands between two names"];
        place.refuses(["map", "scene.toml", "--x", &axis, "--y", damping], &words);
        place.refuses(["map", "scene.toml", "--x", damping, "--y", &axis], &words);
        place.refuses(["map", "scene.toml", "--x", &axis], &words);
    }
}

#[test]
fn one_number_is_not_two_axes_under_two_names() {
    let place = Place::with_scene();
    for (x, y) in [(".duration", "duration"), ("duration", "duration."), ("duration ", "duration")]
    {
        let (x, y) = (format!("{x}=1..2:2"), format!("{y}=1..2:2"));
        let said = place.refuses(["map", "scene.toml", "--x", &x, "--y", &y], &["duration"]);
        assert!(said.err.contains("empty part") || said.err.contains("both axes are"), "{said:?}");
    }
}

#[test]
fn a_coordinate_is_no_axis_and_the_error_says_so() {
    let place = Place::new();
    place.put("plane.toml", SHIPPED_PLANE);
    for (key, list) in [
        ("operator.rest", "operator.rest"),
        ("operator.rest[1]", "operator.rest"),
        ("environment.plane.normal[0]", "environment.plane.normal"),
        ("initial.position", "initial.position"),
    ] {
        let axis = format!("{key}=0..1:3");
        let words = [&format!("`{list}` is a list")[..], "lists cannot be mapped"];
        place.refuses(["map", "plane.toml", "--x", &axis], &words);
    }
}
