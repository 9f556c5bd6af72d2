//! Lines of a label and a text, as the terminal shows them, on a page.

use maud::{Markup, html};

use super::html::coded;

/// Blanks that separate a label from its text.
const GAP: &str = "  ";

/// The `lines` as rows of label and text: a line without a label goes on with the text of the one above.
pub(crate) fn labelled(lines: &str) -> Markup {
    table(&rows(lines))
}

/// The same, with `parts`, a line each, in place of the text of the row `label`: lines do not tell folds from breaks.
pub(crate) fn labelled_in_parts(lines: &str, label: &str, parts: &[String]) -> Markup {
    let mut rows = rows(lines);
    if let Some((_, text)) = rows.iter_mut().find(|it| it.0 == label && !parts.is_empty()) {
        *text = parts.join("\n");
    }
    table(&rows)
}

fn table(rows: &[(&str, String)]) -> Markup {
    html! {
        div.wide {
            table.facts {
                tbody { @for (label, text) in rows { tr { th scope="row" { (label) } td { (coded(text)) } } } }
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

    #[test]
    fn parts_stand_in_lines_of_their_own_and_names_are_code() {
        let lines = "  columns     x is `x [mm]`\n  bad rows    2; left\n              line 5\n";
        let parts = ["2; left".to_owned(), "line 5".to_owned()];
        let page = labelled_in_parts(lines, "bad rows", &parts).into_string();
        assert!(page.contains("<td>2; left\nline 5</td>"), "{page}");
        assert!(page.contains("<td>x is <code>x [mm]</code></td>"), "{page}");
        assert!(labelled_in_parts(lines, "bad rows", &[]).into_string().contains("left line 5"));
    }
}
