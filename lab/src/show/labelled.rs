//! Lines of a label and a text, as the terminal shows them, on a page.

use maud::{Markup, html};

/// Blanks that separate a label from its text.
const GAP: &str = "  ";

/// The `lines` as rows of label and text: a line without a label goes on with the text of the one above.
pub(crate) fn labelled(lines: &str) -> Markup {
    let rows = rows(lines);
    html! {
        div.wide {
            table.facts {
                tbody { @for (label, text) in &rows { tr { th scope="row" { (label) } td { (text) } } } }
            }
        }
    }
}

fn rows(lines: &str) -> Vec<(&str, String)> {
    let mut rows: Vec<(&str, String)> = Vec::new();
    for line in lines.lines().filter(|line| !line.trim().is_empty()) {
        let indent = line.len() - line.trim_start().len();
        let (label, text) = line.trim().split_once(GAP).unwrap_or(("", line.trim()));
        match rows.last_mut() {
            Some((_, told)) if indent > GAP.len() => *told += &format!(" {}", line.trim()),
            _ => rows.push((label, text.trim().to_owned())),
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folded_text_is_one_cell() {
        let told = rows(
            "  verdict      settles: within\n               0.2 mm\n\n  energy       5 mJ <b>\n",
        );
        let expected =
            [("verdict", "settles: within 0.2 mm".to_owned()), ("energy", "5 mJ <b>".to_owned())];
        assert_eq!(told, expected);
        assert!(!labelled("  energy       5 mJ <b>\n").into_string().contains("<b>"));
    }
}
