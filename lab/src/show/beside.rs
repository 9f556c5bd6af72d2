//! Files that stand beside a page, and files that are not on it.

use maud::{Markup, html};

/// A heading and a line for each of the `files` in the folder of a page, by name and content.
pub(crate) fn beside(files: &[(&str, &str)]) -> Markup {
    html! {
        h2 { "Files" }
        ul { @for (name, content) in files { li { a href=(name) { (name) } ": " (content) } } }
    }
}

/// A heading and a line for each file that did not fit, by the reason; nothing without any.
pub(crate) fn unfit(left_out: &[String]) -> Markup {
    html! {
        @if !left_out.is_empty() {
            h2 { "Left out" }
            ul { @for reason in left_out { li { (reason) } } }
        }
    }
}
