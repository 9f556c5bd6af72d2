//! Schema of the tables of own stabilizers.

use serde_json::{Value, json};

use super::{Allowed, Declared, declared};

/// Adds the tables of the program's own stabilizers to the choice of a scene's stabilizer in `schema`.
pub(crate) fn add_to(schema: &mut Value) {
    let choices = schema.pointer_mut("/definitions/Stabilizer/oneOf").and_then(Value::as_array_mut);
    if let Some(choices) = choices {
        choices.extend(declared().iter().map(choice));
    }
}

/// The choice of this stabilizer.
fn choice(own: &Declared) -> Value {
    let about = format!("The program's own stabilizer {}.", own.name);
    let numbers = own.numbers.iter().map(|number| {
        let mut value = number.allowed.schema();
        let unit = if number.unit.is_empty() { "a number" } else { number.unit };
        value["description"] = format!("A number of {}, {unit}.", own.name).into();
        (number.key.to_owned(), value)
    });
    let properties: serde_json::Map<String, Value> = numbers.collect();
    let table = json!({
        "description": about,
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
    });
    json!({
        "description": about,
        "type": "object",
        "properties": { own.name: table },
        "required": [own.name],
        "additionalProperties": false,
    })
}

impl Allowed {
    fn schema(self) -> Value {
        match self {
            Self::Positive => json!({ "type": "number", "exclusiveMinimum": 0 }),
            Self::NonNegative => json!({ "type": "number", "minimum": 0 }),
            Self::Finite => json!({ "type": "number" }),
            // JSON has no infinity: converters from TOML to JSON write null.
            Self::Limit => {
                json!({ "anyOf": [{ "type": "number", "minimum": 0 }, { "const": null }] })
            }
            Self::Ticks => json!({ "type": "integer", "minimum": 1, "maximum": 1_000_000 }),
        }
    }
}
