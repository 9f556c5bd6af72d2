//! Stabilizers of a program that stands on the lab, which scenes, names and studies then know as they know those that ship.

mod allowed;
mod declared;
mod number;
mod own_table;
mod promise;
mod roster;
mod schema;
mod seen_loop;
mod toml;

pub use allowed::Allowed;
pub(crate) use declared::Declared;
pub use number::OwnNumber;
pub use own_table::OwnTable;
pub use promise::Promise;
pub use roster::RosterError;
pub(super) use roster::tables;
pub(crate) use roster::{declared, enter, keys, named};
pub(crate) use schema::add_to as add_to_schema;
pub use seen_loop::Loop;
pub(super) use toml::OwnSeed;
