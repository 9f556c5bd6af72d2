//! Reference: `reference.txt`, which `python/reference.py` computes with 60 digits and more.

use crate::scene::Positions;

/// The positions of the scene, rounded to `f64`.
pub(crate) struct Reference(Positions);

impl Reference {
    pub(crate) fn new() -> Self {
        let mut lines = include_str!("../reference.txt").lines().map(str::parse);
        Self([0.0; _].map(|_: f64| lines.next().expect("201 lines").expect("a number")))
    }

    /// The largest error of `positions` against the reference, m.
    pub(crate) fn error(&self, positions: &[f64]) -> f64 {
        let apart = self.0.iter().zip(positions).map(|(truth, at)| (truth - at).abs());
        // Not `max`, which ignores NaN.
        apart.fold(0.0, |largest, apart| if apart <= largest { largest } else { apart })
    }
}
