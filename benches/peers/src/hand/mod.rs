//! Integrators by hand, without any library.

mod dormand_prince;
mod exact;
mod runge_kutta_4;

pub(crate) use dormand_prince::dormand_prince;
pub(crate) use exact::exact;
pub(crate) use runge_kutta_4::runge_kutta_4;
