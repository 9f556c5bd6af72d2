//! Names and numbers in columns.

use std::fmt;

const BETWEEN: &str = "  ";

/// Rows of a name and what it came to, under headings of several lines.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    /// The lines above the rule; the last one has the units.
    pub(crate) headings: Vec<Vec<String>>,
    /// As many cells in each row as in each heading.
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    fn widths(&self) -> Vec<usize> {
        let mut widths = Vec::new();
        for line in self.headings.iter().chain(&self.rows) {
            widths.resize(widths.len().max(line.len()), 0);
            for (width, cell) in widths.iter_mut().zip(line) {
                *width = cell.chars().count().max(*width);
            }
        }
        widths
    }

    /// How wide everything to the right of the names is.
    pub(crate) fn width_of_numbers(&self) -> usize {
        self.widths().iter().skip(1).map(|width| BETWEEN.len() + width).sum()
    }

    /// The table in HTML.
    pub(super) fn to_html(&self) -> String {
        let class = |column: usize, cell: &str| match (column, cell) {
            (0, _) => "",
            (_, "yes") => " class=\"yes\"",
            (_, "no") => " class=\"no\"",
            _ => " class=\"number\"",
        };
        let columns = self.headings.first().map_or(0, Vec::len);
        let heading = |column: usize| {
            let words = self.headings.iter().map(|line| line[column].as_str());
            let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
            let class = if words == ["bounded"] { "" } else { class(column, "") };
            format!("<th{class}>{}</th>", words.join(" "))
        };
        let row = |row: &Vec<String>| {
            let cells = row.iter().enumerate();
            let cells = cells.map(|(i, cell)| format!("<td{}>{cell}</td>", class(i, cell)));
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        format!(
            "<div class=\"wide\"><table class=\"short\">\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n\
             </table></div>\n",
            (0..columns).map(heading).collect::<String>(),
            self.rows.iter().map(row).collect::<String>()
        )
    }
}

impl fmt::Display for Table {
    /// Names to the left, everything else to the right.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let widths = self.widths();
        for (index, line) in self.headings.iter().chain(&self.rows).enumerate() {
            if index == self.headings.len() {
                let rules: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
                writeln!(f, "{}", rules.join(BETWEEN))?;
            }
            let cells = line.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
                if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            });
            writeln!(f, "{}", cells.collect::<Vec<_>>().join(BETWEEN).trim_end())?;
        }
        Ok(())
    }
}
