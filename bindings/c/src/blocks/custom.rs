//! LOLC with a candidate of the caller's, as a function and a context.

use lyapunov::candidates::InContact;
use lyapunov::{Dissipation, Lolc, PortEnergy, Requirement};

use crate::export::blocks;
use crate::limits::limit;
use crate::named::named;
use crate::told::{Told, ToldEnergy};

blocks! {
    /// LOLC whose candidate is a function of yours (Lolc with a LyapunovCandidate): it is handed to every step and gives the
    /// decrease over the sample, J, which is sample->work and what your candidate credits. Storage keeps neither
    /// function nor context.
    lolc_custom on every = {
        "lolc_custom";
        Lolc<T, Told<T>>, whole 3 + 0;
        {
            /// Largest damping, N.s/m.
            damping_limit: T,
            /// Energy stored in the loop at the start, which may come back, J; usually 0. Only init reads it: `retune` does
            /// not, and later there is `grant`.
            budget: T => 0.0,
        };
        |given| {
            let told = Told { decrease: 0.0 };
            Lolc::new(told, limit(given.damping_limit)?).budgeted(given.budget)
        };
        [life custom account]
    }
    /// LOLC whose candidate is a storage function of yours (Lolc with a StorageFunction): it is handed to every step and gives the
    /// energy V at the sample's position and velocity, J.
    lolc_storage on every = {
        "lolc_storage";
        Lolc<T, ToldEnergy<T>>, whole 4 + 0;
        {
            /// Largest damping, N.s/m.
            damping_limit: T,
            /// V in the state in which the loop starts, J. Only init reads it: `retune` does not.
            start: T => 0.0,
        };
        |given| {
            let told = named("start", ToldEnergy::starting(given.start))?;
            Ok(Lolc::new(told, limit(given.damping_limit)?))
        };
        [life storage account]
    }
    /// LOLC with the credit of a wall's own damper while in contact (Dissipation::gated InContact): the paper's example 2. It can
    /// credit more than really burns; start with lolc.
    lolc_in_contact on line = {
        "lolc_in_contact";
        Lolc<T, (PortEnergy, Dissipation<T, InContact<T>>)>, whole 4 + 0;
        {
            /// Largest damping, N.s/m.
            damping_limit: T,
            /// Damping of the wall, N.s/m.
            wall_damping: T,
            /// Position of the wall's surface, m; contact is beyond it.
            surface: T,
            /// Energy stored in the loop at the start, which may come back, J; usually 0. Only init reads it: `retune` does
            /// not, and later there is `grant`.
            budget: T => 0.0,
        };
        |given| {
            let position = Requirement::Finite.check("surface", given.surface)?;
            let wall = named("wall_damping", Dissipation::of(given.wall_damping))?;
            let candidate = (PortEnergy, wall.gated(InContact { position }));
            Lolc::new(candidate, limit(given.damping_limit)?).budgeted(given.budget)
        };
        [life stabilizer account]
    }
}
