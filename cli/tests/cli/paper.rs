//! Tests of `lyapunov paper`.

use std::fs;
use std::path::Path;

use resvg::tiny_skia::Pixmap;
use resvg::usvg::{Options, Tree};

use crate::cli::place::Place;

pub(crate) const CASES: [&str; 6] = [
    "paper-50k-lolc",
    "paper-50k-none",
    "paper-50k-popc",
    "paper-8k-lolc",
    "paper-8k-none",
    "paper-8k-popc",
];

/// The figures are pictures, and the rows are those that `run` gives for the shipped scenes, byte for byte; a second
/// run gives the same.
#[test]
fn the_folder_holds_figures_and_rows_and_nothing_else_changes() {
    let place = Place::new();
    let said = place.run(["paper", "--out", "new/figures"]);
    said.ended(0, &["reproduced", "new/figures"]);
    said.fits();
    assert_eq!(said.err, "");
    assert_eq!(place.names("."), ["new"]);
    assert_eq!(place.names("new"), ["figures"]);
    let figures = (6..=9).flat_map(|n| [format!("figure-{n}.png"), format!("figure-{n}.svg")]);
    let rows = CASES.iter().map(|case| format!("{case}.csv"));
    let page = ["report.html".to_owned()];
    let files = ["claims.json".to_owned()].into_iter().chain(figures).chain(rows).chain(page);
    assert_eq!(place.names("new/figures"), files.collect::<Vec<_>>());

    let before = place.contents();
    let told = place.run(["paper", "--out", "new/figures", "--json"]);
    told.ended(0, &[]);
    assert_eq!(told.out, place.text("new/figures/claims.json"));
    assert_eq!(place.contents(), before);
    for n in 6..=9 {
        picture(&place.path(format!("new/figures/figure-{n}")));
    }
    for case in CASES {
        let scene = format!("{}/../scenes/{case}.toml", env!("CARGO_MANIFEST_DIR"));
        let run = place.run(["run", &scene, "--csv", "-"]);
        assert_eq!(run.out, place.text(&format!("new/figures/{case}.csv")), "{case}");
    }
}

/// Asserts that both files of a figure can be read, and that the picture is the drawing at twice its size, not empty.
fn picture(stem: &Path) {
    let svg = fs::read_to_string(stem.with_extension("svg")).unwrap();
    let size = Tree::from_str(&svg, &Options::default()).unwrap().size();
    let png = Pixmap::decode_png(&fs::read(stem.with_extension("png")).unwrap()).unwrap();
    assert_eq!(png.width(), (2.0 * size.width()).ceil() as u32);
    assert_eq!(png.height(), (2.0 * size.height()).ceil() as u32);
    let first = png.pixels()[0];
    assert!(png.pixels().iter().any(|pixel| *pixel != first));
}
