//! The keys of model files in messages, compared with the types that read them.

use super::keys::{BOOK, KEYS, SMALLEST};
use super::{Model, Plant};
use crate::files::scene::schema_of;
use crate::files::scene::tests::{assert_keys_of, merge};

/// The smallest model of `plant`: the required keys only.
fn smallest(plant: &str) -> toml::Table {
    let mut document: toml::Table = SMALLEST.parse().unwrap();
    let table = KEYS.iter().find(|key| key.path == format!("plant.{plant}")).unwrap();
    document.extend(table.example.parse::<toml::Table>().unwrap());
    let (states, gains) = match plant {
        "van-der-pol" => ("[0.5, 0.0]", "0.0"),
        "inverted-pendulum" => ("[0.1, 0.0]", "6.0"),
        "dc-motor" => ("[1.0, 0.0, 0.0]", "1.0"),
        "admittance-device" => ("[0.1, 0.0]", "0.0"),
        _ => ("[0.1, 0.1, 0.0, 0.0]", "[300.0, 150.0]"),
    };
    let more = format!("initial = {states}\ncontroller.proportional = {gains}");
    document.extend(more.parse::<toml::Table>().unwrap());
    document
}

#[test]
fn messages_know_every_key_and_no_other() {
    assert_keys_of(&schema_of::<Model>(), KEYS);
}

#[test]
fn every_example_in_a_message_is_right() {
    for key in KEYS {
        let plant = match key.path.split('.').nth(1) {
            Some(plant) if key.path.starts_with("plant.") => plant,
            _ if key.path.starts_with("controller") => "inverted-pendulum",
            _ => "van-der-pol",
        };
        let mut document = smallest(plant);
        let text = match key.path.rsplit_once('.') {
            Some((table, _)) if !key.is_table() => format!("[{table}]\n{}", key.example),
            _ => key.example.to_owned(),
        };
        merge(&mut document, text.parse().unwrap());
        let text = toml::to_string(&document).unwrap();
        Model::parse(&text, "test.toml").unwrap_or_else(|fault| panic!("{}: {fault}", key.path));
    }
}

#[test]
fn the_smallest_model_is_valid() {
    let model = Model::parse(BOOK.smallest, "test.toml").unwrap();
    assert!(matches!(model.plant, Plant::VanDerPol(_)));
    assert_eq!(model.ticks(), 1000);
}
