//! Dimensionless groups of a sampled loop.

use serde::Serialize;

use crate::files::Scene;

/// The dimensionless groups of a scene. `r T` is the period at which the environment answers, `b` the device's damping,
/// `m` the mass that moves at the port, `K` and `B` the environment's stiffness and damping.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DimensionlessGroups {
    /// `K r T / b`: at most 2 for a device with a plain spring to be passive; none without damping.
    pub krt_over_b: Option<f64>,
    /// `K (r T)² / m`: the square of the angle, in radians, that a free swing turns in one period.
    pub kr2t2_over_m: Option<f64>,
    /// `B r T / m`: the share of the velocity that the virtual damper removes in one period.
    pub brt_over_m: Option<f64>,
    /// The delay in servo ticks.
    pub delay_ticks: u16,
}

impl DimensionlessGroups {
    /// The groups of `scene`.
    pub fn of(scene: &Scene) -> Self {
        let period = scene.period() * scene.environment_ratio() as f64;
        let (mass, damping) = (scene.port_mass(), scene.device.damping.get());
        let environment = scene.environment.kind().impedance();
        let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
        Self {
            krt_over_b: finite(environment.map(|it| it.stiffness * period / damping)),
            kr2t2_over_m: finite(environment.map(|it| it.stiffness * period * period / mass)),
            brt_over_m: finite(environment.map(|it| it.damping * period / mass)),
            delay_ticks: scene.effects.delay.map_or(0, |delay| delay.ticks.get()),
        }
    }
}
