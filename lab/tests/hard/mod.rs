//! The hard cases on faulty stabilizers, on the whole family and on random scenes.

mod family;
mod own;
mod soak;
