//! Files that stand beside a page.

use maud::{Markup, html};

/// A heading and a line for each of the `files` in the folder of a page, by name and content.
pub(crate) fn beside(files: &[(&str, &str)]) -> Markup {
    html! {
        h2 { "Files" }
        ul { @for (name, content) in files { li { a href=(name) { (name) } ": " (content) } } }
    }
}
