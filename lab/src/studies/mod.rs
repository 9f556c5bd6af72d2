//! The studies: a module for each command, named after it.

pub mod accuracy;
pub mod bound;
mod chance;
pub mod compare;
pub mod effects;
pub mod explain;
pub mod hard;
pub mod identify;
pub mod map;
pub mod observe;
pub mod paper;
pub mod run;
pub mod scenes;
pub mod tune;
