//! Tests of the command line from outside: its messages, its files, those that it must leave alone, its exit status.

// The tests need devices, pipes, signals and file names that are no text.
#![cfg(unix)]

mod accuracy;
mod axes;
mod bad_output;
mod bad_scene;
mod bad_usage;
mod checkpoint;
mod claims;
mod disaster;
mod effects;
mod fault;
mod golden;
mod hard;
mod inputs;
mod interrupt;
mod json;
mod large;
mod lock;
mod map;
mod out;
mod paper;
mod place;
mod range;
mod said;
mod sidecar;
mod signals;
mod streams;
mod summary;
mod sweep;
mod tune;
mod why;
