//! Checks of the command against the tick contract (docs/contract.md), which is calculated here a second time: nothing
//! in this module uses the library.
//!
//! A controlled loop at a stiff wall is chaotic, so there are two checks. A trace is compared with the reference for as
//! long as rounding cannot have grown to matter, and on runs of any length each row must follow from the rows before
//! it.

mod binary;
mod command;
mod conditioning;
mod facts;
mod fault;
mod faults;
mod generate;
mod motion;
mod reference;
mod row;
mod rows;
mod scene;
mod second;
mod toml;
mod trace;
