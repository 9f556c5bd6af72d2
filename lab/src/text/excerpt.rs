//! A place in a text: line, column and a marked line for the terminal.

use std::ops::Range;

/// The widest source text shown; with the margin it fits in 100 columns.
const WIDTH: usize = 88;

/// The longest name or value shown within a sentence, in characters.
const SHORT: usize = 40;

/// A line of a text with a part of it marked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Excerpt {
    /// Line number, from 1.
    pub(crate) line: usize,
    /// Column of the mark in characters, from 1.
    pub(crate) column: usize,
    shown: String,
    mark: String,
}

impl Excerpt {
    /// The excerpt of the line in which the span begins; a span beyond the text marks the end of the text.
    pub(crate) fn new(text: &str, span: Range<usize>) -> Self {
        let start = boundary(text, span.start);
        let end = boundary(text, span.end).max(start);
        let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
        let line = text[line_start..line_end].trim_end_matches('\r');
        let before = text[line_start..start].chars().count();
        let marked = text[start..end.min(line_end)].trim_end().chars().count();
        let (shown, mark) = window(line, before, marked.max(1));
        Self { line: text[..start].matches('\n').count() + 1, column: before + 1, shown, mark }
    }

    /// The line with its number, and the mark below it.
    pub(crate) fn render(&self) -> String {
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        format!("{margin} |\n{number} | {}\n{margin} | {}", self.shown, self.mark)
    }
}

/// The shown part of a line and the mark below it: the whole line, or a part around the mark if the line is too long.
fn window(line: &str, before: usize, marked: usize) -> (String, String) {
    let length = line.chars().count();
    if length <= WIDTH {
        let mark = " ".repeat(before) + &"^".repeat(marked);
        return (legible(line), mark);
    }
    let marked = marked.min(WIDTH / 2);
    let first = before.saturating_sub((WIDTH - marked) / 2).min(length - WIDTH);
    let mut shown: String = line.chars().skip(first).take(WIDTH).map(printable).collect();
    let mut indent = before - first;
    if first > 0 {
        shown.insert_str(0, "...");
        indent += 3;
    }
    if first + WIDTH < length {
        shown.push_str("...");
    }
    (shown, " ".repeat(indent) + &"^".repeat(marked))
}

/// The text as part of a sentence: one line, without control characters, cut if it is long.
pub(crate) fn shorten(text: &str) -> String {
    let mut short: String = text.chars().take(SHORT).map(printable).collect();
    if text.chars().nth(SHORT).is_some() {
        short.push_str("...");
    }
    short
}

/// The text without characters that could control the terminal: a file may be called anything.
pub fn legible(text: &str) -> String {
    text.chars().map(printable).collect()
}

/// The character, or a substitute if it could control the terminal, reverse the text or take other than one column.
fn printable(character: char) -> char {
    match character {
        '\t' => ' ',
        '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => '\u{fffd}',
        control if control.is_control() => '\u{fffd}',
        character => character,
    }
}

/// The start of the character that contains this byte, or the end of the text.
pub(crate) fn boundary(text: &str, offset: usize) -> usize {
    let mut offset = offset.min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}
