//! A report page: one file that needs nothing else.

use std::fmt::Write;

use super::compared::Compared;
use super::sheet::Sheet;
use super::table::Table;
use crate::html::{CLOSED, VERSION, escaped, opened};

/// The `sheets` of comparisons `C` as a page, in HTML; `command` made them.
pub fn page<C: Compared>(sheets: &[Sheet], command: &str) -> String {
    let mut page = opened(C::TITLE);
    let _ = write!(
        page,
        "<p>By <code>{}</code>, lyapunov {VERSION}.</p>\n\
         <p>{} All numbers are in <code>compare.json</code>.</p>\n",
        escaped(command),
        C::ABOUT,
    );
    for sheet in sheets {
        let _ = write!(
            page,
            "<h2>{}</h2>\n<p>{}.</p>\n<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n{}",
            escaped(&sheet.name),
            sheet.start,
            sheet.figure.to_svg(),
            sheet.caption,
            sheet.tables.iter().map(Table::to_html).collect::<String>()
        );
    }
    page.push_str(CLOSED);
    page
}
