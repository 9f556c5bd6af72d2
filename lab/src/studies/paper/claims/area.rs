//! Stable area in stiffness and damping.

use lyapunov::ParameterError;

use super::ensemble::{Control, Setting, run};
use super::measures::Measures;

/// Walls on a grid: stiffnesses in even ratios from 1 to 50 kN/m, dampings in even steps from 0 to 100 N·s/m.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// The number of stiffnesses.
    pub stiffnesses: usize,
    /// The number of dampings.
    pub dampings: usize,
}

impl Grid {
    fn walls(self) -> impl Iterator<Item = (f64, f64)> {
        let share = |index: usize, count: usize| index as f64 / (count.max(2) - 1) as f64;
        (0..self.stiffnesses).flat_map(move |k| {
            (0..self.dampings).map(move |b| {
                let stiffness = 1e3 * 50_f64.powf(share(k, self.stiffnesses));
                (stiffness, 100.0 * share(b, self.dampings))
            })
        })
    }
}

/// Share of the grid's walls with which the loop stays bounded and settles, for each start.
///
/// # Errors
/// A number that a part rejects.
pub fn stable_share(
    control: Control,
    grid: Grid,
    starts: &[f64],
) -> Result<Vec<f64>, ParameterError> {
    let mut stable = vec![0_usize; starts.len()];
    let mut walls = 0;
    for (stiffness, damping) in grid.walls() {
        walls += 1;
        let traces = run(&Setting::read(stiffness, damping, control), starts)?;
        for (count, trace) in stable.iter_mut().zip(&traces) {
            let measures = Measures::of(trace);
            *count += usize::from(measures.bounded && measures.settled.is_some());
        }
    }
    Ok(stable.into_iter().map(|count| count as f64 / walls as f64).collect())
}
