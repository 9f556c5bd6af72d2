//! Tests of `lyapunov observe` against an independent calculation, on the shipped log, on random logs and on hostile
//! input.

mod command;
mod hostile;
mod naive;
mod random;
mod shipped;
mod streams;
