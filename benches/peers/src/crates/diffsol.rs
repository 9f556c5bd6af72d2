//! `diffsol`: Tsitouras' pair 5(4).

use std::cell::Cell;
use std::rc::Rc;

use ::diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason, Vector};

use crate::row::{Origin, Row};
use crate::scene::{PERIOD, Positions, START, rate, rollout};

pub(super) fn rows() -> Vec<Row> {
    Row::adaptive(Origin::Crate, "diffsol tsit45", tsit45).collect()
}

/// One solver for the whole run: at each period it is notified of the changed slope, and goes on with its state.
fn tsit45(positions: &mut Positions, tolerance: f64) {
    let held = Rc::new(Cell::new(0.0));
    let force = Rc::clone(&held);
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(tolerance)
        .atol([tolerance, tolerance])
        .h0(PERIOD)
        .rhs(move |state, _, _, slope| {
            slope.copy_from_slice(&rate([state[0], state[1]], force.get()));
        })
        .init(|_, _, state| state.copy_from_slice(&[START, 0.0]), 2)
        .build()
        .expect("the scene");
    let mut solver = problem.tsit45().expect("the scene");
    let mut ended = 0_u32;
    rollout(positions, |state, force| {
        held.set(force);
        let [slope, curvature] = rate(state, force);
        let kept = solver.state_mut();
        kept.dy.set_index(0, slope);
        kept.dy.set_index(1, curvature);
        ended += 1;
        solver.set_stop_time(f64::from(ended) * PERIOD).expect("a later instant");
        while !matches!(solver.step(), Ok(OdeSolverStopReason::TstopReached)) {}
        let state = solver.state();
        [state.y.get_index(0), state.y.get_index(1)]
    });
}
