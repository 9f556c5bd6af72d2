//! The schema of scene files, for editors.

use schemars::generate::SchemaSettings;
use schemars::transform::{Transform, transform_subschemas};
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value};

use super::written::Keys;

/// A JSON Schema (draft 7, which editors of TOML know) of scene files, made from the types that read them.
///
/// It holds the keys, their types and the range of each value; the rules between values are [`Draft::check`](super::Draft::check)'s.
pub fn schema() -> Value {
    schema_of::<Keys>()
}

/// [`schema`] as the text of a file.
pub fn schema_text() -> String {
    format!("{:#}\n", schema())
}

/// The schema of the files whose keys are `K`.
pub(crate) fn schema_of<K: JsonSchema>() -> Value {
    let settings = SchemaSettings::draft07().with_transform(AsInToml);
    settings.into_generator().into_root_schema_for::<K>().to_value()
}

/// Takes out what a TOML file cannot say, and what an editor has no use for.
#[derive(Clone, Debug)]
struct AsInToml;

impl Transform for AsInToml {
    fn transform(&mut self, schema: &mut Schema) {
        if let Some(map) = schema.as_object_mut() {
            without_null(map);
            describe_the_only_key(map);
            // A default that is null or a whole table says no more than the key's absence does.
            if map.get("default").is_some_and(|value| value.is_null() || value.is_object()) {
                map.remove("default");
            }
            // The lines of a comment are folded for a screen of code.
            if let Some(Value::String(text)) = map.get_mut("description") {
                *text = text.replace('\n', " ");
            }
        }
        transform_subschemas(self, schema);
    }
}

/// What is said of a choice, at the key by which it is chosen, where an editor shows it.
fn describe_the_only_key(map: &mut Map<String, Value>) {
    let description = map.get("description").cloned();
    let keys = map.get_mut("properties").and_then(Value::as_object_mut);
    if let (Some(description), Some(keys)) = (description, keys)
        && keys.len() == 1
        && let Some(Value::Object(only)) = keys.values_mut().next()
        && !only.contains_key("$ref")
    {
        only.entry("description").or_insert(description);
    }
}

/// A key that may be absent, as TOML has it, in place of one that may be null.
fn without_null(map: &mut Map<String, Value>) {
    if let Some(Value::Array(types)) = map.get_mut("type") {
        types.retain(|name| name != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            map.insert("type".to_owned(), only);
        }
    }
    if let Some(Value::Array(mut choices)) = map.remove("anyOf") {
        choices.retain(|choice| choice.get("type") != Some(&Value::from("null")));
        // What stands beside a reference counts for nothing in draft 7, so the reference stands in a list.
        let word = if choices.len() == 1 { "allOf" } else { "anyOf" };
        map.insert(word.to_owned(), choices.into());
    }
}
