//! Scenes fitted to logs of known truth.

mod alone;
mod coverage;
mod loops;
mod notes;
mod odd;
mod simulator;
