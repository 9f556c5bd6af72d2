//! Tests of `lyapunov hard`.

use serde_json::Value;

use crate::cli::place::Place;

/// A single run for all checks: this command takes the longest.
#[test]
fn all_pass_and_the_files_say_so() {
    let place = Place::new();
    let said = place.run(["hard", "--out", "made", "--json"]);
    said.ended(0, &[]);
    // On a slow machine the progress of half a minute is told.
    assert!(said.err.lines().all(|line| line.ends_with(" left")), "{}", said.err);
    assert_eq!(place.names("made"), ["hard.csv", "hard.json", "report.html"]);
    assert_eq!(place.text("made/hard.json"), said.out);
    let told: Value = serde_json::from_str(&said.out).unwrap();
    let rows = told["rows"].as_array().unwrap();
    assert!(rows.len() > 40);
    for row in rows {
        let number = |key: &str| row[key].as_f64().unwrap();
        assert!(row["case"].is_string() && row["passed"] == true, "{row}");
        assert!(number("measured") <= number("bound") && number("ledger_off") <= 1.0, "{row}");
    }
    let naive = rows.iter().filter(|row| row["naive"]["kept"] == false).count();
    assert!(naive > rows.len() / 2, "only {naive} are hard for the naive one");
    let page = place.text("made/report.html");
    for row in rows {
        let hard = row["case"].as_str().unwrap();
        assert!(page.contains(hard), "{hard}");
    }
    assert!(!page.contains("FAIL") && !page.contains("http:") && !page.contains("https:"));
}

#[test]
fn a_member_of_the_family_replaces_ours() {
    let place = Place::new();
    let said = place.run(["hard", "--stabilizer", "popc-spread", "--out", "made"]);
    said.ended(0, &["popc-spread instead of ours", "measured", "does not promise"]);
    said.fits();
    let told: Value = serde_json::from_str(&place.text("made/hard.json")).unwrap();
    assert_eq!(told["stabilizer"], "popc-spread");
    let rows = told["rows"].as_array().unwrap();
    assert!(rows.iter().all(|row| row["passed"] == true && row["promised"] == false));
    let over = rows.iter().filter(|row| row["measured"].as_f64() > row["bound"].as_f64()).count();
    assert_eq!(said.out.lines().filter(|line| line.starts_with("over  ")).count(), over);
    assert!(over > 0);
    let page = place.text("made/report.html");
    assert!(page.contains("lyapunov hard --stabilizer popc-spread --out made"));
    place.refuses(["hard", "--stabilizer", "none"], &["`none` is no stabilizer"]);
    place.refuses(["hard", "--stabilizer", "popcspread"], &["did you mean `popc-spread`?"]);
}

#[test]
fn bad_input_is_refused_before_anything_runs() {
    let place = Place::new();
    place.put("file", "");
    place.refuses(["hard", "--out", "file"], &["part of the path is a file"]);
    place.refuses(["hard", "--json", "--quiet"], &["'--json' cannot be used with '--quiet'"]);
}

#[test]
fn random_scenes_and_a_scene_of_yours_are_held_to_every_promise() {
    let place = Place::new();
    let soak = ["hard", "--minutes", "0.001", "--seed", "5"];
    place.run(soak).ended(0, &["seed 5, cases 0 to", "every promise is kept"]);
    let said = place.run([&soak[..], &["--json", "--out", "made"]].concat());
    said.ended(0, &[]);
    let told: Value = serde_json::from_str(&said.out).unwrap();
    assert!(told["seed"] == 5 && told["found"].is_null() && told["cases"].as_u64() >= Some(64));
    // Nothing was found, so that nothing is written.
    assert!(!place.path("made").exists() && !place.path("soak.toml").exists());

    place.put_scene("scene.toml", "", "");
    place.run(["hard", "scene.toml"]).ended(0, &["scene.toml: every promise is kept"]);
    let said = place.run(["hard", "scene.toml", "--stabilizer", "tank"]);
    said.ended(0, &["faults too; every sample is accepted again after 1 tick"]);
    let (_, faults) = said.out.split_once("after ").unwrap();
    let faults: u64 = faults.split(' ').next().unwrap().parse().unwrap();
    // 33 kinds at each of 1001 ticks, in both scalars, but a stale first motion or a repeated first sample.
    assert!((33 * 2 * 990..=33 * 2 * 1001).contains(&faults), "{faults}");
    place.refuses(["hard", "none.toml"], &["none.toml"]);
    place.refuses(["hard", "--minutes", "0"], &["not a time in minutes above 0"]);
    place.refuses(["hard", "--seed", "3"], &["--minutes"]);
}
