//! `differential-equations`: explicit pairs of orders 5 to 9, and RK4.

use ::differential_equations::methods::ExplicitRungeKutta;
use ::differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use ::differential_equations::prelude::{ControlFlag, Interpolation, Solout, Solution};

use super::STEPS;
use crate::row::{Origin, Row};
use crate::scene::{PERIOD, Positions, State, rate, rollout};

pub(super) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    macro_rules! pairs {
        ($($pair:ident),+) => {$(
            rows.extend(Row::adaptive(
                Origin::Crate,
                concat!("differential-equations ", stringify!($pair)),
                |positions, tolerance| {
                    let method = ExplicitRungeKutta::$pair().rtol(tolerance).atol(tolerance);
                    run(positions, method.h0(PERIOD).max_steps(usize::MAX));
                },
            ));
        )+};
    }
    pairs!(dop853, dopri5, rkv655e, rkv766e, rkv877e, rkv988e);
    rows.extend(Row::stepped(
        Origin::Crate,
        "differential-equations rk4",
        STEPS,
        |positions, steps| {
            let method = ExplicitRungeKutta::rk4(PERIOD / f64::from(steps));
            run(positions, method.max_steps(usize::MAX));
        },
    ));
    rows
}

/// The held force.
struct Held(f64);

impl ODE<f64, State> for Held {
    fn diff(&self, _: f64, state: &State, slope: &mut State) {
        *slope = rate(*state, self.0);
    }
}

/// Recorder of nothing; the method keeps the state.
struct Unrecorded;

impl Solout<f64, State> for Unrecorded {
    fn solout<I: Interpolation<f64, State> + ?Sized>(
        &mut self,
        _: f64,
        _: f64,
        _: &State,
        _: &State,
        _: &mut I,
        _: &mut Solution<f64, State>,
    ) -> ControlFlag<f64, State> {
        ControlFlag::Continue
    }
}

#[inline(always)]
fn run(
    positions: &mut Positions,
    mut method: impl OrdinaryNumericalMethod<f64, State> + Interpolation<f64, State>,
) {
    rollout(positions, |state, force| {
        solve_ode(&mut method, &Held(force), 0.0, PERIOD, &state, &mut Unrecorded)
            .unwrap_or_else(|_| unreachable!("a linear motion"));
        *method.y()
    });
}
