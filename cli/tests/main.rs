//! Tests of the command from outside, one module for each thing that it is compared with.

mod claims;
mod cli;
mod compare;
mod contract;
mod effects;
mod models;
mod observe;
mod shipped;
mod teleoperation;
mod verdicts;
