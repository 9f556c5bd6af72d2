//! The schema of scene files, for editors.

use schemars::generate::SchemaSettings;
use schemars::transform::{Transform, transform_subschemas};
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value};

use super::own::add_to_schema;
use super::written::Keys;

/// The JSON Schema (draft 7, which TOML editors know) of scene files, generated from the types that read them, with the
/// tables of the program's own stabilizers.
///
/// It holds the keys, their types and the range of each value; the rules between values are [`Draft::check`](super::Draft::check)'s.
pub fn schema() -> Value {
    let mut schema = schema_of::<Keys>();
    add_to_schema(&mut schema);
    schema
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

/// Removal of what a TOML file cannot express and of what an editor has no use for.
#[derive(Clone, Debug)]
struct AsInToml;

impl Transform for AsInToml {
    fn transform(&mut self, schema: &mut Schema) {
        if let Some(map) = schema.as_object_mut() {
            without_null(map);
            describe_the_only_key(map);
            // A default that is null or a whole table adds nothing to the key's absence.
            if map.get("default").is_some_and(|value| value.is_null() || value.is_object()) {
                map.remove("default");
            }
            // The line breaks come from comments wrapped for source code.
            if let Some(Value::String(text)) = map.get_mut("description") {
                *text = text.replace('\n', " ");
            }
        }
        transform_subschemas(self, schema);
    }
}

/// Copies the description of a choice to the key that makes it, where an editor shows it.
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

/// Replaces a key that may be null by one that may be absent, because TOML has no null.
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
        // Draft 7 ignores whatever stands beside a reference, so the reference stands in a list.
        let word = if choices.len() == 1 { "allOf" } else { "anyOf" };
        map.insert(word.to_owned(), choices.into());
    }
}
