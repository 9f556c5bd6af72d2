//! `russell_ode`: explicit pairs of orders 5 to 8, and RK4, with the default features. The optional C library computes
//! with matrices, of which explicit methods have none.

use ::russell_lab::Vector;
use ::russell_ode::{Method, OdeSolver, Params, System};

use super::STEPS;
use crate::row::{Origin, Row};
use crate::scene::{PERIOD, Positions, START, rate, rollout};

pub(super) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    macro_rules! pairs {
        ($($pair:ident),+) => {$(
            let name = concat!("russell_ode ", stringify!($pair));
            rows.extend(Row::adaptive(Origin::Crate, name, |positions, tolerance| {
                run(positions, Method::$pair, Some(tolerance), None);
            }));
        )+};
    }
    pairs!(DoPri8, DoPri5, Verner6, Fehlberg7);
    rows.extend(Row::stepped(Origin::Crate, "russell_ode Rk4", STEPS, |positions, steps| {
        run(positions, Method::Rk4, None, Some(PERIOD / f64::from(steps)));
    }));
    rows.extend(Row::stepped(
        Origin::Crate,
        "russell_ode DoPri8 equal",
        &[1, 2],
        |positions, steps| {
            run(positions, Method::DoPri8, None, Some(PERIOD / f64::from(steps)));
        },
    ));
    rows
}

fn run(positions: &mut Positions, method: Method, tolerance: Option<f64>, step: Option<f64>) {
    let system = System::new(2, |slope: &mut Vector, _, state: &Vector, force: &mut f64| {
        [slope[0], slope[1]] = rate([state[0], state[1]], *force);
        Ok(())
    });
    let mut parameters = Params::new(method);
    parameters.step.h_ini = PERIOD;
    parameters.stiffness.enabled = false;
    if let Some(tolerance) = tolerance {
        parameters.set_tolerances(tolerance, tolerance, None).expect("a tolerance");
    }
    let mut solver = OdeSolver::new(parameters, system).expect("the scene");
    let mut state = Vector::from(&[START, 0.0]);
    rollout(positions, |_, mut force| {
        solver.solve(&mut state, 0.0, PERIOD, step, &mut force, None).expect("a linear motion");
        [state[0], state[1]]
    });
}
