//! Models of control-affine plants from files: what they come to, and what is refused.

mod bad;
mod examples;
mod hand;
mod shipped;
