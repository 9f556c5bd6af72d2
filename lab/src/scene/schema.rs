//! The schema of scene files, for editors.

use schemars::generate::SchemaSettings;

use super::Scene;

/// A JSON Schema (draft 7, which editors of TOML know) of scene files, made from the types that read them.
///
/// It holds the keys, their types and the range of each value; the rules between values are [`Scene::check`]'s.
pub fn schema() -> serde_json::Value {
    let generator = SchemaSettings::draft07().into_generator();
    generator.into_root_schema_for::<Scene>().to_value()
}
