//! Random texts: no text may cause a panic, and every fault must be presentable.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use super::FULL;
use crate::files::scene::Scene;

/// An edit of a text's bytes; the positions count within the text before this edit.
#[derive(Clone, Debug)]
enum Edit {
    Delete(Index, usize),
    Duplicate(Index, usize),
    Swap(Index, Index),
    Insert(Index, Vec<u8>),
}

impl Edit {
    fn apply(&self, bytes: &mut Vec<u8>) {
        if bytes.is_empty() {
            return;
        }
        let (length, part) = (bytes.len(), |at: &Index, count: usize| {
            let start = at.index(bytes.len());
            start..(start + count).min(bytes.len())
        });
        match self {
            Self::Delete(at, count) => {
                let part = part(at, *count);
                bytes.drain(part);
            }
            Self::Duplicate(at, count) => {
                let part = part(at, *count);
                let copy = bytes[part.clone()].to_vec();
                bytes.splice(part.end..part.end, copy);
            }
            Self::Swap(one, other) => bytes.swap(one.index(length), other.index(length)),
            Self::Insert(at, new) => {
                let at = at.index(length);
                bytes.splice(at..at, new.iter().copied());
            }
        }
    }
}

/// Bytes with a meaning in TOML or in a scene, and any others.
fn inserted() -> impl Strategy<Value = Vec<u8>> {
    let words = select(vec![
        "=",
        ".",
        "\"",
        "'",
        "[",
        "]",
        "{",
        "}",
        "#",
        "\n",
        "\r\n",
        ",",
        "-",
        "+",
        "_",
        "e999",
        "inf",
        "nan",
        "0x",
        "true",
        "\"\"\"",
        "[[",
        "[stabilizer.popc]\n",
        "[environment.",
        "1979-05-27",
        "é",
        "\u{feff}",
        "\u{202e}",
        "\\u",
        "99999999999999999999",
        "stabilizer = ",
        "a.b.c = ",
    ]);
    prop_oneof![words.prop_map(|word| word.as_bytes().to_vec()), vec(any::<u8>(), 1..4)]
}

fn edit() -> impl Strategy<Value = Edit> {
    prop_oneof![
        (any::<Index>(), 1..40_usize).prop_map(|(at, count)| Edit::Delete(at, count)),
        (any::<Index>(), 1..40_usize).prop_map(|(at, count)| Edit::Duplicate(at, count)),
        (any::<Index>(), any::<Index>()).prop_map(|(one, other)| Edit::Swap(one, other)),
        (any::<Index>(), inserted()).prop_map(|(at, bytes)| Edit::Insert(at, bytes)),
    ]
}

/// The property of every text: it gives a sound scene, or a fault that can be shown and points into the text.
fn holds(text: &str) -> Result<(), TestCaseError> {
    match Scene::parse(text, "edited.toml") {
        Ok(scene) => {
            prop_assert_eq!(scene.to_draft().check(), Ok(scene.clone()));
            prop_assert!(scene.ticks() <= 1_000_000_000);
            prop_assert!(scene.environment_ratio() >= 1);
            prop_assert!(scene.period().is_finite() && scene.period() > 0.0);
            let written = toml::to_string(&scene).unwrap();
            prop_assert_eq!(Scene::parse(&written, "written.toml"), Ok(scene));
        }
        Err(fault) => {
            let shown = fault.to_string();
            prop_assert!(shown.starts_with("error: edited.toml:"));
            prop_assert!(!fault.message().is_empty());
            prop_assert!(!fault.help().is_empty(), "{}", shown);
            let lines = text.matches('\n').count() + 1;
            prop_assert!(fault.line().is_none_or(|line| (1..=lines).contains(&line)));
            prop_assert!(
                shown.lines().skip(1).all(|line| line.chars().count() <= 100),
                "{}",
                shown
            );
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn an_edited_scene_is_read_or_refused(edits in vec(edit(), 1..6)) {
        let mut bytes = FULL.as_bytes().to_vec();
        for edit in &edits {
            edit.apply(&mut bytes);
        }
        holds(&String::from_utf8_lossy(&bytes))?;
    }

    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        holds(&text)?;
    }

    #[test]
    fn any_words_are_read_or_refused(words in vec(inserted(), 0..30)) {
        holds(&String::from_utf8_lossy(&words.concat()))?;
    }

    #[test]
    fn any_number_is_read_exactly_or_refused(bits in any::<u64>()) {
        let value = f64::from_bits(bits);
        let text = super::with("rest = 0.0", &format!("rest = {value:?}").replace("NaN", "nan"));
        match Scene::parse(&text, "number.toml") {
            Ok(scene) => prop_assert_eq!(scene.operator.rest.get(), value),
            Err(fault) => prop_assert!(!value.is_finite(), "{}", fault),
        }
    }
}
