//! Results as JSON, in the one form of all commands.

use serde::Serialize;

/// `document` as indented JSON that ends in a line break; numbers that are not finite become null.
pub(crate) fn text(document: &impl Serialize) -> String {
    // Only a key that is no text, or a serializer that refuses, would fail: the lab has neither.
    serde_json::to_string_pretty(document).unwrap_or_default() + "\n"
}
