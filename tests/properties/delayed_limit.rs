//! Damping that keeps a delayed loop of a mass stable.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use lyapunov::{
    DampingLimit, OnePort, ParameterError, Plant, PortSample, Signal,
    bodies::{Body, Impedance},
    effects::OnePortExt,
};

const MASS: f64 = 0.2;
const PERIOD: f64 = 1e-3;

/// A damper that always acts, N·s/m.
struct Damper(f64);

impl OnePort<f64> for Damper {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        self.0 * sample.velocity
    }
}

/// The largest speed of a free mass in the second half of a long run over that in the first half, under a damper of
/// `share` of m / T that is `ticks` late.
fn growth(share: f64, ticks: u32, differenced: bool) -> f64 {
    let parts = Impedance { mass: MASS, damping: 0.0, stiffness: 0.0 };
    let mut plant = Body::new(parts, PERIOD).expect("a body").starting(0.0, 0.1);
    let damper = Damper(share * MASS / PERIOD);
    let run = |port: &mut dyn OnePort<f64>, plant: &mut Body<f64>| {
        let mut sample = plant.start();
        let mut peaks = [0.0_f64; 2];
        for tick in 0..8000 {
            sample = plant.advance(port.respond(&sample));
            let part = usize::from(tick >= 4000);
            peaks[part] = peaks[part].max(sample.velocity.abs());
        }
        peaks[1] / peaks[0]
    };
    let port = damper.delayed::<8>(ticks).expect("a delay");
    if differenced {
        run(&mut port.differenced(), &mut plant)
    } else {
        let mut port = port;
        run(&mut port, &mut plant)
    }
}

/// The published limit of `v(n+1) = v(n) − a v(n−d)` and that of the backward difference, from below and from above.
#[test]
fn the_damper_that_grows_is_where_the_formulas_say() {
    for ticks in 0..=5 {
        let late = ticks as f64;
        let told = 2.0 * (PI / (2.0 * (2.0 * late + 1.0))).sin();
        let differenced = 2.0 * (PI / (4.0 * (late + 1.0))).tan();
        for (share, of_difference) in [(told, false), (differenced, true)] {
            assert!(growth(0.99 * share, ticks, of_difference) < 1.0, "{ticks} {of_difference}");
            assert!(growth(1.02 * share, ticks, of_difference) > 10.0, "{ticks} {of_difference}");
        }
        assert!(differenced <= told * (1.0 + 1e-12));
    }
}

#[test]
fn the_limit_is_a_quarter_of_what_grows() -> Result<(), ParameterError> {
    let half = DampingLimit::of_mass(0.5, MASS, PERIOD)?;
    assert_eq!(half.delayed(0), half);
    for ticks in 0..=5_u32 {
        let share = half.delayed(ticks).most() * PERIOD / MASS;
        let grows = 2.0 * (PI / (4.0 * (f64::from(ticks) + 1.0))).tan();
        assert_abs_diff_eq!(share, grows / 4.0, epsilon = 1e-15);
        assert!(growth(share, ticks, true) < 1e-3);
    }
    // An infinite limit becomes finite under a delay; a limit of 0 stays 0.
    let endless: DampingLimit<f32> = DampingLimit::at(f32::INFINITY)?;
    assert!(endless.delayed(3).most().finite() && endless.delayed(u32::MAX).most() >= 0.0);
    assert_eq!(DampingLimit::at(0.0_f64)?.delayed(3).most(), 0.0);
    Ok(())
}
