//! Gil's rule.

use super::linear_part::delay;
use crate::Scene;

/// The largest stiffness by the linear rule `K < (b + B) / (T / 2 + t_d)`, N/m; none where the environment has no stiffness.
///
/// `b` is the damping of device and operator, `B` the virtual wall's, `t_d` the delay. `T / 2` is how late a held force is on
/// average, so that `T` is the period at which the environment answers (Gil, Sánchez, Hulin, Preusche and Hirzinger, Journal
/// of Computing and Information Science in Engineering 9, 2009, after the discrete case of Gil, Avello, Rubio and Flórez, IEEE
/// Transactions on Control Systems Technology 12, 2004).
///
/// It is the first order in the period of the exact limit: one rigid mass, backward-difference velocity, `(b + B) T` small
/// against the mass, and neither a spring of the operator nor a filter that matters. It is a rule and no bound: outside of
/// that it may promise too much. A damping below 0 in all leaves 0.
pub(super) fn max_stiffness(scene: &Scene) -> Option<f64> {
    let environment = scene.environment.kind().impedance()?;
    let damping = scene.device.damping.get() + scene.operator.damping.get() + environment.damping;
    let held = scene.period() * scene.environment_ratio() as f64;
    let late = scene.period() * delay(scene) as f64;
    Some((damping / (0.5 * held + late)).max(0.0))
}
