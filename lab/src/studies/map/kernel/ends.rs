//! The ends of closed loops.

use std::collections::TryReserveError;

/// Numbers of each loop at its end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ends {
    /// Position, m.
    pub position: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Observed energy at the last tick, J.
    pub observed_energy: Vec<f64>,
    /// The largest |position| from half of the ticks on, the start and the end counted, m.
    pub largest: Vec<f64>,
}

impl Ends {
    /// Room for the ends of `count` loops: nothing else of an ensemble is as large.
    ///
    /// # Errors
    /// There is no memory for so many.
    pub fn room(count: usize) -> Result<Self, TryReserveError> {
        let zeros = || {
            let mut zeros = Vec::new();
            zeros.try_reserve_exact(count)?;
            zeros.resize(count, 0.0);
            Ok::<_, TryReserveError>(zeros)
        };
        let (position, velocity) = (zeros()?, zeros()?);
        Ok(Self { position, velocity, observed_energy: zeros()?, largest: zeros()? })
    }
}
