//! The command line from outside: what it says, what it writes and what it leaves alone, with which exit status.

// Devices, pipes, signals and names that are no text.
#![cfg(unix)]

mod accuracy;
mod bad_output;
mod bad_scene;
mod bad_usage;
mod effects;
mod hard;
mod interrupt;
mod json;
mod map;
mod paper;
mod place;
mod range;
mod said;
mod streams;
mod summary;
mod why;
