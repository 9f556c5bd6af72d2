//! Environments: answers by their laws, and credits of their own dampers.

mod closure;
mod cubic_spring;
mod energy;
mod hostile;
mod lanes;
mod law;
mod models;
mod neutral;
mod refused;
mod solids;
mod time;
