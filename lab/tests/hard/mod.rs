//! What the hard cases promise, on stabilizers that break it and on random scenes.

mod family;
mod own;
mod search;
