//! The claims of the paper in the command's output: table, JSON and page.

use crate::cli::paper::CASES;
use crate::cli::place::Place;

#[test]
fn the_command_prints_what_it_writes() {
    let place = Place::new();
    let said = place.run(["paper"]);
    said.ended(0, &["are in paper"]);
    assert_eq!(place.names("."), ["paper"]);
    let table = &said.out;
    assert!(table.lines().all(|line| line.chars().count() <= 100), "{table}");
    let quoted = include_str!("../../../docs/paper.md");
    // The last line names the folder.
    let (tables, _) = table.trim_end().rsplit_once("\n\n").expect("tables and a line");
    for line in tables.lines() {
        assert!(quoted.contains(line), "docs/paper.md does not say {line:?}");
    }
    let written = place.text("paper/claims.json");
    let json: serde_json::Value = serde_json::from_str(&written).expect("json");
    assert_eq!(json["draws"], serde_json::json!({ "count": 1000, "seed": 1 }));
    let rows = json["rows"].as_array().expect("rows");
    for row in rows {
        let (paper, judged) = (row["paper"].as_str().expect("a claim"), &row["ours"]);
        let share = 100.0 * judged["held"].as_f64().expect("a count") / 1000.0;
        let line = tables.lines().find(|line| line.starts_with(paper)).expect("a line");
        let word = judged["verdict"].as_str().expect("a verdict").split(" on ").next();
        assert!(line.contains(word.expect("a word")), "{line}");
        let shown: f64 = line
            .split(" (")
            .next()
            .and_then(|it| it.rsplit(' ').next())
            .expect("a share")
            .parse()
            .expect("a number");
        assert!((shown - share).abs() < 0.051, "{line}");
        assert!(["id", "reading", "unit", "printed"].iter().all(|key| row.get(key).is_some()));
        for key in ["interval", "median", "range", "single", "influences", "of"] {
            assert!(judged.get(key).is_some(), "{key}");
        }
    }
    let page = place.text("paper/report.html");
    assert!(page.matches("<svg").count() == 4);
    let (_, verdicts) = page.split_once("<h2>Claims</h2>").expect("claims");
    let (verdicts, _) = verdicts.split_once("</table>").expect("a table");
    // Printed and ours, side by side.
    assert_eq!(verdicts.matches("<span class=").count(), 2 * rows.len());
    for part in
        ["Definitions", "Where the energy went", "lyapunov 0.1.0", "scenes/paper-8k-lolc.toml"]
    {
        assert!(page.contains(part), "{part}");
    }
    // Each scene of a figure, and the command that runs it alone.
    let drawn = CASES.iter().filter(|case| page.contains(&format!("href=\"#{case}\"")));
    let drawn: Vec<_> = drawn.collect();
    assert_eq!(drawn.len(), 4);
    for case in drawn {
        let alone = format!("lyapunov run scenes/{case}.toml --csv {case}.csv");
        assert!(page.contains(&alone) && page.contains(&format!("id=\"{case}\"")), "{case}");
    }
    let others = place.run(["paper", "--draws", "50", "--seed", "2", "--json"]).out;
    let others: serde_json::Value = serde_json::from_str(&others).expect("json");
    assert_eq!(others["draws"], serde_json::json!({ "count": 50, "seed": 2 }));
    assert!(others["rows"][0]["ours"]["of"] == 50);
    assert_eq!(place.run(["paper", "--draws", "5", "--quiet"]).out, "");
}
