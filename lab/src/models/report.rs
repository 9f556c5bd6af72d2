//! The report page of models: one file that needs nothing else.

use std::fmt::Write;

use super::comparison::Comparison;
use super::table::{cells, headings, start};

const VERSION: &str = env!("CARGO_PKG_VERSION");
const STYLE: &str = include_str!("../paper/report.css");

/// The comparisons as a page, in HTML; `command` made them.
pub fn report(comparisons: &[Comparison], command: &str) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>Stabilizers of control-affine plants</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>Stabilizers of control-affine plants</h1>\n\
         <p>By <code>{}</code>, lyapunov {VERSION}.</p>\n\
         <p>Each plant once without a stabilizer, once with the sum of what its input takes from V (<code>popc</code>), once with \
         the sum of all that V loses (<code>lolc-decrease</code>), and once with V asked to decay as well (<code>lolc-decay</code>). All numbers are \
         in <code>compare.json</code>.</p>\n",
        escaped(command)
    );
    for comparison in comparisons {
        section(comparison, &mut page);
    }
    page.push_str("</body>\n</html>\n");
    page
}

fn section(comparison: &Comparison, page: &mut String) {
    let _ = write!(
        page,
        "<h2>{}</h2>\n<p>{}.</p>\n<figure>\n{}\n<figcaption>V over time. A curve that leaves the frame is cut off \
         there.</figcaption>\n</figure>\n",
        escaped(&comparison.name),
        start(comparison),
        comparison.figure().to_svg()
    );
    page.push_str("<div class=\"wide\"><table class=\"short\">\n<thead><tr>");
    let [upper, middle, unit] = headings(comparison);
    for (column, unit) in unit.iter().enumerate() {
        let class = if column < 2 { "" } else { " class=\"number\"" };
        let words = [&upper[column], &middle[column], unit].map(String::as_str);
        let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
        let _ = write!(page, "<th{class}>{}</th>", words.join(" "));
    }
    page.push_str("</tr></thead>\n<tbody>\n");
    for score in comparison.scores() {
        page.push_str("<tr>");
        for (column, cell) in cells(score).iter().enumerate() {
            let class = match column {
                0 => "",
                1 if score.bounded => " class=\"yes\"",
                1 => " class=\"no\"",
                _ => " class=\"number\"",
            };
            let _ = write!(page, "<td{class}>{cell}</td>");
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</tbody>\n</table></div>\n");
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
