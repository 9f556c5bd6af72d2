//! The header and the table of the binary interface, as the compiled functions have them.
//!
//! `LYAPUNOV_WRITE=1 cargo test --features describe --test header` writes both.

use std::collections::BTreeSet;
use std::path::Path;

use lyapunov_c::abi::ABI;
use lyapunov_c::describe::Header;

const TOP: &str = "\
/* Stabilizers for sampled control loops. Generated from the library's functions: do not edit.
 *
 * Efforts resist the motion: positive power, effort times velocity, flows into the environment. Units are SI, angles in
 * radians. Storage is yours: a struct on the stack, static, or in a pool of your own; init makes it a block. Functions
 * that are handed a null or misaligned pointer, or storage that init has not seen, do nothing and say so.
 * A pointer leads to a variable that nobody else touches meanwhile. See README.md beside this file.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef LYAPUNOV_H
#define LYAPUNOV_H

#include <stddef.h>
#include <stdint.h>

";

const FRAME: &str = "
#ifndef LYAPUNOV_API
#define LYAPUNOV_API extern
#endif

#if defined(__cplusplus)
#define LYAPUNOV_ASSERT(what, name) static_assert(what, #name)
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define LYAPUNOV_ASSERT(what, name) _Static_assert(what, #name)
#else
#define LYAPUNOV_ASSERT(what, name) typedef char name##_is_as_in_the_library[(what) ? 1 : -1]
#endif

#ifdef __cplusplus
extern \"C\" {
#endif

";

const BOTTOM: &str = "
#ifdef __cplusplus
}
#endif

#endif
";

fn checked_in(path: &str, now: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    if std::env::var_os("LYAPUNOV_WRITE").is_some() {
        std::fs::write(&path, now).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = kept.lines().zip(now.lines()).position(|(kept, now)| kept != now);
    assert!(
        kept == now,
        "{} is out of date from line {} on: LYAPUNOV_WRITE=1 cargo test --features describe --test header writes it",
        path.display(),
        differs.unwrap_or(0) + 1
    );
}

#[test]
fn the_header_is_that_of_the_functions() {
    let header = Header::whole();
    let version = format!(
        "/* Version of the binary interface; init refuses another one. */\n#define LYAPUNOV_ABI {ABI}u\n"
    );
    let text = [TOP, &version, FRAME, header.text.trim_end(), "\n", BOTTOM].concat();
    checked_in("include/lyapunov.h", &text);
}

#[test]
fn the_classes_are_those_of_the_functions() {
    let frame = include_str!("../src/describe/frame.hpp");
    let text = frame.replace("// The classes, generated.\n", &Header::whole().classes());
    checked_in("include/lyapunov.hpp", &text);
}

/// Verbs of the header that the README's table does not explain cannot be found, and others cannot be called.
#[test]
fn the_readme_has_all_verbs() {
    let header = Header::whole();
    let blocks: BTreeSet<_> = header.blocks.iter().map(|(name, _)| format!("{name}_")).collect();
    let verb = |name: &str| {
        let block = blocks.iter().find(|block| name.starts_with(block.as_str()))?;
        Some(name[block.len()..].trim_end_matches("_abi").to_string())
    };
    let there: BTreeSet<_> = header.described.iter().filter_map(|it| verb(it.name())).collect();
    let table = include_str!("../README.md").split("| verb | does |\n|---|---|\n").nth(1);
    let rows = table.expect("the table of verbs").lines().take_while(|line| line.starts_with('|'));
    let told: BTreeSet<_> = rows
        .filter_map(|row| row.split('|').nth(1))
        .flat_map(|verbs| verbs.split('`').skip(1).step_by(2).map(String::from))
        .collect();
    assert_eq!(told, there);
}

/// A line that differs or is gone breaks programs that are compiled already; a line that is new does not.
#[test]
fn the_binary_interface_changes_with_its_version() {
    let now = Header::whole().table;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("abi.txt");
    let kept = std::fs::read_to_string(path).unwrap_or_default();
    let lines: BTreeSet<_> = now.lines().collect();
    let same_version = kept.lines().next() == now.lines().next();
    let gone: Vec<_> = kept.lines().filter(|line| !lines.contains(line)).collect();
    assert!(
        !same_version || gone.is_empty(),
        "programs rely on what is no longer so: raise ABI in src/abi.rs, then write the table anew.\n{}",
        gone.join("\n")
    );
    checked_in("abi.txt", &now);
}
