//! The command from outside, one module for each thing that it is held against.

mod claims;
mod cli;
mod compare;
mod contract;
mod effects;
mod models;
mod observe;
mod shipped;
mod teleoperation;
