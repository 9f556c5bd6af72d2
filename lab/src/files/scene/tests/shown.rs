//! The form of a message.

use super::{SMALLEST, fault, smallest_and, with};

#[test]
fn a_message_has_one_form() {
    let text = "duration = 1.0\nservo_rate = 1000.0\n[device]\nmass = 0.2\n[environment.wall]\n  stifness = 8e3";
    let expected = "\
error: test.toml:6:3: unknown key `stifness` in [environment.wall]
  |
6 |   stifness = 8e3
  |   ^^^^^^^^
  = did you mean `stiffness`?
  = known keys here: position, stiffness, damping";
    assert_eq!(fault(text).to_string(), expected);
}

#[test]
fn the_mark_is_under_the_fault_also_after_tabs_and_letters_of_more_bytes() {
    let fault = fault(&smallest_and("[operator]\n\t\"größe\".mass = 1"));
    let shown = fault.to_string();
    assert_eq!(fault.column(), Some(2), "{shown}");
    assert!(shown.contains("|  \"größe\".mass = 1\n  |  ^^^^^^^\n"), "{shown}");
}

#[test]
fn line_and_column_are_the_same_with_other_line_ends() {
    let text = with("mass = 0.2", "mass = -0.2");
    let expected = fault(&text);
    for other in [text.replace('\n', "\r\n"), format!("\u{feff}{text}")] {
        let fault = fault(&other);
        assert_eq!((fault.line(), fault.column()), (expected.line(), expected.column()));
        assert_eq!(fault.to_string(), expected.to_string());
    }
}

#[test]
fn no_line_is_wider_than_a_terminal() {
    let long = "x".repeat(100_000);
    let texts = [
        format!("{long} = 1\n{SMALLEST}"),
        format!("{SMALLEST}\n[{long}.{long}]"),
        format!("\"{long}\" = \"{long}\""),
        format!("velocity = \"{long}\"\n{SMALLEST}"),
        format!("duration = {}\n{SMALLEST}", "9".repeat(100_000)),
        format!("x = {{ {} ", "a = 1, ".repeat(1000)),
        format!("device = {{ damping = 0.0, {}mass = \"m\" }}", " ".repeat(1000)),
        format!("duration = 1.0 # {long}\n duration = 2 # {long}"),
        smallest_and(&format!("[stabilizer]\n{long} = 1\n{long}y = 1")),
        smallest_and(&format!("[operator]\nmass = {long}")),
    ];
    for text in texts {
        let fault = fault(&text);
        let shown = fault.to_string();
        for line in shown.lines() {
            let width = line.chars().count();
            // The headline is one line, so that it can be searched for; its parts are short.
            let most = if line.starts_with("error:") { 160 } else { 100 };
            assert!(width <= most, "{width} columns:\n{shown}");
        }
        assert!(shown.contains('^'), "{shown}");
        assert!(fault.key().is_none_or(|key| key.len() < 200));
        assert!(fault.value().is_none_or(|value| value.len() < 200));
    }
}

#[test]
fn a_message_cannot_command_the_terminal() {
    for text in [
        "\"\\u001b[31m\" = 1",
        "velocity = \"\\u001b\u{202e}\"",
        "x = \u{1b}[31m",
        "\"a\\nb\" = 1",
        "\u{202e} = 1",
    ] {
        let shown = fault(text).to_string();
        let bad = |character: char| {
            character != '\n' && (character.is_control() || character == '\u{202e}')
        };
        assert!(!shown.contains(bad), "{shown:?}");
    }
}
