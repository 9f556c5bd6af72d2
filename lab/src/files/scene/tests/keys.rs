//! The keys in messages, compared with the types that read them.

use serde_json::Value;

use super::scene;
use crate::files::scene::keys::{KEYS, SMALLEST};
use crate::files::scene::{Key, schema};

/// The paths of all keys and tables that a schema allows.
fn paths(schema: &Value, root: &Value, within: &str, found: &mut Vec<String>) {
    if let Some(Value::String(name)) = schema.get("$ref") {
        let pointed = root.pointer(name.trim_start_matches('#')).unwrap();
        paths(pointed, root, within, found);
    }
    for list in ["oneOf", "anyOf", "allOf"] {
        let choices = schema.get(list).and_then(Value::as_array);
        choices.into_iter().flatten().for_each(|choice| paths(choice, root, within, found));
    }
    let properties = schema.get("properties").and_then(Value::as_object);
    for (key, schema) in properties.into_iter().flatten() {
        let path = format!("{within}{key}");
        paths(schema, root, &format!("{path}."), found);
        found.push(path);
    }
}

/// Asserts that `keys` are exactly those that a schema allows.
pub(crate) fn assert_keys_of(schema: &Value, keys: &[Key]) {
    let mut written = Vec::new();
    paths(schema, schema, "", &mut written);
    written.sort();
    written.dedup();
    let mut known: Vec<_> = keys.iter().map(|key| key.path.to_owned()).collect();
    known.sort();
    assert_eq!(written, known);
}

#[test]
fn messages_know_every_key_and_no_other() {
    assert_keys_of(&schema(), KEYS);
}

#[test]
fn every_example_in_a_message_is_right() {
    // The example of this key names a motion file that does not exist.
    for key in KEYS.iter().filter(|key| key.path != "operator.motion.path") {
        let text = if key.is_table() || key.table().is_empty() {
            key.example.to_owned()
        } else {
            format!("[{}]\n{}", key.table(), key.example)
        };
        let mut document: toml::Table = SMALLEST.parse().unwrap();
        for more in [needed_by(key), &text] {
            merge(&mut document, more.parse().unwrap());
        }
        let environment = document["environment"].as_table_mut().unwrap();
        if environment.len() > 1 {
            environment.remove("wall");
        }
        scene(&toml::to_string(&document).unwrap());
    }
}

/// The keys that a key requires: the rest of its table, and other tables.
fn needed_by(key: &Key) -> &'static str {
    let table = if key.is_table() { key.path } else { key.table() };
    match (table, key.name()) {
        ("", "steps_per_tick") => "integrator = \"rk4\"",
        ("", "tolerance") => "integrator = \"dopri5\"",
        ("effects.filter", _) => "",
        ("operator.motion", "rate") => "[operator.motion]\nkind = \"ramp\"\nto = 0.01",
        ("operator.motion", "amplitude") => "[operator.motion]\nkind = \"sine\"\nfrequency = 1.0",
        ("operator.motion", "frequency") => "[operator.motion]\nkind = \"sine\"\namplitude = 1.0",
        ("operator.grip", _) => {
            "[operator.grip]\ntimes = [1.0, 2.0]\nstiffness = [1.0, 2.0]\ndamping = [1.0, 2.0]"
        }
        ("link", _) => "operator.mass = 0.1\nlink.stiffness = 20000.0",
        ("space", _) => {
            "[environment.plane]\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\nstiffness = 1.0"
        }
        ("environment.plane", _) => {
            "space.dimensions = 2\n[environment.plane]\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\nstiffness = 1.0"
        }
        ("environment.sphere", _) => {
            "space.dimensions = 2\n[environment.sphere]\ncenter = [0.0, 0.0]\nradius = 1.0\nstiffness = 1.0"
        }
        ("environment.box", _) => {
            "space.dimensions = 2\n[environment.box]\ncenter = [0.0, 0.0]\nhalf = [1.0, 1.0]\nstiffness = 1.0"
        }
        (table, _) => {
            let table = KEYS.iter().find(|key| key.path == table && key.is_table());
            table.map_or("", |table| table.example)
        }
    }
}

pub(crate) fn merge(document: &mut toml::Table, more: toml::Table) {
    for (key, value) in more {
        match (document.get_mut(&key), value) {
            (Some(toml::Value::Table(table)), toml::Value::Table(more)) => merge(table, more),
            (_, value) => {
                document.insert(key, value);
            }
        }
    }
}
