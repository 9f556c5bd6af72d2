//! Observer/controllers: POPC, and LOLC with the candidates that ship.

use lyapunov::{Dissipation, Lolc, Popc, PortEnergy};

use crate::export::blocks;
use crate::limits::limit;

blocks! {
    /// Passivity observer/controller (Popc): sums the energy that crosses the port, and takes a debt back by a damper. In float the
    /// sum loses digits as credit grows, hundreds of joules in hours at 0.2 mJ a tick: for more than some minutes take
    /// lolc_compensated with a device_damping of 0, which is POPC in a sum that keeps them, or bounded_credit.
    popc on every = {
        "popc";
        Popc<T>, whole 2 + 0;
        {
            /// Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes.
            damping_limit: T,
            /// Energy stored in the loop at the start, which may come back, J; usually 0. Only init reads it: `retune` does
            /// not, and later there is `grant`.
            budget: T => 0.0,
        };
        |given| Popc::new(PortEnergy, limit(given.damping_limit)?).budgeted(given.budget);
        [life stabilizer account]
    }
    /// Lyapunov observer/controller (Lolc) that credits what the device's own damper burns.
    lolc on every = {
        "lolc";
        Lolc<T, (PortEnergy, Dissipation<T>)>, whole 3 + 0;
        {
            /// Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes.
            damping_limit: T,
            /// Damping that the device surely has, N.s/m.
            device_damping: T,
            /// Energy stored in the loop at the start, which may come back, J; usually 0. Only init reads it: `retune` does
            /// not, and later there is `grant`.
            budget: T => 0.0,
        };
        |given| {
            let candidate = (PortEnergy, Dissipation::of(given.device_damping)?);
            Lolc::new(candidate, limit(given.damping_limit)?).budgeted(given.budget)
        };
        [life stabilizer account]
    }
}
