//! Wrong arguments, and the help that gives the right ones.

use crate::cli::place::Place;

#[test]
fn wrong_arguments_are_refused() {
    let place = Place::with_scene();
    let cases: &[(&[&str], &[&str])] = &[
        (&["run"], &["<SCENE>", "Usage: lyapunov run"]),
        (&["run", "--csv", "rows.csv"], &["<SCENE>"]),
        (&["run", ""], &["'<SCENE>'"]),
        (&["run", "scene.toml", "scene.toml"], &["unexpected argument 'scene.toml'"]),
        (&["run", "scene.toml", "--csv"], &["'--csv <FILE>'"]),
        (&["run", "scene.toml", "--csv", ""], &["'--csv <FILE>'"]),
        (
            &["run", "scene.toml", "--csv", "a.csv", "--csv", "b.csv"],
            &["'--csv <FILE>'", "multiple"],
        ),
        (&["run", "scene.toml", "--csvv", "a.csv"], &["'--csvv'", "'--csv'"]),
        (&["run", "scene.toml", "--out"], &["'--out <DIR>'"]),
        (&["run", "scene.toml", "--out", "a", "--csv", "b"], &["'--out <DIR>'", "'--csv <FILE>'"]),
        (&["runn", "scene.toml"], &["'runn'", "'run'"]),
        (&["paper", "scene.toml"], &["'scene.toml'"]),
        (&["paper", "--out"], &["'--out <DIR>'"]),
        (&["paper", "--out", "a", "--out", "b"], &["'--out <DIR>'", "multiple"]),
        (&["scenes", "tour", "box"], &["unexpected argument 'box'"]),
        (&["scenes", "tour", "--json"], &["'--json'", "[NAME]"]),
        (&["scenes", "--quiet", "--json"], &["'--json'", "'--quiet'"]),
        (&["scenes", "nothing-like-it"], &["`nothing-like-it`", "`lyapunov scenes` lists them"]),
        (
            &["schema", "scene.toml"],
            &["'scene.toml'", "[possible values: scene, model, teleoperation]"],
        ),
    ];
    for (arguments, words) in cases {
        place.refuses(*arguments, words).fits();
    }
}

#[test]
fn no_argument_gets_help_and_status_2() {
    let place = Place::new();
    let said = place.run::<&str>([]);
    said.ended(2, &["Usage: lyapunov <COMMAND>", "run", "paper"]);
    assert!(place.contents().is_empty());
}

/// Options and exit statuses in the help of every command.
const ENDS: &[&str] =
    &["--json", "--quiet", "Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted."];

#[test]
fn help_fits_and_names_everything() {
    let place = Place::new();
    let cases: &[(&[&str], &[&str])] = &[
        (
            &["--help"],
            &[
                "run",
                "paper",
                "scenes",
                "schema",
                "Exit status: 0",
                "2 bad input",
                "130 interrupted",
            ],
        ),
        (&["-h"], &["run", "paper"]),
        (&["help", "run"], &["<SCENE>", "--csv <FILE>"]),
        (&["run", "--help"], &["<SCENE>", "--csv <FILE>", "`-` is standard output"]),
        (&["paper", "--help"], &["figures 6 to 9", "--out <DIR>", "[default: paper]"]),
        (&["run", "--help"], ENDS),
        (&["paper", "--help"], ENDS),
        (&["compare", "--help"], ENDS),
        (&["observe", "--help"], ENDS),
        (&["identify", "--help"], ENDS),
        (
            &["scenes", "--help"],
            &["[NAME]", "lyapunov scenes tour > tour.toml", "--json", "--quiet"],
        ),
        (&["schema", "--help"], &["#:schema ./scene.schema.json", "lyapunov schema >"]),
        (&["--version"], &[concat!("lyapunov ", env!("CARGO_PKG_VERSION"))]),
    ];
    for (arguments, words) in cases {
        let said = place.run(*arguments);
        said.ended(0, words);
        said.fits();
        assert_eq!(said.err, "");
        // clap sets a default apart by an empty line of its own width.
        let mut lines = said.out.lines().filter(|line| !line.trim().is_empty());
        assert!(lines.all(|line| line == line.trim_end()), "{}", said.out);
    }
    assert!(place.contents().is_empty());
}
