//! Intervals that hold although errors of neighbouring rows are alike.

use nalgebra::{Matrix4, Vector4};

use crate::studies::chance::student;

/// The most blocks, and the fewest rows in one on average.
const BLOCKS: f64 = 20.0;
const FEWEST: f64 = 8.0;

/// The gradient of a row's squared error by the parameters, and the row's share of what is known of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Score {
    pub(super) slope: Vector4<f64>,
    /// Error, in the unit of the data, times the root of the row's weight.
    pub(super) error: f64,
}

/// Covariance of a least-squares estimate by sums over blocks of rows, and the factor for a 95 % interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spread {
    pub(super) covariance: Matrix4<f64>,
    pub(super) factor: f64,
}

/// The spread of an estimate whose rows have these `scores`; `inverse` is that of their summed squares.
///
/// Consecutive rows form blocks that know equally much (equal leverage), and the sums of the gradients over blocks vary as the
/// estimate does, however the errors within a block hang together (Bester, Conley and Hansen, Inference with dependent data
/// using cluster covariance estimators, Journal of Econometrics 165, 2011). Blocks are as good as deleted one at a time, which
/// counts for the pull of each on the estimate (the jackknife; Bell and McCaffrey, Survey Methodology 28, 2002).
pub(super) fn spread(
    scores: &[Score],
    weight: f64,
    inverse: &Matrix4<f64>,
    free: usize,
) -> Option<Spread> {
    let mut target = (weight / FEWEST).min(BLOCKS).max(free as f64 + 3.0);
    let mut blocks = blocks(scores, inverse, free as f64 / target);
    // Where a few rows have most of the leverage, the blocks are made finer until there are enough.
    while blocks.len() < free + 3 && target < scores.len() as f64 {
        target *= 2.0;
        blocks = self::blocks(scores, inverse, free as f64 / target);
    }
    let freedom = blocks.len().checked_sub(free + 1)? + 1;
    if freedom < 2 {
        return None;
    }
    let mut covariance = Matrix4::zeros();
    for (sum, known) in &blocks {
        let step = inverse * sum;
        // The estimate without the block, to first order: (I − V K)⁻¹ V s. A block without which there is none counts as it is.
        let rest = Matrix4::identity() - inverse * known;
        let moved = rest.lu().solve(&step).filter(|it| it.iter().all(|it| it.is_finite()));
        let moved = moved.unwrap_or(step);
        covariance += moved * moved.transpose();
    }
    let finite = covariance.iter().all(|it| it.is_finite());
    finite.then(|| Spread { covariance, factor: student(freedom as f64) })
}

/// Gradients and knowledge of consecutive rows, summed until each block has this `share` of leverage.
fn blocks(
    scores: &[Score],
    inverse: &Matrix4<f64>,
    share: f64,
) -> Vec<(Vector4<f64>, Matrix4<f64>)> {
    let nothing = (Vector4::zeros(), Matrix4::zeros(), 0.0);
    let mut blocks = Vec::new();
    let (mut sum, mut known, mut leverage) = nothing;
    for score in scores {
        sum += score.slope * score.error;
        known += score.slope * score.slope.transpose();
        leverage += score.slope.dot(&(inverse * score.slope));
        if leverage >= share {
            blocks.push((sum, known));
            (sum, known, leverage) = nothing;
        }
    }
    if leverage > 0.0 {
        blocks.push((sum, known));
    }
    blocks
}
