//! Displayed form of a comparison.

use std::fmt;

use lyapunov_figures::Figure;
use maud::html;

use super::compared::Compared;
use crate::show::beside::{beside, unfit};
use crate::show::html;
use crate::show::table::Table;

/// A comparison as it is shown; in the terminal it takes 100 columns at most, unless a name is longer.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The name of the file.
    pub name: String,
    /// The file in one line.
    pub setting: String,
    /// The values at the start that the columns are compared with, in clauses that `; ` separates: one line each.
    pub start: String,
    /// A row for each entrant.
    pub(crate) tables: Vec<Table>,
    /// The runs, drawn.
    pub figure: Figure,
    /// The caption of the figure, a sentence or two.
    pub caption: &'static str,
    /// The curves of the figure as comma-separated values, in numbers that read back exactly.
    pub csv: String,
}

impl fmt::Display for Sheet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}\n{}", self.name, self.setting, self.start.replace("; ", "\n"))?;
        self.tables.iter().try_for_each(|table| write!(f, "\n{table}"))
    }
}

/// The `sheets` of comparisons `C` as a page, in HTML; `command` made them, and `left_out` has the files that did not fit, with
/// the reasons.
pub fn page<C: Compared>(sheets: &[Sheet], left_out: &[String], command: &str) -> String {
    let rows = format!("a row for each {} and stabilizer", C::NOUN);
    let body = html! {
        p { "By " (html::maker(command)) "." }
        p { (C::ABOUT) }
        (unfit(left_out))
        @for sheet in sheets {
            h2 { (sheet.name) }
            p { (sheet.start) "." }
            (html::figure(None, &sheet.figure, &html! { (sheet.caption) }))
            @for table in &sheet.tables { (table.to_html("short")) }
        }
        (beside(&[("compare.csv", &rows), ("compare.json", "the same, and the settings")]))
    };
    html::page(C::TITLE, &body)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::table::Heading;
    use crate::studies::compare::models::Comparison;

    #[test]
    fn the_name_of_a_file_is_escaped() {
        let hostile = "<img src=x onerror=alert(1)>&";
        let table = Table::new([Heading::word(hostile)]).with_rows([[hostile.into()]]);
        let sheet = Sheet {
            name: hostile.to_owned(),
            setting: hostile.to_owned(),
            start: hostile.to_owned(),
            tables: vec![table],
            figure: Figure::new(hostile),
            caption: "",
            csv: String::new(),
        };
        let page = page::<Comparison>(&[sheet], &[hostile.to_owned()], hostile);
        assert!(!page.contains("<img"), "{page}");
        // Command, reason, name, start, heading and cell, and the drawing's title, which occurs twice.
        assert_eq!(page.matches("&lt;img src=x onerror=alert(1)&gt;&amp;").count(), 8, "{page}");
    }
}
