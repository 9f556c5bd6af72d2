//! Changes between ticks: those of `tests/retuning`, but for what is stored in bytes.

#[path = "../retuning/changes.rs"]
mod changes;
#[path = "../retuning/refused.rs"]
mod refused;

mod support {
    use lyapunov::{HeldTick, PortSample};

    pub(super) use crate::support::{PERIOD, limit, popc};

    /// A tick that does `work` J of work at `velocity` m/s.
    pub(super) fn tick(work: f64, velocity: f64) -> PortSample<f64> {
        let displacement = velocity * PERIOD;
        let tick = HeldTick { period: PERIOD, position: 0.0, velocity, displacement, applied: 0.0 };
        PortSample { work, ..tick.sample() }
    }
}
