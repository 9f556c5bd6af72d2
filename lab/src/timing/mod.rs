//! Things timed in turns, round by round.

mod rounds;
mod runs;

pub(crate) use rounds::Rounds;
pub(crate) use runs::{count_for, runs};
