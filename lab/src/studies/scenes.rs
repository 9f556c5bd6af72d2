//! The scenes that ship: `lyapunov scenes`.

use serde::Serialize;

pub use crate::files::shipped::{SCENES, Shipped, Unknown, text_of};

#[derive(Serialize)]
struct Entry {
    name: &'static str,
    comment: [&'static str; 2],
}

/// List of the scenes that ship, as JSON.
///
/// # Errors
/// None that is known.
pub fn json() -> Result<String, serde_json::Error> {
    let entries: Vec<Entry> =
        SCENES.iter().map(|scene| Entry { name: scene.name, comment: scene.comment() }).collect();
    serde_json::to_string_pretty(&entries).map(|text| text + "\n")
}
