//! Schema of the tables of own stabilizers.

use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Value, json};

use super::{Allowed, Declared, declared};
use crate::files::scene::{Cap, Finite, NonNegative, Positive, Ticks};

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
        let schema = match self {
            Self::Positive => Positive::json_schema,
            Self::NonNegative => NonNegative::json_schema,
            Self::Finite => Finite::json_schema,
            Self::Limit => Cap::json_schema,
            Self::Ticks => Ticks::json_schema,
        };
        schema(&mut SchemaGenerator::default()).into()
    }
}
