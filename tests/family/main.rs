//! The family of stabilizers: each against a closed form or a calculation of the test's own.

mod account;
mod admittance;
mod aimed;
mod force_bound;
mod lanes;
mod laws;
mod neutral;
mod port_energy;
mod reference;
mod shaping;
mod support;
mod tank;
mod two_port;
mod waves;
