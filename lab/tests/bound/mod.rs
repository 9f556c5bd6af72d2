//! How stiff a scene may be, by formula, against the loop itself and against references with more digits.

mod exact;
mod llewellyn;
mod passivity;
mod references;
mod rules;
pub(crate) mod systems;
