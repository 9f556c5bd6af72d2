//! Environments answer by their laws, and credit what their own dampers burn.

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
