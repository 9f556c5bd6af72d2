//! The library from outside, one module for each part; a single target, since each compiles the loops anew.

mod bound;

mod claims;
mod explain;
mod family;
mod floors;
mod hard;
mod integrators;
mod map;
mod models;
mod shipped;
mod teleoperation;
