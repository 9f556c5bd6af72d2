//! Unsafe code: foreign-function surfaces have some, and every other package of the repository refuses it.

use std::fs;
use std::path::{Path, PathBuf};

/// The libraries for C and for the browser, and what compares the first with Rust through its header.
const SURFACES: [&str; 3] = ["bindings/c", "bindings/c/equal", "web"];

/// Every file below `folder`, but what is built and hidden.
fn files(folder: &Path) -> Vec<PathBuf> {
    // Cargo marks a folder of builds, whatever its name.
    if folder.join("CACHEDIR.TAG").exists() {
        return Vec::new();
    }
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let is_ours = |name: &str| !name.starts_with('.') && name != "target" && name != "node_modules";
    let ours = entries.filter(|it| it.file_name().to_str().is_some_and(is_ours));
    ours.flat_map(|it| if it.path().is_dir() { files(&it.path()) } else { vec![it.path()] })
        .collect()
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).expect("a text")
}

/// A manifest without its comments.
fn told(manifest: &Path) -> String {
    let text = text(manifest);
    text.lines()
        .filter(|line| !line.starts_with('#'))
        .fold(String::new(), |all, it| all + it + "\n")
}

#[test]
fn unsafe_code_is_refused_outside_of_foreign_function_surfaces() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = files(root);
    let of_workspace = text(&root.join("Cargo.toml"));
    assert!(of_workspace.contains("[workspace.lints.rust]\nunsafe_code = \"forbid\""));
    let mut surfaces = Vec::new();
    for manifest in files.iter().filter(|path| path.ends_with("Cargo.toml")) {
        let (text, folder) = (told(manifest), manifest.parent().expect("a folder"));
        let refused =
            ["[lints]\nworkspace = true", "unsafe_code = \"forbid\"", "unsafe_code = \"deny\""];
        if text.contains("[package]") && !refused.iter().any(|lint| text.contains(lint)) {
            surfaces.push(folder.strip_prefix(root).expect("below the root").to_owned());
        }
    }
    surfaces.sort();
    assert_eq!(surfaces, SURFACES.map(PathBuf::from), "packages whose lints allow unsafe code");
    // What is denied may be allowed again by an attribute, so the lint is named in no source.
    let lint = concat!("unsafe", "_code");
    let is_source = |path: &&PathBuf| path.extension().is_some_and(|it| it == "rs");
    let sources = files.iter().filter(is_source).filter(|path| !path.ends_with(file!()));
    let naming: Vec<_> = sources.filter(|path| text(path).contains(lint)).collect();
    assert!(naming.is_empty(), "{naming:?} name the lint of unsafe code");
}
