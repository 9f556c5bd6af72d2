//! Report pages, each one self-contained file.

use lyapunov_figures::Figure;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("html.css");

/// A page with `title` as its heading.
pub(crate) fn page(title: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                (body)
            }
        }
    };
    page.into_string() + "\n"
}

/// The command that made something, and its version.
pub(crate) fn maker(command: &str) -> Markup {
    html! { code { (command) } ", lyapunov " (env!("CARGO_PKG_VERSION")) }
}

/// A figure, drawn as SVG, with a caption.
pub(crate) fn figure(id: Option<&str>, figure: &Figure, caption: &Markup) -> Markup {
    html! {
        figure id=[id] {
            (PreEscaped(figure.to_svg()))
            figcaption { (caption) }
        }
    }
}

/// A verdict in the colour of its `class`: `yes`, `no` or `open`.
pub(crate) fn verdict(class: &str, word: &str) -> Markup {
    html! { span class=(class) { (word) } }
}
