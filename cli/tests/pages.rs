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
