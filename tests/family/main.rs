//! The family of stabilizers: each against a closed form or a calculation of the test's own.

mod account;
mod admittance;
mod aimed;
mod coupling;
mod force_bound;
mod lanes;
mod laws;
mod neutral;
mod path_memory;
mod port_energy;
mod reference;
mod shaping;
mod slope_bound;
mod support;
mod tank;
mod two_port;
mod waves;
