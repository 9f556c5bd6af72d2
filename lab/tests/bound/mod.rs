//! Formulas for the largest stiffness of a scene, against the loop itself and against references with more digits.

mod exact;
mod llewellyn;
mod passivity;
mod references;
mod rules;
pub(crate) mod systems;
