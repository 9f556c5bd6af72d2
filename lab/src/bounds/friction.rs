//! Abbott and Okamura's limit, for a device that rubs and counts.

use crate::Scene;

/// The largest stiffness of a spring by `K ≤ min(2 b / T, 2 f_c / Δ)`, N/m; none without an encoder, without Coulomb
/// friction, or without a stiffness.
///
/// `b` is the device's damping and `f_c` its Coulomb friction, `Δ` the encoder's step, `T` the period at which the
/// environment answers. Sufficient for the port to be passive (Abbott and Okamura, IEEE Transactions on Robotics 21, 2005):
/// the first part pays for the hold, the second for the half step that a count may be off. It is about a spring alone, without
/// a damper, without delay and without a static friction beyond the Coulomb one.
pub(super) fn max_stiffness(scene: &Scene) -> Option<f64> {
    scene.environment.kind().impedance()?;
    let (friction, encoder) = (scene.effects.friction?, scene.effects.encoder?);
    let held = scene.period() * scene.environment_ratio() as f64;
    let by_damping = 2.0 * scene.device.damping.get() / held;
    let by_friction = 2.0 * friction.coulomb.get() / encoder.resolution.get();
    Some(by_damping.min(by_friction))
}
