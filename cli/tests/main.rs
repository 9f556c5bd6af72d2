//! Tests of the command from outside, one module for each thing that it is compared with.

mod called;
mod cli;
mod compare;
mod contract;
mod effects;
mod for_each;
mod models;
mod observe;
mod pages;
// The bodies of a fuzz target, which the tests below run over changed files.
#[path = "../../fuzz/readers/src/readers.rs"]
mod readers;
mod shipped;
mod teleoperation;
mod verdicts;
