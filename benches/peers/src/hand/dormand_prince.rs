//! Dormand and Prince's pair by hand: order 5 with an error estimate of order 4.

use crate::scene::{PERIOD, Positions, State, rate, rollout};

/// Pair of Dormand and Prince (1980) with its step chosen by the estimate; the last slope is the next step's first, and
/// the step is carried on from period to period (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations
/// I, 1993, II.4 and II.5).
#[inline(never)]
pub(crate) fn dormand_prince(positions: &mut Positions, tolerance: f64) {
    let mut proposed = PERIOD;
    rollout(positions, |mut state, force| {
        let mut slope = rate(state, force);
        let mut left = PERIOD;
        loop {
            let last = proposed >= left;
            let step = if last { left } else { proposed };
            let tried = Tried::new(state, slope, force, step);
            let error = tried.error(state, step, tolerance);
            let factor = (0.9 * error.powf(-0.2)).clamp(0.2, 10.0);
            if error > 1.0 {
                proposed = step * factor;
                continue;
            }
            (state, slope) = (tried.state, tried.slopes[6]);
            // A step that was cut to fit the period is no reason against a longer one.
            proposed = if last { proposed.max(step * factor) } else { step * factor };
            if last {
                return state;
            }
            left -= step;
        }
    });
}

/// Trial step.
struct Tried {
    state: State,
    slopes: [State; 7],
}

impl Tried {
    #[inline(always)]
    fn new(from: State, first: State, force: f64, step: f64) -> Self {
        let mut slopes = [first; 7];
        macro_rules! stage {
            ($stage:literal: $($weight:expr, $of:literal);+) => {{
                let state = [0, 1].map(|part| from[part] + step * (0.0 $(+ $weight * slopes[$of][part])+));
                slopes[$stage] = rate(state, force);
                state
            }};
        }
        stage!(1: 1.0 / 5.0, 0);
        stage!(2: 3.0 / 40.0, 0; 9.0 / 40.0, 1);
        stage!(3: 44.0 / 45.0, 0; -56.0 / 15.0, 1; 32.0 / 9.0, 2);
        stage!(4: 19372.0 / 6561.0, 0; -25360.0 / 2187.0, 1; 64448.0 / 6561.0, 2; -212.0 / 729.0, 3);
        stage!(5: 9017.0 / 3168.0, 0; -355.0 / 33.0, 1; 46732.0 / 5247.0, 2; 49.0 / 176.0, 3;
               -5103.0 / 18656.0, 4);
        let state = stage!(6: 35.0 / 384.0, 0; 500.0 / 1113.0, 2; 125.0 / 192.0, 3; -2187.0 / 6784.0, 4;
               11.0 / 84.0, 5);
        Self { state, slopes }
    }

    /// The root mean square of the estimate, in tolerances.
    #[inline(always)]
    fn error(&self, from: State, step: f64, tolerance: f64) -> f64 {
        const WEIGHTS: [f64; 7] = [
            71.0 / 57600.0,
            0.0,
            -71.0 / 16695.0,
            71.0 / 1920.0,
            -17253.0 / 339_200.0,
            22.0 / 525.0,
            -1.0 / 40.0,
        ];
        let [position, velocity] = [0, 1].map(|part| {
            let weighed =
                WEIGHTS.iter().zip(&self.slopes).map(|(weight, slope)| weight * slope[part]);
            let size = from[part].abs().max(self.state[part].abs());
            step * weighed.sum::<f64>() / (tolerance * (1.0 + size))
        });
        (0.5 * (position * position + velocity * velocity)).sqrt()
    }
}
