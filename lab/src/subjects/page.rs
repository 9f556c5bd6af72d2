//! A report page: one file that needs nothing else.

use std::fmt::Write;

use super::compared::Compared;
use super::sheet::Sheet;
use super::table::Table;

const VERSION: &str = env!("CARGO_PKG_VERSION");
const STYLE: &str = include_str!("../paper/report.css");

/// The `sheets` of comparisons `C` as a page, in HTML; `command` made them.
pub fn page<C: Compared>(sheets: &[Sheet], command: &str) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>{title}</h1>\n\
         <p>By <code>{}</code>, lyapunov {VERSION}.</p>\n\
         <p>{} All numbers are in <code>compare.json</code>.</p>\n",
        escaped(command),
        C::ABOUT,
        title = C::TITLE,
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
    page.push_str("</body>\n</html>\n");
    page
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
