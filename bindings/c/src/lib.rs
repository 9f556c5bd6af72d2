//! Stabilizers for sampled control loops, for C and C++.
//!
//! Every block is a struct that the caller places, made of numbers alone, without padding and without pointers, so that it
//! is copied and compared as bytes. `init` marks it with a tag, and every other function refuses storage that has not
//! its tag. Nothing here allocates, panics, starts a thread or keeps a global state. bindings/c/README.md is for
//! whoever uses it; `blocks` has a line for each block.
//!
//! Unsafe code is what stands between a pointer of C and a reference: all of it checks the pointer first.
#![no_std]

#[cfg(feature = "describe")]
extern crate std;

pub mod abi;
pub mod answered;
pub mod blocks;
mod check;
#[cfg(feature = "describe")]
pub mod describe;
mod export;
pub mod flat;
pub mod kept;
pub mod limits;
mod named;
pub mod number;
#[cfg(feature = "library")]
mod panic;
pub mod port;
pub mod poses;
pub mod readings;
pub mod retuned;
pub mod status;
pub mod status_text;
pub mod told;
pub mod verbs;
pub mod watched;
