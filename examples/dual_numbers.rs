//! A plant of your own, with V written once and its gradient by dual numbers: predators that are managed too late.
//!
//! ```text
//! prey ṗ = p (1 − q),  predators q̇ = q (p − 1) + u, both in units of their equilibrium, time in units of their own
//! V = (p − 1 − ln p) + (q − 1 − ln q), constant under Lotka and Volterra's equations    the flow L_g V is 1 − 1/q
//! ```
//!
//! A controller removes predators in proportion to their excess, by a count that is three units of time old: half a
//! period late, it feeds the oscillation. The stabilizer corrects it by the present count.

use lyapunov::laws::{self, Violation};
use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{AffinePlant, ControlAffine, Decay, LyapunovFunction, StateFeedback, decrease_of},
};
use nalgebra::{Vector1, Vector2};
use num_dual::{Dual64, DualNum};

const PERIOD: f64 = 0.02;
const LATE: u32 = 150; // ticks
const START: Vector2<f64> = Vector2::new(0.3, 0.0); // counted from the equilibrium

#[derive(Clone, Copy)]
struct Prey;

impl ControlAffine<f64, 2, 1> for Prey {
    fn drift(&self, x: Vector2<f64>) -> Vector2<f64> {
        Vector2::new(-(1.0 + x[0]) * x[1], (1.0 + x[1]) * x[0])
    }

    fn input_fields(&self, _: Vector2<f64>) -> [Vector2<f64>; 1] {
        [Vector2::new(0.0, 1.0)]
    }
}

/// `V` of any kind of number: `f64`, or dual numbers, which carry a derivative along.
fn value<D: DualNum<Primitive = f64>>([p, q]: [D; 2]) -> D {
    p.clone() - (p + 1.0).ln() + q.clone() - (q + 1.0).ln()
}

#[derive(Clone, Copy)]
struct Balance;

impl LyapunovFunction<Vector2<f64>> for Balance {
    fn value(&self, x: Vector2<f64>) -> f64 {
        value([x[0], x[1]])
    }

    fn gradient(&self, x: Vector2<f64>) -> Vector2<f64> {
        let along = |p, q| value([Dual64::new(x[0], p), Dual64::new(x[1], q)]).eps;
        Vector2::new(along(1.0, 0.0), along(0.0, 1.0))
    }
}

/// The largest number of predators in each of six intervals of twenty units of time.
fn run(damping_cap: f64) -> Result<[f64; 6], ParameterError> {
    let mut plant = AffinePlant::new(Prey, Balance, RungeKutta4, PERIOD, 1)?.starting(START);
    // The apparent mass is 1 / (∂²V/∂q²) = q², and q is seldom below a half.
    let limit = DampingLimit::of_mass(damping_cap, 0.25, PERIOD)?;
    let candidate = (decrease_of(Balance, START), Decay::new(Balance, 0.2)?);
    let mut port = StateFeedback::new(|x: Vector2<f64>| Vector1::new(-0.2 * x[1]))
        .delayed::<256>(LATE)?
        .stabilized(Lolc::new(candidate, limit));
    let mut sample = plant.start();
    let mut most = [0.0_f64; 6];
    for tick in 0..6000 {
        sample = plant.advance(port.respond(&sample));
        most[tick / 1000] = most[tick / 1000].max(1.0 + plant.state()[1]);
    }
    Ok(most)
}

fn checked() -> Result<(), Violation> {
    let around = (1..8).map(|i| Vector2::new(0.1, -0.08) * f64::from(i));
    laws::lyapunov_function(&Balance, around)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    checked()?;
    println!("most predators in each stretch of 20, by their balance; 0: died out");
    let without = run(0.0)?;
    println!("without stabilizer  {without:6.2?}");
    let with = run(0.5)?;
    println!("with                {with:6.2?}");
    assert!(without[0] > 2.0 && without[5] == 0.0, "swings grow until they die out");
    assert!(with[0] < 1.4 && with[5] < 1.05, "swings die out");
    Ok(())
}
