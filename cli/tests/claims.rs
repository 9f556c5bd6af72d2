//! The claims of the paper in the command's output: table, JSON and page.

use std::process::Command;

#[test]
fn the_command_prints_what_it_writes() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |extra: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_lyapunov"))
            .arg("paper")
            .arg("--out")
            .arg(folder.path())
            .args(extra)
            .output()
            .expect("the command");
        assert!(output.status.success());
        String::from_utf8(output.stdout).expect("text")
    };
    let table = run(&[]);
    let claims = table.lines().filter(|line| line.contains(" of 101 "));
    assert!(claims.clone().count() == 13, "{table}");
    assert!(claims.clone().all(|line| line.chars().count() <= 100), "{table}");
    assert!(table.contains("not reproduced    0 of 101"), "{table}");
    let quoted = include_str!("../../docs/paper.md");
    for claim in claims {
        assert!(quoted.contains(claim), "docs/paper.md does not say {claim:?}");
    }
    let printed = run(&["--json"]);
    let written = std::fs::read_to_string(folder.path().join("claims.json")).expect("claims.json");
    assert_eq!(printed, written);
    let json: serde_json::Value = serde_json::from_str(&written).expect("json");
    let keys = ["id", "paper", "measured", "unit", "reading", "held", "of", "verdict"];
    for row in json["rows"].as_array().expect("rows") {
        assert!(keys.iter().all(|key| row.get(key).is_some()), "{row}");
    }
    assert_eq!(run(&["--quiet"]), "");
    let page = std::fs::read_to_string(folder.path().join("report.html")).expect("report.html");
    assert!(page.matches("<svg").count() == 4);
    // Eleven claims under eight readings, and the readings themselves.
    let (_, moved) = page.split_once("How the verdicts move").expect("verdicts");
    let (moved, _) = moved.split_once("</table>").expect("a table");
    assert_eq!(moved.matches("<span class=").count(), 11 * 8);
    for reading in ["cap 0.25", "cap 0.5", "cap 1", "observer at 1000 Hz", "printed recursion"] {
        assert!(moved.contains(reading), "{reading}");
    }
    for part in
        ["Definitions", "Where the energy went", "lyapunov 0.1.0", "scenes/paper-8k-lolc.toml"]
    {
        assert!(page.contains(part), "{part}");
    }
}
