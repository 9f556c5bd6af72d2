//! `ode_solvers`: Hairer's dopri5 and dop853, and RK4.

use ::ode_solvers::{Dop853, Dopri5, OutputType, Rk4, System, Vector2};

use super::STEPS;
use crate::row::{Origin, Row};
use crate::scene::{PERIOD, Positions, State, rate, rollout};

pub(super) fn rows() -> Vec<Row> {
    let mut rows: Vec<_> = Row::adaptive(Origin::Crate, "ode_solvers Dop853", dop853).collect();
    rows.extend(Row::adaptive(Origin::Crate, "ode_solvers Dopri5", dopri5));
    rows.extend(Row::stepped(Origin::Crate, "ode_solvers Rk4", STEPS, runge_kutta_4));
    rows
}

/// The held force.
struct Held(f64);

impl System<f64, Vector2<f64>> for Held {
    fn system(&self, _: f64, state: &Vector2<f64>, slope: &mut Vector2<f64>) {
        *slope = rate([state[0], state[1]], self.0).into();
    }
}

fn ended(states: &[Vector2<f64>]) -> State {
    (*states.last().expect("the end of the period")).into()
}

/// Numbers of steps after which the solver gives up, and after which it looks for stiffness.
const LIMITS: [u32; 2] = [100_000, 1000];

// Dense output, the default, can leave the end of the period out by rounding; sparse output always ends with it. The
// controllers are the defaults.

/// A rollout by an adaptive solver with its controller's safety, beta, and least and largest change of the step.
macro_rules! adaptive {
    ($name:ident, $solver:ident, $safety:literal, $beta:literal, $least:literal, $most:literal) => {
        fn $name(positions: &mut Positions, tolerance: f64) {
            rollout(positions, |state, force| {
                let mut solver = $solver::from_param(
                    Held(force),
                    0.0,
                    PERIOD,
                    PERIOD,
                    state.into(),
                    tolerance,
                    tolerance,
                    $safety,
                    $beta,
                    $least,
                    $most,
                    PERIOD,
                    PERIOD,
                    LIMITS[0],
                    LIMITS[1],
                    OutputType::Sparse,
                );
                solver.integrate().expect("a linear motion");
                ended(solver.y_out())
            });
        }
    };
}
adaptive!(dopri5, Dopri5, 0.9, 0.04, 0.2, 10.0);
adaptive!(dop853, Dop853, 0.9, 0.0, 0.333, 6.0);

fn runge_kutta_4(positions: &mut Positions, steps: u32) {
    let step = PERIOD / f64::from(steps);
    rollout(positions, |state, force| {
        let mut solver = Rk4::new(Held(force), 0.0, state.into(), PERIOD, step);
        solver.integrate().expect("a linear motion");
        ended(solver.y_out())
    });
}
