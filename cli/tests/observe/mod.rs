//! `lyapunov observe` against what is calculated here on its own, on the shipped log, on random logs and on
//! input that means no good.

mod command;
mod hostile;
mod naive;
mod random;
mod shipped;
mod streams;
