//! The unfinished table of a map: what was damaged, cut off or computed from other files is not taken.

use std::fs;
use std::os::unix::fs::symlink;

use crate::cli::place::Place;

const X: &str = "environment.wall.stiffness=500..20000:5";
const Y: &str = "environment.wall.damping=0..20:4";

/// A share of a map of 20 cells under two stabilizers; it has a table, and no pictures that take time.
fn map<'a>(scene: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let all = ["map", scene, "--x", X, "--y", Y, "--stabilizers", "none,popc", "--quiet"];
    let shard = if more.contains(&"--shard") { &[][..] } else { &["--shard", "0/2"] };
    all.iter().chain(shard).chain(more).copied().collect()
}

const TABLE: &str = "map-0-of-2.csv";

const PART: &str = "map-0-of-2.part.csv";

fn place() -> Place {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 1.5");
    place
}

/// The unfinished table with all rows, as a full disk leaves it in `folder` where the finished one, called `table`, should
/// be written.
pub(crate) fn unfinished(place: &Place, folder: &str, table: &str, command: &[&str]) -> String {
    fs::create_dir(place.path(folder)).unwrap();
    symlink("/dev/full", place.path(format!("{folder}/{table}"))).unwrap();
    place.run([command, &["--out", folder]].concat()).ended(2, &["no space is left"]);
    fs::remove_file(place.path(format!("{folder}/{table}"))).unwrap();
    let part = table.replace(".csv", ".part.csv");
    assert_eq!(place.names(folder), [&part[..]]);
    place.text(&format!("{folder}/{part}"))
}

#[test]
fn a_row_that_was_changed_is_refused_and_one_at_the_end_computed_again() {
    let place = place();
    place.run(map("scene.toml", &["--out", "whole"])).ended(0, &[]);
    let whole = place.text(&format!("whole/{TABLE}"));
    let part = unfinished(&place, "out", TABLE, &map("scene.toml", &[]));
    let resume = map("scene.toml", &["--out", "out", "--resume"]);
    // The table is the finished one with a column more.
    let plain: String = part
        .lines()
        .map(|line| match line.starts_with('#') {
            true => format!("{line}\n"),
            false => format!("{}\n", line.rsplit_once(',').unwrap().0),
        })
        .collect();
    assert_eq!(plain, whole);
    let rows = part.find("\n500.0,").unwrap() + 1;
    let ends: Vec<usize> = part.match_indices('\n').map(|(at, _)| at).collect();
    for (row, more) in [(1, 0), (7, 3), (19, 9)] {
        // Each digit of the row, and of its checksum.
        let first = ends[ends.iter().position(|end| *end > rows).unwrap() + row - 2] + 1;
        let line = &part[first..][..part[first..].find('\n').unwrap()];
        let digits: Vec<usize> =
            (0..line.len()).filter(|at| line.as_bytes()[*at].is_ascii_digit()).collect();
        let at = first + digits[more * digits.len() / 10];
        let mut changed = part.clone().into_bytes();
        changed[at] = if changed[at] == b'1' { b'2' } else { b'1' };
        place.put(format!("out/{PART}"), &changed);
        let words =
            [&format!("row {row} below the head does not match its checksum")[..], "remove it"];
        place.refuses(&resume, &words);
    }
    // The last rows may be what was written while the machine stopped: zeros, or half of what was meant.
    let last = ends[ends.len() - 2] + 1;
    for tail in [&part[last..last + 9], &"\0".repeat(300), &"\0\n".repeat(9), "\u{fffd},,\n"] {
        place.put(format!("out/{PART}"), format!("{}{tail}", &part[..last]));
        place.run(&resume).ended(0, &[]);
        assert_eq!(place.text(&format!("out/{TABLE}")), whole, "{tail:?}");
        assert!(!place.path(format!("out/{PART}")).exists());
    }
}

#[test]
fn an_empty_or_headless_table_is_begun_anew() {
    let place = place();
    place.run(map("scene.toml", &["--out", "whole"])).ended(0, &[]);
    let part = unfinished(&place, "out", TABLE, &map("scene.toml", &[]));
    let head = part.find("\n500.0,").unwrap() + 1;
    for kept in [0, 1, 20, head / 2, head - 1, head] {
        place.put(format!("out/{PART}"), &part[..kept]);
        place.run(map("scene.toml", &["--out", "out", "--resume"])).ended(0, &[]);
        assert_eq!(
            place.text(&format!("out/{TABLE}")),
            place.text(&format!("whole/{TABLE}")),
            "{kept}"
        );
    }
}

#[test]
fn a_row_that_no_run_has_is_not_merged() {
    let place = place();
    place.run(map("scene.toml", &["--out", "out"])).ended(0, &[]);
    place.run(map("scene.toml", &["--out", "out", "--shard", "1/2"])).ended(0, &[]);
    let table = place.text(&format!("out/{TABLE}"));
    let refuses = |text: String, words: &[&str]| {
        assert_ne!(text, table);
        place.put(format!("out/{TABLE}"), text);
        place.refuses(["map", "merge", "out", "--out", "merged"], words);
    };
    let grown = ",none,grows,distance,,";
    refuses(table.replacen(grown, ",none,grows,distance,1.0,", 1), &["which no map has there"]);
    for wrong in ["-1.0", "inf", "NaN", "1e0", "01.0", "-0.0"] {
        let bounded = [",settles,distance,", ",swinging,distance,"];
        let bounded = bounded.into_iter().find(|it| table.contains(it)).unwrap();
        let at = table.find(bounded).unwrap() + bounded.len();
        let end = at + table[at..].find(',').unwrap();
        refuses(format!("{}{wrong}{}", &table[..at], &table[end..]), &["which no map has there"]);
    }
    refuses(format!("{table}1.0,2.0\n"), &["goes on after its last cell"]);
}

#[test]
fn a_motion_that_was_changed_is_another_map() {
    let place = Place::new();
    let scene = include_str!("../../../scenes/motion-file.toml");
    let motion = include_str!("../../../scenes/motion-file.csv");
    place.put("scene.toml", scene);
    place.put("motion-file.csv", motion);
    let command = map("scene.toml", &[]);
    let part = unfinished(&place, "out", TABLE, &command);
    place.run(map("scene.toml", &["--out", "shards"])).ended(0, &[]);
    let (first, _) = motion.trim_end().rsplit_once('\n').unwrap();
    place.put("motion-file.csv", first);
    let resume = map("scene.toml", &["--out", "out", "--resume"]);
    place.refuses(&resume, &["is of another map", "recorded motion"]);
    place.run(map("scene.toml", &["--out", "shards", "--shard", "1/2"])).ended(0, &[]);
    place
        .refuses(["map", "merge", "shards", "--out", "merged"], &["motion file", "other rows now"]);
    // The rows count, and not how they are written.
    place.put("motion-file.csv", motion.replace(',', " , "));
    assert_eq!(place.text(&format!("out/{PART}")), part);
    place.run(&resume).ended(0, &[]);
    place.run(map("scene.toml", &["--out", "whole"])).ended(0, &[]);
    assert_eq!(place.text(&format!("out/{TABLE}")), place.text(&format!("whole/{TABLE}")));
}
