//! Tests of the library from outside, one module for each part. They are a single target, since every target compiles
//! the loops anew.

mod bound;
mod burnt;
mod claims;
mod explain;
mod family;
mod floors;
mod golden;
mod hard;
mod identify;
mod idle;
mod integrators;
mod lanes;
mod late_cap;
mod logs;
mod loops;
mod map;
mod map_cells;
mod map_checkpoint;
mod map_edge;
mod map_refused;
mod miscounted;
mod models;
mod progress;
mod remedies;
mod sanity;
mod shipped;
mod space;
mod tables;
mod telemetry;
mod teleoperation;
mod too_fast;
mod tune;
mod worked;
