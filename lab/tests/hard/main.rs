//! What the hard cases promise, on stabilizers that break it and on random scenes.

mod own;
mod search;
