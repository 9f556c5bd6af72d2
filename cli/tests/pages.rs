//! The output that pages of docs/ show is what the command prints.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::called::text;

/// The line that stands for lines which a page leaves out.
const LEFT_OUT: &str = "  ...\n";

/// Asserts that the blocks of `page` that begin with a call show what the call prints. A page may hold the scene that it calls
/// handle.toml; all others ship.
fn shows_what_is_printed(page: &str, folder: &Path) -> usize {
    if let Some(scene) = page.split("```toml\n").nth(1).and_then(|it| it.split("```").next()) {
        fs::write(folder.join("handle.toml"), scene).unwrap();
    }
    let blocks: Vec<&str> = page.split("```text\n$ lyapunov ").skip(1).collect();
    for block in &blocks {
        let (command, shown) = block.split("```").next().unwrap().split_once('\n').unwrap();
        let mut lyapunov = Command::new(env!("CARGO_BIN_EXE_lyapunov"));
        let said = lyapunov.args(command.split(' ')).current_dir(folder).output().unwrap();
        let said = text(&said.stdout);
        let mut rest = said.as_str();
        for part in shown.split(LEFT_OUT) {
            let at = rest.find(part).unwrap_or_else(|| panic!("{command}:\n{said}\nnot\n{part}"));
            rest = &rest[at + part.len()..];
        }
        assert!(shown.contains(LEFT_OUT) || said == shown, "{command}:\n{said}");
    }
    blocks.len()
}

#[test]
fn the_pages_show_what_is_printed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::os::unix::fs::symlink(root.join("scenes"), folder.path().join("scenes")).unwrap();
    let pages = fs::read_dir(root.join("docs")).unwrap().map(|it| it.unwrap().path());
    let pages = pages.filter(|it| it.extension().is_some_and(|it| it == "md"));
    let blocks =
        pages.map(|it| shows_what_is_printed(&fs::read_to_string(it).unwrap(), folder.path()));
    assert_eq!(blocks.sum::<usize>(), 7);
}
