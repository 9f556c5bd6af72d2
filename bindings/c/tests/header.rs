//! The headers, as the compiled functions have them.
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

/* A status that nobody looks at is a refusal that nobody hears of. Define it as nothing to do without the warning. */
#ifndef LYAPUNOV_MUST_LOOK_AT
#ifdef __GNUC__
#define LYAPUNOV_MUST_LOOK_AT __attribute__((warn_unused_result))
#else
#define LYAPUNOV_MUST_LOOK_AT
#endif
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

fn kept(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap_or_default()
}

fn checked_in(path: &str, now: &str) {
    if std::env::var_os("LYAPUNOV_WRITE").is_some() {
        std::fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join(path), now).unwrap();
    }
    let kept = kept(path);
    let differs = kept.lines().zip(now.lines()).position(|(kept, now)| kept != now);
    assert!(
        kept == now,
        "{path} is out of date from line {} on: LYAPUNOV_WRITE=1 cargo test --features describe --test header writes it",
        differs.unwrap_or(0) + 1
    );
}

/// The lines that compiled programs rely on: sizes and offsets, tags, signatures, enumerators.
fn promises(header: &str) -> BTreeSet<String> {
    let mut of = "";
    let mut told = BTreeSet::new();
    for line in header.lines() {
        of = line.strip_prefix("typedef struct ").map_or(of, |name| name.trim_end_matches(" {"));
        if let Some(tag) = line.strip_prefix("    /* Set by init: ") {
            told.extend(tag.split_once('.').map(|(tag, _)| format!("{of} has the tag {tag}")));
        } else if line.starts_with("    LYAPUNOV_") {
            told.extend(line.split([',', '/']).next().map(|line| line.trim().to_string()));
        } else if line.starts_with("LYAPUNOV_") || line.starts_with("typedef ") {
            told.extend(line.strip_suffix(';').map(String::from));
        }
    }
    told
}

/// A promise that differs or is gone breaks programs that are compiled already; one that is new does not. It is looked at before
/// the header is written anew.
#[test]
fn the_header_is_that_of_the_functions() {
    let header = Header::whole();
    let version = format!("#define LYAPUNOV_ABI {ABI}u\n");
    let about = "/* Version of the binary interface; init refuses another one. */\n";
    let text = [TOP, about, &version, FRAME, header.text.trim_end(), "\n", BOTTOM].concat();
    let (kept, now) = (kept("include/lyapunov.h"), promises(&text));
    let gone: Vec<_> = promises(&kept).difference(&now).cloned().collect();
    assert!(
        !kept.contains(&version) || gone.is_empty(),
        "programs rely on what is no longer so: raise ABI in src/abi.rs, then write the header anew.\n{}",
        gone.join("\n")
    );
    checked_in("include/lyapunov.h", &text);
}

/// No two blocks share a tag.
#[test]
fn tags_differ() {
    let promises = promises(&Header::whole().text);
    let tags: Vec<_> = promises.iter().filter_map(|it| it.split_once(" has the tag ")).collect();
    let different: BTreeSet<_> = tags.iter().map(|(_, tag)| tag).collect();
    assert!(tags.len() > 200 && different.len() == tags.len());
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
