//! The library from outside, one module for each part; a single target, since each compiles the loops anew.

mod bounds;
mod causes;
mod claims;
mod family;
mod hard;
mod integrators;
mod map;
mod models;
mod shipped;
mod teleoperation;
