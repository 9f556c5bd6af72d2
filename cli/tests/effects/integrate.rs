//! Gragg's modified midpoint rule, extrapolated (Bulirsch and Stoer): one step of order 14.

use approx::abs_diff_eq;

const STAGES: usize = 7;

/// Gain of `state` over `step` s under `rate`.
pub(crate) fn gain<const N: usize>(
    state: [f64; N],
    step: f64,
    rate: impl Fn([f64; N]) -> [f64; N],
) -> [f64; N] {
    let mut table = [[0.0; N]; STAGES];
    for stage in 0..STAGES {
        let mut row = [[0.0; N]; STAGES];
        row[0] = midpoint(state, step, 2 * (stage + 1), &rate);
        for order in 1..=stage {
            let ratio = (stage + 1) as f64 / (stage + 1 - order) as f64;
            for axis in 0..N {
                let change = row[order - 1][axis] - table[order - 1][axis];
                row[order][axis] = row[order - 1][axis] + change / (ratio * ratio - 1.0);
            }
        }
        table = row;
    }
    table[STAGES - 1]
}

/// Gain of one midpoint run. The state is not added to it, so that small steps cost a large state no digits.
fn midpoint<const N: usize>(
    state: [f64; N],
    step: f64,
    parts: usize,
    rate: impl Fn([f64; N]) -> [f64; N],
) -> [f64; N] {
    let h = step / parts as f64;
    let at = |gained: [f64; N]| rate(std::array::from_fn(|axis| state[axis] + gained[axis]));
    let plus = |gained: [f64; N], h: f64, slope: [f64; N]| -> [f64; N] {
        std::array::from_fn(|axis| gained[axis] + h * slope[axis])
    };
    let (mut before, mut now) = ([0.0; N], plus([0.0; N], h, rate(state)));
    for _ in 1..parts {
        (before, now) = (now, plus(before, 2.0 * h, at(now)));
    }
    let end = plus(before, h, at(now));
    std::array::from_fn(|axis| (end[axis] + now[axis]) / 2.0)
}

#[test]
fn a_swing_returns() {
    let mut state = [1.0, 0.0];
    for _ in 0..40 {
        let gained = gain(state, std::f64::consts::TAU / 40.0, |[x, v]| [v, -x]);
        state = [state[0] + gained[0], state[1] + gained[1]];
    }
    assert!(abs_diff_eq!(state[0], 1.0, epsilon = 1e-13) && state[1].abs() < 1e-13, "{state:?}");
}
