//! Scene of all methods: `scenes/paper-8k-none.toml` over its first 2 s, with the plant's own velocity.

/// Mass of operator and device as one, kg.
pub(crate) const MASS: f64 = 0.1 + 0.2;
/// Damping of operator and device, N·s/m.
pub(crate) const DAMPING: f64 = 0.2 + 0.001;
/// Stiffness of the operator, at rest at the wall, N/m.
pub(crate) const STIFFNESS: f64 = 50.0;
/// Initial position, m.
pub(crate) const START: f64 = -0.004;
/// Stiffness of the wall, N/m.
pub(crate) const WALL_STIFFNESS: f64 = 8000.0;
/// Damping of the wall, N·s/m.
pub(crate) const WALL_DAMPING: f64 = 2.0;
/// Period over which the wall's force is held, s.
pub(crate) const PERIOD: f64 = 0.01;
/// Periods of the run.
pub(crate) const PERIODS: usize = 200;
/// Length of the run, s.
pub(crate) const DURATION: f64 = PERIODS as f64 * PERIOD;

/// Position of the mass at each instant, m.
pub(crate) type Positions = [f64; PERIODS + 1];

/// Position, m, and velocity, m/s.
pub(crate) type State = [f64; 2];

/// Equation of motion under the held `force`: the rates of position and velocity, without a division.
#[inline(always)]
pub(crate) fn rate([position, velocity]: State, force: f64) -> State {
    const OF: [f64; 3] = [-STIFFNESS / MASS, -DAMPING / MASS, -1.0 / MASS];
    [velocity, OF[0] * position + OF[1] * velocity + OF[2] * force]
}

/// Sampled loop around `advance`, which takes a state and the held force and returns the state a period later.
#[inline(always)]
pub(crate) fn rollout(positions: &mut Positions, mut advance: impl FnMut(State, f64) -> State) {
    let mut state = [START, 0.0];
    positions[0] = START;
    for at in &mut positions[1..] {
        let [position, velocity] = state;
        let force = WALL_STIFFNESS * position + WALL_DAMPING * velocity;
        let force = if position > 0.0 && force > 0.0 { force } else { 0.0 };
        state = advance(state, force);
        *at = state[0];
    }
}
