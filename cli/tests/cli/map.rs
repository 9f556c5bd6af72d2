//! Tests of `lyapunov map`: shards, interruptions and bad input.

use std::process::Stdio;
use std::thread;
use std::time::{Duration, Instant};

use crate::cli::checkpoint::unfinished;
use crate::cli::place::Place;
use crate::cli::said::{Said, Start};

const X: &str = "environment.wall.stiffness=500..20000:9";
const Y: &str = "environment.wall.damping=0..20:5:";

fn axes<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let mut all = vec!["map", "scene.toml", "--x", X, "--y", Y.trim_end_matches(':')];
    all.extend(more);
    all
}

fn place() -> Place {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 1.5");
    place
}

#[test]
fn a_map_is_the_same_whole_in_shards_and_on_any_threads() {
    let place = place();
    place
        .run(axes(&["--out", "whole", "--threads", "1"]))
        .ended(0, &["none", "popc", "lolc", "settles", "bounded"]);
    place.run(axes(&["--out", "threads", "--threads", "3", "--quiet"])).ended(0, &[]);
    for shard in ["0/3", "1/3", "2/3"] {
        place.run(axes(&["--out", "shards", "--shard", shard])).ended(0, &["shard"]);
    }
    place.run(["map", "merge", "shards", "--out", "merged"]).ended(0, &["lolc", "bounded"]);
    let whole = place.text("whole/map.csv");
    assert_eq!(whole.lines().filter(|line| !line.starts_with('#')).count(), 1 + 9 * 5 * 3);
    assert!(whole.contains("#| [environment.wall]"), "{whole}");
    assert_eq!(place.text("threads/map.csv"), whole);
    assert_eq!(place.text("merged/map.csv"), whole);
    for file in ["verdict.svg", "peak_force.svg", "chatter_rms.svg", "active.svg"] {
        assert_eq!(place.text(&format!("merged/{file}")), place.text(&format!("whole/{file}")));
    }
    let page = place.text("whole/report.html");
    let rows = whole.lines().filter(|line| !line.starts_with('#')).skip(1);
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    let has = |measure: usize| rows.iter().any(|row| !row[5 + measure].is_empty());
    // No contact is long enough for a stiffness, the last measure.
    let figures = 1 + (0..10).filter(|measure| has(*measure)).count();
    assert!(!has(9) && !place.path("whole/stiffness_felt.svg").exists());
    assert!(page.contains("Which runs settle") && page.matches("<figure").count() == figures);
    let json: serde_json::Value = serde_json::from_str(&place.text("whole/map.json")).unwrap();
    assert_eq!(json["cells"], 45);
    assert_eq!(json["rollout_steps"], 45 * 3 * 151);
    assert_eq!(json["areas"][2]["stabilizer"], "lolc");
    let mut judged = 0;
    for (key, word) in [("settles", "settles"), ("swinging", "swinging"), ("grows", "grows")] {
        let rows = whole.lines().filter(|line| line.contains(&format!(",lolc,{word},distance,")));
        let rows = rows.count();
        assert_eq!(json["areas"][2][format!("{key}_cells")], rows, "{word}");
        judged += rows;
    }
    let area = &json["areas"][2];
    assert_eq!(
        (judged, &area["judged_cells"], &area["too_short_cells"]),
        (45, &45.into(), &0.into())
    );
    let bounded = 45 - area["grows_cells"].as_u64().unwrap();
    assert_eq!(area["bounded_share"], bounded as f64 / 45.0);
    // The legend of the figure has the words, and no key with numbers from 0 to 1.
    let figure = place.text("whole/verdict.svg");
    for word in ["settles", "swinging", "grows"] {
        assert_eq!(figure.matches(&format!(">{word}<")).count(), 1, "{word}");
    }
    assert!(!figure.contains(">0.2<") && !figure.contains("stable: dark"));
}

/// Rows of a band are written by all threads, a thousand cells each.
#[test]
fn the_rows_of_many_threads_stand_in_their_order() {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 0.1");
    let (x, y) = ("environment.wall.stiffness=500..20000:96", "environment.wall.damping=0..20:64");
    let map = |out: &str, more: &[&str]| {
        let words = ["map", "scene.toml", "--x", x, "--y", y, "--stabilizers", "none,popc"];
        place.run(words.iter().chain(&["--out", out, "--quiet"]).chain(more)).ended(0, &[]);
        place.text(&format!("{out}/map.csv"))
    };
    let one = map("one", &["--threads", "1"]);
    assert!(one.lines().count() > 2 * 96 * 64);
    assert!(map("three", &["--threads", "3"]) == one, "the rows differ");
}

#[test]
fn the_family_is_mapped_beside_the_stabilizers_of_scenes() {
    let place = place();
    let names = ["--stabilizers", "popc-spread,none,tank,lolc"];
    let with = |more: &[&'static str]| axes(&[&names[..], more].concat());
    place
        .run(with(&["--out", "whole", "--threads", "1"]))
        .ended(0, &["popc-spread", "tank", " cells at once"]);
    for shard in ["0/2", "1/2"] {
        place.run(with(&["--out", "shards", "--shard", shard])).ended(0, &["shard"]);
    }
    place.run(["map", "merge", "shards", "--out", "merged"]).ended(0, &["tank"]);
    let whole = place.text("whole/map.csv");
    assert_eq!(place.text("merged/map.csv"), whole);
    // The other stabilizers of the map change nothing.
    place.run(axes(&["--out", "usual", "--stabilizers", "none,lolc"])).ended(0, &[]);
    let usual = place.text("usual/map.csv");
    let rows = |table: &str, name: &str| -> Vec<String> {
        let cells = table.lines().filter(|line| !line.starts_with('#'));
        let rows = cells.filter(|line| line.contains(&format!(",{name},")));
        rows.map(str::to_owned).collect()
    };
    for name in ["none", "lolc"] {
        assert_eq!((rows(&whole, name), rows(&whole, name).len()), (rows(&usual, name), 9 * 5));
    }
    let page = place.text("whole/report.html");
    assert!(page.contains("--stabilizers popc-spread,none,tank,lolc"));
    assert!(page.contains("<td>tank</td>"));
    // A map of other stabilizers is not resumed.
    unfinished(&place, "other", "map.csv", &with(&[]));
    place.refuses(axes(&["--out", "other", "--resume"]), &["is of another map"]);
}

#[test]
fn a_table_that_was_cut_off_is_resumed() {
    let place = place();
    place.run(axes(&["--out", "whole"])).ended(0, &[]);
    let whole = place.text("whole/map.csv");
    let part = unfinished(&place, "part", "map.csv", &axes(&[]));
    let rows = part.find("\n500").unwrap() + 1;
    for kept in [rows, rows + 10, (rows + part.len()) / 2, part.len() - 1, part.len()] {
        let folder = format!("cut-{kept}");
        std::fs::create_dir(place.path(&folder)).unwrap();
        place.put(format!("{folder}/map.part.csv"), &part[..kept]);
        place.refuses(axes(&["--out", &folder]), &["unfinished map", "--resume"]);
        place.run(axes(&["--out", &folder, "--resume"])).ended(0, &[]);
        assert_eq!(place.text(&format!("{folder}/map.csv")), whole);
        assert_eq!(place.text(&format!("{folder}/verdict.svg")), place.text("whole/verdict.svg"));
        assert!(!place.path(format!("{folder}/map.part.csv")).exists());
    }
}

#[test]
fn an_interrupted_map_keeps_what_is_done() {
    let place = Place::new();
    place.put_scene("scene.toml", "duration = 10.0", "duration = 3.0");
    let large = [
        "map",
        "scene.toml",
        "--x",
        "environment.wall.stiffness=500..20000:2000",
        "--y",
        "environment.wall.damping=0..20:2000",
        "--out",
        "out",
    ];
    let mut child = place.command(large).start(Stdio::piped());
    let begun = Instant::now();
    let head =
        |place: &Place| std::fs::read_to_string(place.path("out/map.part.csv")).unwrap_or_default();
    while head(&place).lines().filter(|line| !line.starts_with('#')).count() < 2 {
        if begun.elapsed() > Duration::from_secs(50) {
            let _ = child.kill();
            panic!("no row appears");
        }
        thread::sleep(Duration::from_millis(20));
    }
    let id = child.id();
    let sent = std::process::Command::new("sh").args(["-c", &format!("kill -TERM {id}")]).status();
    assert!(sent.unwrap().success());
    Said::by_child(child).ended(130, &["interrupted", "map.part.csv", "--resume"]);
    let kept = head(&place);
    assert!(kept.ends_with('\n'));
    assert_eq!(place.names("out"), ["map.part.csv"]);
}

#[test]
fn bad_arguments_are_refused_and_change_nothing() {
    let place = place();
    let with = |x: &'static str, words: &[&str]| {
        place.refuses(["map", "scene.toml", "--x", x, "--y", "device.mass=0.1..1:3"], words);
    };
    with(
        "environment.wall.stifness=1..2:3",
        &["no number `environment.wall.stifness`", "did you mean `environment.wall.stiffness`?"],
    );
    with("velocity=1..2:3", &["`velocity` is not a number"]);
    with("environment.wall.damping=2..2:3", &["2..2 is empty"]);
    with("environment.wall.damping=3..2:3", &["3..2 is reversed"]);
    with("environment.wall.damping=1..2:0", &["`0` is not a number of values"]);
    with("environment.wall.damping=1..2:1", &["one value is a range of its own, 1..1:1"]);
    with("environment.wall.damping=1..2", &["lacks the number of values"]);
    with("environment.wall.damping=0..2:3:log", &["begins above 0"]);
    with("environment.wall.damping=a..2:3", &["`a` is not a finite number"]);
    with("device.mass=0.1..1:3", &["both axes are `device.mass`"]);
    with("operator.mass=-1..1:3", &["`operator.mass` = -1.0", "0 or greater"]);
    with("environment_rate=30..100:3", &["`environment_rate` = 30.0", "does not divide"]);
    place.refuses(axes(&["--stabilizers", "pop"]), &["did you mean `popc`?"]);
    place.refuses(axes(&["--stabilizers", "popc,popc"]), &["`popc` is named twice"]);
    place.refuses(axes(&["--out", "out", "--shard", "3/3"]), &["no shard 3 of 3"]);
    place.refuses(axes(&["--shard", "0/3"]), &["--out"]);
    place.refuses(axes(&["--threads", "0"]), &["--threads"]);
    place.refuses(["map", "merge", "scene.toml", "--out", "out"], &["not the table of a map"]);
}

/// The command that the page tells of a cell.
#[test]
fn a_map_of_one_cell_is_that_cell_of_a_larger_map() {
    let place = place();
    place.put("a scene's.toml", place.text("scene.toml"));
    place.run(axes(&["--out", "whole"])).ended(0, &[]);
    let (x, y) = ("environment.wall.stiffness=2937.5", "environment.wall.damping=5.0");
    let alone = |text: &str, value: &str| format!("{text}..{value}:1");
    let (x, y) = (alone(x, "2937.5"), alone(y, "5.0"));
    let cell = ["map", "a scene's.toml", "--x", &x, "--y", &y, "--out", "cell"];
    place.run(cell).ended(0, &["none", "popc", "lolc"]);
    let rows = |file: &str| -> Vec<String> {
        let text = place.text(file);
        text.lines().filter(|line| line.starts_with("2937.5,5.0,")).map(str::to_owned).collect()
    };
    assert_eq!(rows("cell/map.csv"), rows("whole/map.csv"));
    assert_eq!(rows("cell/map.csv").len(), 3);
    // The page's own command names the file as a shell reads it.
    let page = place.text("cell/report.html");
    assert!(page.contains(r"lyapunov map 'a scene'\\''s.toml'"), "{page}");
}

#[test]
fn another_map_is_neither_resumed_nor_merged() {
    let place = place();
    place.run(axes(&["--out", "out", "--shard", "0/2"])).ended(0, &[]);
    place.refuses(["map", "merge", "out", "--out", "merged"], &["shard 1/2 is missing"]);
    let shard = place.text("out/map-0-of-2.csv");
    place.put("out/map-1-of-2.csv", shard.replace("# shard 0/2", "# shard 1/2"));
    place.refuses(["map", "merge", "out", "--out", "merged"], &["row", "no map has there"]);
    place.put("out/map-1-of-2.csv", shard.replace("duration = 1.5", "duration = 1.6"));
    place.refuses(["map", "merge", "out", "--out", "merged"], &["not of the same map"]);
    let part = unfinished(&place, "other", "map.csv", &axes(&[]));
    place.put("other/map.part.csv", part.replace("duration = 1.5", "duration = 1.6"));
    let before = place.contents();
    place.refuses(axes(&["--out", "other", "--resume"]), &["is of another map"]);
    assert_eq!(place.contents(), before);
}

/// A table with the column `stable` of earlier versions, as a checkpoint and as a shard.
#[test]
fn a_table_with_other_columns_is_refused() {
    let place = place();
    place.run(axes(&["--out", "out"])).ended(0, &[]);
    let table = place.text("out/map.csv");
    let old = table.replace("stabilizer,verdict,verdict_by,", "stabilizer,stable,");
    assert_ne!(old, table);
    let part = unfinished(&place, "old", "map.csv", &axes(&[]));
    place.put(
        "old/map.part.csv",
        part.replace("stabilizer,verdict,verdict_by,", "stabilizer,stable,"),
    );
    place.put("old/map-0-of-1.csv", &old);
    let words = ["its columns are `stable,", "compute the map anew"];
    place.refuses(axes(&["--out", "old", "--resume"]), &words);
    place.refuses(["map", "merge", "old/map-0-of-1.csv", "--out", "merged"], &words);
    // A word that is none is a row that no map has.
    place.put("old/map-0-of-1.csv", table.replacen(",grows,", ",stable,", 1));
    place.refuses(
        ["map", "merge", "old/map-0-of-1.csv", "--out", "merged"],
        &["row", "which no map has there"],
    );
    // One without checksums, as versions before wrote it.
    place.put("old/map.part.csv", &table);
    place
        .refuses(axes(&["--out", "old", "--resume"]), &["its columns are", "compute the map anew"]);
}

#[test]
fn a_map_of_what_never_rests_says_what_is_judged() {
    let place = Place::new();
    place.put("scene.toml", include_str!("../../../scenes/motion-sine.toml"));
    let axes = ["map", "scene.toml", "--x", X, "--y", "device.mass=0.1..0.4:3"];
    let said = place.run([&axes[..], &["--stabilizers", "none"]].concat());
    said.ended(0, &["judged by speed, as what moves the plant never rests", "bounded"]);
    let json = place.run([&axes[..], &["--stabilizers", "none", "--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!(
        (&json["cells_by_speed"], &json["areas"][0]["judged_cells"]),
        (&27.into(), &27.into())
    );
}

#[test]
fn a_full_disk_loses_nothing() {
    let place = place();
    std::fs::create_dir(place.path("out")).unwrap();
    // Files are temporary until they are whole, so a link to a full device stands for a full disk.
    std::os::unix::fs::symlink("/dev/full", place.path("out/map.json")).unwrap();
    place.put("out/map.csv", "an earlier map");
    place.run(axes(&["--out", "out"])).ended(2, &["map.json", "no space is left"]);
    assert_eq!(place.text("out/map.csv"), "an earlier map");
    let part = place.text("out/map.part.csv");
    assert_eq!(part.lines().filter(|line| !line.starts_with('#')).count(), 1 + 9 * 5 * 3);
}

#[test]
fn every_key_of_a_map_is_on_its_page() {
    let place = place();
    place.run(axes(&["--out", "out"])).ended(0, &["the most rendered first", "judged by"]);
    let page = include_str!("../../../docs/map.md");
    let json: serde_json::Value = serde_json::from_str(&place.text("out/map.json")).unwrap();
    let (top, area) = (json.as_object().unwrap(), json["areas"][0].as_object().unwrap());
    let text = place.text("out/map.csv");
    let head = text.lines().find(|line| !line.starts_with('#')).unwrap();
    let measures = head.split(',').skip(3);
    let keys = top.keys().chain(area.keys()).map(String::as_str).chain(measures);
    for key in keys.filter(|key| !["not_deterministic", "stabilizer"].contains(key)) {
        assert!(page.contains(&format!("`{key}`")), "docs/map.md lacks `{key}`");
    }
    let ranks: Vec<u64> =
        json["areas"].as_array().unwrap().iter().map(|it| it["rank"].as_u64().unwrap()).collect();
    let mut sorted = ranks.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, [1, 2, 3]);
}

#[test]
fn the_edge_alone_agrees_with_the_whole_map() {
    let place = place();
    let (x, y) = ("environment.wall.stiffness=100..5000:40", "environment.wall.damping=0..80:36");
    let map = |more: &[&'static str]| {
        let mut all = vec!["map", "scene.toml", "--x", x, "--y", y, "--stabilizers", "none"];
        all.extend(more);
        all
    };
    place.run(map(&["--out", "whole", "--quiet"])).ended(0, &[]);
    place.run(map(&["--out", "edge", "--refine"])).ended(0, &["judged", "the cell"]);
    let whole = place.text("whole/map.csv");
    let judged = place.text("edge/judged.csv");
    let rows: Vec<&str> = judged.lines().skip(1).collect();
    assert!((40..40 * 36).contains(&rows.len()), "{}", rows.len());
    for row in &rows {
        let (cell, side) = row.rsplit_once(',').unwrap();
        let start = format!("{cell},");
        let full = whole.lines().find_map(|line| line.strip_prefix(&start)).unwrap();
        assert_eq!(full.starts_with("grows"), side == "grows", "{row}");
    }
    let json: serde_json::Value = serde_json::from_str(&place.text("edge/refined.json")).unwrap();
    assert_eq!(json["edges"][0]["judged_cells"], rows.len());
    assert!(place.text("edge/report.html").contains("<figure class=\"cells\""));
    let quiet = place.run(map(&["--refine", "--quiet"]));
    quiet.ended(0, &[]);
    assert_eq!(quiet.out, "");
    place.run(map(&["--out", "edge", "--refine", "--resume"])).ended(2, &["--resume"]);
}
