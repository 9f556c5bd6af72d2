//! Text for a terminal.

/// The widest line.
pub(super) const WIDTH: usize = 98;

/// The text folded between words, every line but the first behind `margin` blanks; the first one already has
/// as many columns in use.
pub(super) fn fold(text: &str, margin: usize) -> String {
    let mut folded = String::new();
    let mut column = margin;
    for word in text.split(' ') {
        let length = word.chars().count();
        if column > margin && column + 1 + length > WIDTH {
            folded.push('\n');
            folded.extend(std::iter::repeat_n(' ', margin));
            column = margin;
        } else if column > margin {
            folded.push(' ');
            column += 1;
        }
        folded.push_str(word);
        column += length;
    }
    folded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_text_is_folded_between_words() {
        let text = "word ".repeat(60);
        let folded = fold(text.trim_end(), 14);
        assert!(folded.lines().count() > 2);
        for (index, line) in folded.lines().enumerate() {
            assert!(line.len() + if index == 0 { 14 } else { 0 } <= WIDTH);
            assert!(index == 0 || line.starts_with("              word"));
        }
        assert_eq!(fold("short text", 14), "short text");
    }
}
