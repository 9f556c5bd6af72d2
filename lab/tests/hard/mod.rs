//! The hard cases on faulty stabilizers, on the whole family and on random scenes.

mod family;
mod faults;
mod own;
mod soak;
