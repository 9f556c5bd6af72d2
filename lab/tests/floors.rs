//! Imports point down: from crate to crate, from floor to floor of the lab, and in no ring among the rooms of a floor.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The floors of the lab, the lowest first. A room is a folder or a file of a floor.
const FLOORS: [&str; 6] = ["text", "files", "simulate", "measure", "show", "studies"];

/// Our crates that each crate may depend on.
const CRATES: [(&str, &[&str]); 7] = [
    ("lyapunov-core", &[]),
    ("plants", &["lyapunov-core"]),
    ("stabilizers", &["lyapunov-core"]),
    (".", &["lyapunov-core", "lyapunov-plants", "lyapunov-stabilizers"]),
    ("figures", &[]),
    ("lab", &["lyapunov", "lyapunov-figures"]),
    ("cli", &["lyapunov", "lyapunov-figures", "lyapunov-lab"]),
];

/// A file: the names of its module's path, and its text.
type File = (Vec<String>, String);

fn names(path: &str) -> Vec<String> {
    let module = path.trim_end_matches(".rs").trim_end_matches("/mod");
    module.split('/').map(str::to_owned).collect()
}

/// The files below `folder`, called from `root` on.
fn files_of(folder: &Path, root: &Path, files: &mut Vec<File>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_of(&path, root, files);
        } else if path.extension().is_some_and(|it| it == "rs") {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap();
            files.push((names(name), fs::read_to_string(&path).unwrap()));
        }
    }
}

/// The paths that `tree` stands for, the part of a path from its first name on: `a::{b, c::d}` for `a::b` and `a::c::d`.
fn expanded(tree: &str) -> Vec<Vec<String>> {
    let name: String = tree.chars().take_while(|it| it.is_alphanumeric() || *it == '_').collect();
    if !name.is_empty() {
        let rest = tree[name.len()..].strip_prefix("::").map(expanded).unwrap_or_default();
        let rest = if rest.is_empty() { vec![vec![]] } else { rest };
        return rest.into_iter().map(|path| [vec![name.clone()], path].concat()).collect();
    }
    let Some(group) = tree.strip_prefix('{') else { return vec![] };
    let (mut depth, mut start, mut paths) = (0, 0, Vec::new());
    for (at, character) in group.char_indices() {
        match character {
            '{' => depth += 1,
            ',' | '}' if depth == 0 => {
                paths.extend(expanded(group[start..at].trim()));
                start = at + 1;
                if character == '}' {
                    break;
                }
            }
            '}' => depth -= 1,
            _ => {}
        }
    }
    paths
}

/// The paths within the crate that the module `names` of this `text` leads to by `crate::` and `super::`.
fn paths(names: &[String], text: &str) -> Vec<Vec<String>> {
    let mut paths = Vec::new();
    // The modules within the file, by their indents.
    let mut inner: Vec<usize> = Vec::new();
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let (code, indent) = (line.trim(), line.len() - line.trim_start().len());
        if !code.starts_with("//") {
            if code.contains("mod ") && code.ends_with('{') {
                inner.push(indent);
            } else if code == "}" && inner.last() == Some(&indent) {
                inner.pop();
            }
            for key in ["crate::", "super::"] {
                for (at, _) in line.match_indices(key) {
                    let before = line[..at].chars().next_back();
                    if before.is_some_and(|it| it.is_alphanumeric() || "_:$".contains(it)) {
                        continue;
                    }
                    let mut tree = &text[offset + at + key.len()..];
                    let mut ups = usize::from(key == "super::");
                    while let Some(rest) = tree.strip_prefix("super::") {
                        (tree, ups) = (rest, ups + 1);
                    }
                    let outer = match ups {
                        0 => &[][..],
                        _ => &names[..names.len().saturating_sub(ups.saturating_sub(inner.len()))],
                    };
                    let found = expanded(tree).into_iter();
                    paths.extend(found.map(|path| [outer, &path].concat()));
                }
            }
        }
        offset += line.len();
    }
    paths
}

/// Whether an arrow leads from `one` back to it along `arrows`.
fn is_in_a_ring(one: &str, arrows: &BTreeSet<(String, String)>) -> bool {
    let mut reached = BTreeSet::from([one]);
    loop {
        let next = arrows.iter().filter(|(from, _)| reached.contains(from.as_str()));
        let next: Vec<&str> = next.map(|(_, to)| to.as_str()).collect();
        if next.contains(&one) {
            return true;
        }
        let known = reached.len();
        reached.extend(next);
        if reached.len() == known {
            return false;
        }
    }
}

/// Faults in the imports of `files`, a sentence each.
fn faults(files: &[File]) -> Vec<String> {
    let floor = |name: Option<&String>| FLOORS.iter().position(|it| name.is_some_and(|n| n == it));
    let rooms: BTreeSet<&[String]> = files.iter().filter_map(|(names, _)| names.get(..2)).collect();
    let mut faults = Vec::new();
    let mut arrows = BTreeSet::new();
    for (names, text) in files {
        let Some(from) = floor(names.first()) else {
            if names != &["lib"] {
                faults.push(format!("{} is on no floor", names.join("::")));
            }
            continue;
        };
        for path in paths(names, text) {
            let arrow = || format!("{} -> {}", names.join("::"), path.join("::"));
            match floor(path.first()) {
                None => faults.push(format!("{} names no floor", arrow())),
                Some(to) if to > from => faults.push(format!("{} points up", arrow())),
                Some(to) if to == from && path.get(..2).is_some_and(|it| !rooms.contains(it)) => {
                    faults.push(format!("{} names no room of its own floor", arrow()));
                }
                Some(to) if to == from => {
                    if let [Some(one), Some(other)] = [names.get(1), path.get(1)]
                        && one != other
                    {
                        let room = |name: &String| format!("{}::{name}", FLOORS[from]);
                        arrows.insert((room(one), room(other)));
                    }
                }
                Some(_) => {}
            }
        }
    }
    let rooms: BTreeSet<&String> = arrows.iter().map(|(from, _)| from).collect();
    let ringed = rooms.into_iter().filter(|room| is_in_a_ring(room, &arrows));
    faults.extend(ringed.map(|room| format!("{room} is in a ring of imports")));
    faults
}

fn lab() -> Vec<File> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    files_of(&root, &root, &mut files);
    files
}

#[test]
fn no_import_of_the_lab_points_up() {
    let files = lab();
    let arrows: usize = files.iter().map(|(names, text)| paths(names, text).len()).sum();
    assert!(files.len() > 200 && arrows > 1000, "{} files, {arrows} imports", files.len());
    let faults = faults(&files);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn crates_depend_on_those_below_them() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (folder, allowed) in CRATES {
        let text = fs::read_to_string(root.join(folder).join("Cargo.toml")).unwrap();
        let file: toml::Table = text.parse().unwrap();
        let dependencies = file["dependencies"].as_table().unwrap().keys();
        for name in dependencies.filter(|name| name.starts_with("lyapunov")) {
            assert!(allowed.contains(&name.as_str()), "{folder} depends on {name}");
        }
    }
}

fn told(files: &[(&str, &str)]) -> Vec<String> {
    let files: Vec<File> =
        files.iter().map(|(path, text)| (names(path), (*text).to_owned())).collect();
    faults(&files)
}

#[test]
fn an_arrow_that_points_up_is_caught() {
    let up = "files::scene::keys -> studies::map::Grid points up";
    let in_a_group =
        "use crate::{\n    text::{\n        words,\n    },\n    studies::map::Grid,\n};\n";
    for text in [
        "use crate::studies::map::Grid;\n",
        in_a_group,
        "use super::super::super::studies::map::Grid;\n",
        "fn of() -> crate::studies::map::Grid {\n}\n",
        "mod tests {\n    use super::super::super::super::studies::map::{Grid};\n}\n",
    ] {
        assert_eq!(told(&[("files/scene/keys.rs", text)]), [up], "{text}");
    }
    let down =
        "// crate::studies::map\nuse crate::text::{words, numbers::found};\nuse super::Draft;\n";
    assert!(told(&[("files/scene/keys.rs", down)]).is_empty());
    let by_the_roof = "studies::map::run -> Scene names no floor";
    assert_eq!(told(&[("studies/map/run.rs", "use crate::Scene;\n")]), [by_the_roof]);
    assert_eq!(told(&[("words.rs", "")]), ["words is on no floor"]);
    let by_the_floor = "studies::map::run -> studies::Limits names no room of its own floor";
    assert_eq!(told(&[("studies/map/run.rs", "use crate::studies::Limits;\n")]), [by_the_floor]);
}

#[test]
fn a_ring_of_rooms_is_caught() {
    let ring = [
        ("measure/share.rs", "use super::{trace::Trace, timing};\n"),
        ("measure/trace.rs", "use crate::measure::balance::Balance;\n"),
        ("measure/balance/law.rs", "use super::super::share::Share;\nuse super::Balance;\n"),
        ("measure/timing.rs", "use crate::files::scene::Scene;\n"),
    ];
    let rooms = ["balance", "share", "trace"];
    assert_eq!(told(&ring), rooms.map(|it| format!("measure::{it} is in a ring of imports")));
    let open = ring.map(|(path, text)| (path, if path.contains("law") { "" } else { text }));
    assert!(told(&open).is_empty());
}
