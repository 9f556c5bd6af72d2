//! Checks the command against the table of effects (docs/effects, docs/contract.md), calculated here on its own: nothing in
//! this target uses the library.
//!
//! A trace is compared with the reference for as long as rounding cannot have grown to matter. On runs of any length
//! each row must follow from the rows before it, whatever the loop is.

mod compare;
mod environment;
mod generate;
mod integrate;
mod neutral;
mod one_by_one;
mod plant;
mod random;
mod random_scenes;
mod reference;
mod rows;
mod run;
mod scene;
mod toml;
mod velocity;
