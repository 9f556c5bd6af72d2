//! The keys of teleoperator files in messages, compared with the types that read them.

use super::Teleoperator;
use super::keys::{BOOK, KEYS, SMALLEST};
use crate::files::scene::schema_of;
use crate::files::scene::tests::{assert_keys_of, merge};
use approx::assert_abs_diff_eq;

#[test]
fn messages_know_every_key_and_no_other() {
    assert_keys_of(&schema_of::<Teleoperator>(), KEYS);
}

#[test]
fn every_example_in_a_message_is_right() {
    for key in KEYS {
        let mut document: toml::Table = SMALLEST.parse().unwrap();
        for (table, required) in [("slave.wall", "stiffness = 1.0"), ("channel", "seed = 1")] {
            if key.path.starts_with(table) {
                merge(&mut document, format!("[{table}]\n{required}").parse().unwrap());
            }
        }
        let text = match key.path.rsplit_once('.') {
            Some((table, _)) if !key.is_table() => format!("[{table}]\n{}", key.example),
            _ => key.example.to_owned(),
        };
        merge(&mut document, text.parse().unwrap());
        let text = toml::to_string(&document).unwrap();
        Teleoperator::parse(&text, "test.toml")
            .unwrap_or_else(|fault| panic!("{}: {fault}", key.path));
    }
}

#[test]
fn the_smallest_teleoperator_is_valid() {
    let smallest = Teleoperator::parse(BOOK.smallest, "test.toml").unwrap();
    assert_eq!((smallest.ticks(), smallest.wave_impedance()), (5000, 5.0));
    assert_abs_diff_eq!(smallest.stored_at_start(), 5e-3, epsilon = 1e-18);
}
