//! Tests of `lyapunov observe` against an independent calculation, on the shipped log, on random logs and on hostile
//! input.

mod against;
mod command;
mod headings;
mod hostile;
mod late;
mod naive;
mod random;
mod replay;
mod shipped;
mod streams;
