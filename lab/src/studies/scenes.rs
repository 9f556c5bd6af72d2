//! The scenes that ship: `lyapunov scenes`.

use crate::show::json;
use serde::Serialize;

pub use crate::files::shipped::{SCENES, ShippedScene, Unknown, text_of};

#[derive(Serialize)]
struct Entry {
    name: &'static str,
    comment: [&'static str; 2],
}

/// List of the scenes that ship, as JSON.
pub fn json() -> String {
    let entries: Vec<Entry> =
        SCENES.iter().map(|scene| Entry { name: scene.name, comment: scene.comment() }).collect();
    json::text(&entries)
}
