//! Readings: samples made of what a device tells, against closed forms, sums by hand and scalar runs.

mod clock;
#[path = "../support/dice.rs"]
mod dice;
mod exact;
mod faults;
mod gaps;
mod jumps;
mod lanes;
mod support;
mod velocities;
mod watchdog;
