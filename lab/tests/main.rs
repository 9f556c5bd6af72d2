//! Tests of the library from outside, one module for each part. They are a single target, since every target compiles
//! the loops anew.

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
mod tune;
