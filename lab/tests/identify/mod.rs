//! Scenes fitted to logs of known truth.

mod coverage;
mod loops;
mod notes;
mod odd;
mod simulator;
