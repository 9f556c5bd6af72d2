//! Stiffness rules of one line: Gil's, and Abbott and Okamura's for a device with friction and an encoder.

use crate::files::Scene;

/// The largest stiffness by the linear rule `K < (b + B) / (T / 2 + t_d)`, N/m; none where the environment has no
/// stiffness.
///
/// `b` is the damping of device and operator, `B` the virtual wall's, `t_d` the delay. A held force is late by `T / 2`
/// on average, so `T` is the period at which the environment answers (Gil, Sánchez, Hulin, Preusche and Hirzinger,
/// Journal of Computing and Information Science in Engineering 9, 2009, after the discrete case of Gil, Avello, Rubio
/// and Flórez, IEEE Transactions on Control Systems Technology 12, 2004).
///
/// It is the first order in the period of the exact limit: one rigid mass, backward-difference velocity, `(b + B) T`
/// small against the mass, and neither a spring of the operator nor a filter that matters. It is a rule and not a
/// bound: outside these conditions it may promise too much. A total damping below 0 gives 0.
pub(super) fn gil(scene: &Scene) -> Option<f64> {
    let environment = scene.environment.kind().impedance()?;
    let damping = scene.device.damping.get() + scene.operator.damping.get() + environment.damping;
    let held = scene.period() * scene.environment_ratio() as f64;
    let late = scene.period() * f64::from(scene.delay_ticks());
    Some((damping / (0.5 * held + late)).max(0.0))
}

/// The largest stiffness of a spring by `K ≤ min(2 b / T, 2 f_c / Δ)`, N/m; none without an encoder, without Coulomb
/// friction, or without a stiffness.
///
/// `b` is the device's damping and `f_c` its Coulomb friction, `Δ` the encoder's step, `T` the period at which the
/// environment answers. Sufficient for the port to be passive (Abbott and Okamura, IEEE Transactions on Robotics 21,
/// 2005): the first part pays for the hold, the second for the half step that a count may be off. It is about a spring
/// alone, without a damper, without delay and without static friction beyond the Coulomb friction, on one axis: in a space
/// friction that acts along the surface pays for nothing across it, so there it is none.
pub(super) fn friction_quantization(scene: &Scene) -> Option<f64> {
    scene.environment.kind().impedance().filter(|_| scene.dimensions() == 1)?;
    let (friction, encoder) = (scene.effects.friction?, scene.effects.encoder?);
    let held = scene.period() * scene.environment_ratio() as f64;
    let by_damping = 2.0 * scene.device.damping.get() / held;
    let by_friction = 2.0 * friction.coulomb.get() / encoder.resolution.get();
    Some(by_damping.min(by_friction))
}
