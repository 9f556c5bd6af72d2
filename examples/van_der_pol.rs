//! A self-excited oscillator, kept at its initial amplitude.
//!
//! ```text
//! ẍ − (1 − x²) ẋ + x = u        V = ½ (x² + ẋ²)        the flow L_g V is ẋ
//! ```
//!
//! There is no controller and no effort: the plant itself makes V grow. So the port's energy stays 0, and V itself is
//! the candidate.

use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, ParameterError, Plant, PortEnergy, Stabilizer,
    integrators::RungeKutta4,
    models::{AffinePlant, QuadraticForm, VanDerPol, WithState, decrease_of},
};
use nalgebra::{Vector1, Vector2};

const PERIOD: f64 = 0.01;
const START: Vector2<f64> = Vector2::new(0.5, 0.0);

/// The largest |x| in each ten seconds of a minute.
fn run(
    candidate: impl LyapunovCandidate<WithState<f64, 2, 1>>,
) -> Result<[f64; 6], ParameterError> {
    let circle = QuadraticForm::sum_of_squares();
    let mut plant =
        AffinePlant::new(VanDerPol::new(1.0)?, circle, RungeKutta4, PERIOD, 1)?.starting(START);
    // The apparent mass of the port is 1: half of it over the period is the limit.
    let mut stabilizer = Lolc::new(candidate, DampingLimit::of_mass(0.5, 1.0, PERIOD)?);
    let nothing = WithState::of_input(Vector1::new(0.0));
    let mut sample = plant.start();
    let mut swings = [0.0_f64; 6];
    for tick in 0..6000 {
        let correction = stabilizer.stabilize(&sample, nothing);
        sample = plant.advance(correction.effort);
        swings[tick / 1000] = swings[tick / 1000].max(plant.state()[0].abs());
    }
    Ok(swings)
}

fn main() -> Result<(), ParameterError> {
    println!("largest |x| in each 10 s, from 0.5");
    let by_port = run(PortEnergy)?;
    println!("the input's energy watched   {by_port:7.3?}: no effort acts, so it sees nothing");
    let by_v = run(decrease_of(QuadraticForm::sum_of_squares(), START))?;
    println!("V itself watched             {by_v:7.3?}: stays within 1 %");
    assert!(by_port[5] > 2.0, "the limit cycle");
    assert!(by_v.iter().all(|&swing| swing < 0.505), "never above where it began");
    assert!(by_v[5] > 0.4, "held, not stopped");
    Ok(())
}
