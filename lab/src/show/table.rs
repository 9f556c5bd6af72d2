//! Names and numbers in columns, for the terminal and for a page.

use std::borrow::Cow;
use std::fmt;

use maud::{Markup, html};
use textwrap::core::display_width;
use textwrap::{Options, WordSplitter};

use super::html::verdict;
use crate::text::{found, legible};

/// The widest line in the terminal.
const WIDEST: usize = 100;

/// The least width that the first column keeps.
const SHORTEST: usize = 8;

const BETWEEN: &str = "  ";

/// Rows of cells under headings. `Display` shows it in the terminal, in 100 columns at most; the cells of the first
/// column are broken into lines to fit.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    headings: Vec<Heading>,
    rows: Vec<Row>,
}

/// Heading of a column, in lines, and the alignment of its cells.
#[derive(Clone, Debug)]
pub(crate) struct Heading {
    text: String,
    is_number: bool,
}

impl Heading {
    /// The heading of a column of words, aligned left.
    pub(crate) fn word(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_number: false }
    }

    /// The heading of a column of numbers, aligned right.
    pub(crate) fn number(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_number: true }
    }
}

/// Row of a table.
#[derive(Clone, Debug)]
enum Row {
    Cells(Vec<Cell>),
    Words(String),
}

/// Content of a cell: text for the terminal, and markup for a page.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    text: String,
    markup: Markup,
}

impl Cell {
    /// A cell with markup of its own.
    pub(crate) fn new(text: &str, markup: Markup) -> Self {
        Self { text: legible(&text.replace('\n', " ")), markup }
    }

    /// The text for the terminal.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::new(text, html! { (text) })
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        text.as_str().into()
    }
}

impl From<bool> for Cell {
    fn from(is_so: bool) -> Self {
        let word = if is_so { "yes" } else { "no" };
        Self::new(word, verdict(word, word))
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        found(value).to_string().into()
    }
}

impl<T: Into<Self>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or_else(|| "-".into(), T::into)
    }
}

/// A cell that appears on a page only.
impl From<Markup> for Cell {
    fn from(markup: Markup) -> Self {
        Self::new("", markup)
    }
}

impl Table {
    /// A table without rows.
    pub(crate) fn new(headings: impl IntoIterator<Item = Heading>) -> Self {
        Self { headings: headings.into_iter().collect(), rows: Vec::new() }
    }

    /// Adds the `rows`, each with a cell for each heading.
    pub(crate) fn with_rows<R: IntoIterator<Item = Cell>>(
        mut self,
        rows: impl IntoIterator<Item = R>,
    ) -> Self {
        rows.into_iter().for_each(|row| self.push(row));
        self
    }

    /// Adds a row with a cell for each heading.
    pub(crate) fn push(&mut self, cells: impl IntoIterator<Item = Cell>) {
        self.rows.push(Row::Cells(cells.into_iter().collect()));
    }

    /// Adds a row of words across all columns.
    pub(crate) fn say(&mut self, words: impl Into<String>) {
        self.rows.push(Row::Words(words.into()));
    }

    /// The table on a page; `class` is that of its element.
    pub(crate) fn to_html(&self, class: &str) -> Markup {
        html! {
            div.wide {
                table class=[Some(class).filter(|class| !class.is_empty())] {
                    thead {
                        tr {
                            @for Heading { text, is_number } in &self.headings {
                                th class=[is_number.then_some("number")] {
                                    @for (index, line) in text.trim().lines().enumerate() {
                                        @if index > 0 { br; }
                                        (line)
                                    }
                                }
                            }
                        }
                    }
                    tbody { @for row in &self.rows { (self.row(row)) } }
                }
            }
        }
    }

    fn row(&self, row: &Row) -> Markup {
        html! {
            tr {
                @match row {
                    Row::Cells(cells) => {
                        @for (heading, cell) in self.headings.iter().zip(cells) {
                            td class=[heading.is_number.then_some("number")] { (cell.markup) }
                        }
                    }
                    Row::Words(words) => td colspan=(self.headings.len()) { (words) }
                }
            }
        }
    }

    /// The lines of the headings, equally many for each: the last lines stand side by side.
    fn head(&self) -> Vec<Vec<&str>> {
        let columns: Vec<Vec<&str>> =
            self.headings.iter().map(|heading| heading.text.split('\n').collect()).collect();
        let height = columns.iter().map(Vec::len).max().unwrap_or(0);
        let line = |index: usize| {
            let of = |lines: &Vec<&'_ str>| (index + lines.len()).checked_sub(height);
            columns.iter().map(|lines| of(lines).map_or("", |index| lines[index])).collect()
        };
        (0..height).map(line).collect()
    }

    /// The width of each column.
    fn widths(&self, head: &[Vec<&str>]) -> Vec<usize> {
        let mut widths = vec![0; self.headings.len()];
        let mut widen = |cells: &mut dyn Iterator<Item = &str>| {
            for (width, cell) in widths.iter_mut().zip(cells) {
                *width = display_width(cell).max(*width);
            }
        };
        head.iter().for_each(|line| widen(&mut line.iter().copied()));
        for row in &self.rows {
            if let Row::Cells(cells) = row {
                widen(&mut cells.iter().map(|cell| cell.text.as_str()));
            }
        }
        if let [first, others @ ..] = &mut widths[..] {
            let others: usize = others.iter().map(|width| BETWEEN.len() + *width).sum();
            *first = WIDEST.saturating_sub(others).max(SHORTEST).min(*first);
        }
        widths
    }

    /// A row of cells: a line, and more where the first cell takes them.
    fn lines<'a>(&self, cells: impl Iterator<Item = &'a str>, widths: &[usize]) -> Vec<String> {
        let cells: Vec<&str> = cells.collect();
        let room = widths.first().copied().unwrap_or_default();
        let options = Options::new(room).word_splitter(WordSplitter::HyphenSplitter);
        let firsts = textwrap::wrap(cells.first().copied().unwrap_or_default(), options);
        let others = cells.get(1..).unwrap_or_default();
        let line = |(index, first): (usize, Cow<'_, str>)| {
            let beside = others.iter().map(|cell| if index == 0 { *cell } else { "" });
            self.line(std::iter::once(&*first).chain(beside), widths)
        };
        firsts.into_iter().enumerate().map(line).collect()
    }

    /// One line of cells.
    fn line<'a>(&self, cells: impl Iterator<Item = &'a str>, widths: &[usize]) -> String {
        let padded = self.headings.iter().zip(widths).zip(cells).map(|((heading, width), cell)| {
            let blanks = " ".repeat(width.saturating_sub(display_width(cell)));
            if heading.is_number { blanks + cell } else { cell.to_owned() + &blanks }
        });
        padded.collect::<Vec<_>>().join(BETWEEN).trim_end().to_owned()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let head = self.head();
        let widths = self.widths(&head);
        for line in &head {
            writeln!(f, "{}", self.line(line.iter().copied(), &widths))?;
        }
        let rules: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
        writeln!(f, "{}", rules.join(BETWEEN))?;
        self.rows.iter().try_for_each(|row| match row {
            Row::Cells(cells) => self
                .lines(cells.iter().map(|cell| cell.text.as_str()), &widths)
                .iter()
                .try_for_each(|line| writeln!(f, "{line}")),
            Row::Words(words) => writeln!(f, "{words}"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOSTILE: &str = "<script>alert(\"1\")</script> & <b>";

    fn table(name: &str) -> Table {
        let headings = [Heading::word("name"), Heading::number("force\nN"), Heading::word("kept")];
        Table::new(headings).with_rows([[name.into(), Cell::from(1234.5678), true.into()]])
    }

    #[test]
    fn plain_text_is_escaped_on_a_page() {
        let mut table = table(HOSTILE);
        table.say(HOSTILE);
        let page = table.to_html(HOSTILE).into_string();
        assert!(!page.contains("<script") && !page.contains("<b>"), "{page}");
        assert_eq!(page.matches("&lt;script&gt;").count(), 3, "{page}");
        assert_eq!(page.matches("&amp;").count(), 3, "{page}");
        // A quotation mark would end the value of an attribute.
        assert!(page.contains("class=\"&lt;script&gt;alert(&quot;1&quot;)"), "{page}");
    }

    #[test]
    fn words_stand_on_the_left_and_numbers_on_the_right() {
        let shown = table("name").to_string();
        let expected = "      force\nname      N  kept\n----  -----  ----\nname   1235  yes\n";
        assert_eq!(shown, expected);
    }

    #[test]
    fn a_table_fits_the_terminal_whatever_is_in_it() {
        let names = [("long ", 'g', 50), ("\u{1b}[2J\n", 'J', 30), ("\u{6f22}", '\u{6f22}', 80)];
        for (name, letter, count) in names {
            let shown = table(&name.repeat(count)).to_string();
            assert!(shown.lines().all(|line| display_width(line) <= WIDEST), "{shown}");
            assert_eq!(shown.matches(letter).count(), count, "{shown}");
            assert!(!shown.contains('\u{1b}'), "{shown}");
        }
    }
}
