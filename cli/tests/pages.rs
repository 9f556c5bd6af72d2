//! The output that pages of docs/ show is what the command prints.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::called::text;

#[test]
fn the_pages_show_what_is_printed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (page, command, scene) in [
        ("explain.md", "explain", "scenes/paper-8k-none.toml"),
        ("bounds.md", "bound", "scenes/press-1khz.toml"),
    ] {
        let mut lyapunov = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
        let said = lyapunov.args([command, scene]).current_dir(&root).output().unwrap();
        let shown = format!("$ lyapunov {command} {scene}\n{}", text(&said.stdout));
        let page = root.join("docs").join(page);
        assert!(fs::read_to_string(&page).unwrap().contains(&shown), "{page:?}:\n{shown}");
    }
}

/// The page on designing has a scene of its own, which its commands are called with.
#[test]
fn the_page_on_designing_shows_what_is_printed() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/design.md");
    let page = fs::read_to_string(page).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let scene = page.split("```toml\n").nth(1).and_then(|it| it.split("```").next()).unwrap();
    fs::write(folder.path().join("handle.toml"), scene).unwrap();
    let shown: Vec<&str> = page.split("```text\n$ lyapunov ").skip(1).collect();
    assert_eq!(shown.len(), 2);
    for block in shown {
        let (command, printed) = block.split("```").next().unwrap().split_once('\n').unwrap();
        let mut lyapunov = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
        let said = lyapunov.args(command.split(' ')).current_dir(folder.path()).output().unwrap();
        assert_eq!(text(&said.stdout), printed, "{command}");
    }
}
