//! Memory-based passivation.

use lyapunov::{ParameterError, Scalar, stabilizers::MemoryBased as Law};

use super::basis::CELLS;
use super::kind::{Install, OnALine, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Manner, Pledge, Search};

table! {
    /// Memory-based passivation (Ryu and Yoon 2014): forces on the way out no larger than those kept from the way in.
    MemoryBased = "memory-based" {
        words {}
        numbers {
            /// Place where the environment begins in m; default: its surface, or 0 where there is none.
            position: Finite, "m", "position = 0.0  # m",
            |_, on| on.surface.unwrap_or(0.0), |_, _| None;
            /// Length of each of the 256 cells in m, greater than 0; default: one count of the encoder, without an
            /// encoder what a tick moves at the speed of the energy that the motion starts with, but at least so much
            /// that the cells reach twice as deep as a spring like the environment takes up that energy.
            cell: Positive, "m", "cell = 1e-5  # m",
            |_, on| on.cell(), |at, _| Search::ratios(0.1 * at, 10.0 * at);
        }
    }
}

impl StabilizerKind for MemoryBased {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge { manner: Manner::Cuts, ..Pledge::POPC }
    }

    fn adds_damping(&self) -> bool {
        false
    }
}

impl OnALine for MemoryBased {
    fn make<T: Scalar, R: Install<T>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let position = on.each(Self::position);
        let depth = on.each(|own, on| own.cell(on) * CELLS as f64);
        let memory = Law::<T, CELLS>::beyond(position, depth)?;
        Ok(to.behind(memory.delayed(on.common().delay)))
    }
}
