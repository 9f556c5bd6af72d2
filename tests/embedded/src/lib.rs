//! The family of stabilizers as a program that every processor can run, with one hash over what each member answers.
#![no_std]
#![cfg_attr(realtime, feature(sanitize))]

mod by_hand;
mod drive;
mod hash;
mod members;
mod port;

pub use drive::{BLOCK, SEEDS, Ticks};
pub use hash::{Hash, hash, step};
pub use members::{Number, Visit, visit};
pub use port::{Answering, Constrained, Draws, Looped, Reads, Spring, Waves};
