//! Messages about text that is not TOML.

use super::{SMALLEST, fault, line_of, with};

/// A part of the full example, its replacement, and words that the message must contain.
#[rustfmt::skip]
const CASES: &[(&str, &str, &[&str])] = &[
    ("duration = 10.0 ", "duration = 10,0 ", &["`10,0` is not a number", "comma"]),
    ("duration = 10.0 ", "duration = 10 s ", &["`10 s` is not a number", "without a unit"]),
    ("duration = 10.0 ", "duration = 10. ", &["not a number"]),
    ("duration = 10.0 ", "duration = .5 ", &["not a number"]),
    ("duration = 10.0 ", "duration = 1.5.5 ", &["not a number"]),
    ("duration = 10.0 ", "duration = 010 ", &["begin with a zero"]),
    ("duration = 10.0 ", "duration = Inf ", &["small letters: inf"]),
    ("duration = 10.0 ", "duration = ", &["a value is missing"]),
    ("duration = 10.0 ", "duration 10.0 ", &["followed by `=`"]),
    ("duration = 10.0 ", "duration == 10.0 ", &["one `=` too many"]),
    ("duration = 10.0 ", "= 10.0 ", &["name of a key is missing"]),
    ("duration = 10.0 ", "duration = 10.0; ", &["not a number"]),
    ("duration = 10.0 ", "// note", &["a comment begins with #"]),
    ("\"f64\"", "f64", &["`f64` lacks its quotes", "scalar = \"f64\""]),
    ("\"exact\" ", "exact ", &["lacks its quotes", "write \"exact\""]),
    ("integrator = \"exact\"", "integrator = \"exact", &["lacks its closing quote"]),
    ("[device] ", "[device ", &["lacks its closing `]`"]),
    ("[device] ", "[device]] ", &["line should end here"]),
    ("[device] ", "[] ", &["name of a key is missing"]),
    ("[device] ", "[operator] ", &["`operator` is given twice"]),
    ("mass = 0.2", "mass = 0.2\nmass = 0.3", &["`mass` is given twice", "keep one"]),
    ("rest = 0.0", "rest = [0.0", &["closing `]`"]),
    ("rest = 0.0", "rest = { m = 0.0", &["closing `}`"]),
    ("[stabilizer.lolc]", "[duration.lolc]", &["has a value already"]),
];

#[test]
fn broken_text_is_reported_in_plain_words() {
    for (part, replacement, words) in CASES {
        let text = with(part, replacement);
        let fault = fault(&text);
        let shown = fault.to_string();
        for word in *words {
            assert!(shown.contains(word), "no {word:?} in:\n{shown}");
        }
        let line = line_of(part, replacement);
        // The parser notices a list or table that is never closed only further down.
        assert!(fault.line() >= Some(line), "{shown}");
        if !shown.contains("closing `") {
            assert!(fault.line() <= Some(line + 1), "{shown}");
        }
    }
}

#[test]
fn the_key_is_reported_where_the_text_allows_it() {
    let key = |part, replacement| fault(&with(part, replacement)).key().map(str::to_owned);
    assert_eq!(key("mass = 0.2", "mass = 0,2").as_deref(), Some("device.mass"));
    assert_eq!(key("\"held\"", "held").as_deref(), Some("stabilizer.lolc.work"));
    assert_eq!(key("mass = 0.2", "mass = 0.2\nmass = 0.3").as_deref(), Some("device.mass"));
    assert_eq!(key("[device] ", "[operator] ").as_deref(), Some("operator"));
    assert_eq!(key("[device] ", "[device "), None);
}

#[test]
fn a_text_that_ends_too_soon_points_to_its_end() {
    let fault = fault("duration = 10.0\nservo_rate =\n\n\n");
    assert_eq!((fault.line(), fault.column()), (Some(2), Some(13)));
    assert_eq!(fault.message(), "a value is missing after `=`");
}

#[test]
fn a_control_character_and_deep_nesting_are_refused() {
    for text in ["a = 1\u{7}", "# \u{1}\n", "a = 1\rb = 2", "\u{7f}"] {
        assert!(fault(text).line().is_some());
    }
    let deep = format!("{SMALLEST}\nx = {}{}", "[".repeat(5000), "]".repeat(5000));
    assert!(fault(&deep).to_string().contains("nested too deeply"));
    let deep = format!("{} = 1", vec!["a"; 5000].join("."));
    assert!(fault(&deep).to_string().contains("nested too deeply"));
}

#[test]
fn an_empty_text_shows_the_smallest_scene() {
    for text in ["", "\n\n", "# only a comment\n", "\u{feff}", "\r\n"] {
        let shown = fault(text).to_string();
        assert!(shown.contains("the scene is empty"), "{shown}");
        for line in SMALLEST.lines() {
            assert!(shown.contains(line), "{shown}");
        }
    }
}
