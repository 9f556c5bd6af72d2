//! Checks of the command against the effects (docs/effects, docs/contract.md), which are calculated here independently:
//! nothing in this module uses the library.
//!
//! A trace is compared with the reference for as long as rounding cannot have grown to matter. On runs of any length
//! and of any loop each row must follow from the rows before it.

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
