//! Motion of the fitted model from row to row, exact under a held force.

use std::collections::HashMap;

use lyapunov::bodies::held_input;
use nalgebra::{SMatrix, SVector};

/// The model's coefficients, `ẍ = −decay ẋ − spring x + bias − mobility f`.
pub(super) type Coefficients = SVector<f64, 4>;

/// Places of the coefficients: `b / m` in 1/s, `k / m` in 1/s², `c / m` in m/s², `1 / m` in 1/kg.
pub(super) const DECAY: usize = 0;
pub(super) const SPRING: usize = 1;
pub(super) const BIAS: usize = 2;
pub(super) const MOBILITY: usize = 3;

/// Responses of the model: to a position of 1, a velocity of 1, an acceleration of 1 and the log's force.
pub(super) const RESPONSES: usize = 4;

/// Positions and velocities of all responses, and their derivatives by decay and by spring, two rows each.
pub(super) type State = SMatrix<f64, 6, RESPONSES>;

/// Part of the median period to which periods are told apart.
const FINEST: f64 = 1e-7;

/// Steps of the model, kept for each period that occurs.
#[derive(Debug)]
pub(super) struct Motion {
    decay: f64,
    spring: f64,
    unit: f64,
    steps: HashMap<u64, SMatrix<f64, 6, 7>>,
}

impl Motion {
    /// The motion of a log whose median period is `period`, s.
    pub(super) fn new(coefficients: &Coefficients, period: f64) -> Self {
        let [decay, spring] = [coefficients[DECAY], coefficients[SPRING]];
        Self { decay, spring, unit: FINEST * period, steps: HashMap::new() }
    }

    /// The responses at the start of a segment.
    pub(super) fn start() -> State {
        let mut state = State::zeros();
        (state[(0, 0)], state[(1, 1)]) = (1.0, 1.0);
        state
    }

    /// The responses one `period` later, `force` held meanwhile.
    pub(super) fn advance(&mut self, state: &mut State, period: f64, force: f64) {
        // The conversion saturates, and no period is below 0.
        let key = (period / self.unit).round() as u64;
        let (decay, spring, time) = (self.decay, self.spring, key as f64 * self.unit);
        let step = self.steps.entry(key).or_insert_with(|| increment(decay, spring, time));
        let input = [0.0, 0.0, 1.0, -force];
        // By number: a product of matrices is a call for each column unless all is compiled in one part.
        let before = *state;
        for (column, input) in input.into_iter().enumerate() {
            for row in 0..6 {
                let mut moved = 0.0;
                for it in 0..6 {
                    moved += step[(row, it)] * before[(it, column)];
                }
                state[(row, column)] += moved + step[(row, 6)] * input;
            }
        }
    }
}

/// `exp(M T) − I` of the motion with its derivatives: where `ẍ = −d ẋ − s x + u`, the derivatives `y` by `d` and `z` by `s`
/// follow `ÿ = −d ẏ − s y − ẋ` and `z̈ = −d ż − s z − x`.
fn increment(decay: f64, spring: f64, time: f64) -> SMatrix<f64, 6, 7> {
    let mut rate = SMatrix::<f64, 7, 7>::zeros();
    for at in [0, 2, 4] {
        rate[(at, at + 1)] = 1.0;
        rate[(at + 1, at)] = -spring;
        rate[(at + 1, at + 1)] = -decay;
    }
    rate[(1, 6)] = 1.0;
    rate[(3, 1)] = -1.0;
    rate[(5, 0)] = -1.0;
    held_input(rate * time).fixed_rows::<6>(0).into_owned()
}

/// Position and velocity a `time` before those of `state`, without a force meanwhile.
pub(super) fn before(at: &Coefficients, time: f64, state: [f64; 2]) -> [f64; 2] {
    let step = increment(at[DECAY], at[SPRING], -time);
    let [position, velocity] = state;
    let moved = |row: usize| {
        step[(row, 0)] * position + step[(row, 1)] * velocity + step[(row, 6)] * at[BIAS]
    };
    [position + moved(0), velocity + moved(1)]
}
