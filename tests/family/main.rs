//! The family of stabilizers: each against a closed form or a calculation of the test's own.

mod account;
mod admittance;
mod adversary;
mod aimed;
mod coupling;
#[path = "../support/dice.rs"]
mod dice;
mod energy_bounding;
mod force_bound;
mod force_bounding;
mod hostile;
mod input_to_state;
mod lanes;
mod laws;
mod least_norm;
mod long_runs;
mod memory_based;
mod neutral;
mod no_time;
mod path_memory;
mod plausible;
mod port_energy;
mod reference;
mod shaping;
mod slope_bound;
mod support;
mod tank;
mod two_layer;
mod two_port;
mod two_port_worked;
mod waves;
mod worked;
