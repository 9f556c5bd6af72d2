//! Environments answer by their laws, and credit what their own dampers burn.

mod energy;
mod hostile;
mod lanes;
mod law;
mod models;
mod neutral;
mod refused;
mod solids;
mod time;
