//! What all report pages share.

/// The version that a page was made by.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// How a page ends.
pub(crate) const CLOSED: &str = "</body>\n</html>\n";

const STYLE: &str = include_str!("html.css");

/// A page that needs nothing else, up to its heading, which is its `title`.
pub(crate) fn opened(title: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    )
}

/// The text with everything replaced that HTML reads as markup between tags.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
