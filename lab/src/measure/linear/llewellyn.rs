//! Llewellyn's condition: a two-port that no two passive ends can make unstable.

use nalgebra::Complex;

/// Linear two-port at one frequency, by its impedance, admittance or hybrid parameters: the condition is the same for
/// all.
///
/// For a teleoperator or a haptic display by hybrid parameters, `[f₁, −v₂] = [[h₁₁, h₁₂], [h₂₁, h₂₂]] [v₁, f₂]`: the
/// operator is at port 1 and the environment at port 2, and power counts as positive into both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPort {
    /// First row, first column.
    pub p11: Complex<f64>,
    /// First row, second column: the effect of port 2 on port 1.
    pub p12: Complex<f64>,
    /// Second row, first column.
    pub p21: Complex<f64>,
    /// Second row, second column.
    pub p22: Complex<f64>,
}

impl TwoPort {
    /// `2 Re p₁₁ Re p₂₂ − |p₁₂ p₂₁| − Re(p₁₂ p₂₁)`, in the unit of `p₁₂ p₂₁`: the margin of the third of Llewellyn's
    /// conditions.
    pub fn margin(&self) -> f64 {
        let loops = self.p12 * self.p21;
        2.0 * self.p11.re * self.p22.re - loops.norm_sqr().sqrt() - loops.re
    }

    /// Whether the two-port is absolutely stable at this frequency: `Re p₁₁ ≥ 0`, `Re p₂₂ ≥ 0` and a
    /// [`margin`](Self::margin) that is not negative (Llewellyn, Proceedings of the IRE 40, 1952).
    ///
    /// If it is so at all frequencies and has no pole in the right half plane, or outside the unit circle if it is
    /// sampled, it is stable between any two passive ends that are not coupled. The condition is necessary as well:
    /// otherwise two such ends make it oscillate.
    pub fn is_absolutely_stable(&self) -> bool {
        self.p11.re >= 0.0 && self.p22.re >= 0.0 && self.margin() >= 0.0
    }

    /// The two-port with a zero-order hold of `period` s in the way from port 2 to port 1, at `frequency` rad/s.
    ///
    /// With the other parameters those of the sampled parts, this is the sampled two-port (Adams and Hannaford, IEEE
    /// Transactions on Robotics and Automation 15, 1999); frequencies are distinct up to `π / period`.
    #[must_use]
    pub fn held(self, frequency: f64, period: f64) -> Self {
        Self { p12: self.p12 * hold(frequency, period), ..self }
    }
}

/// The zero-order hold of `period` s at `frequency` rad/s: `(1 − e^(−jωT)) / (jωT) = e^(−jωT/2) sin(ωT/2) / (ωT/2)`.
pub fn hold(frequency: f64, period: f64) -> Complex<f64> {
    let half = 0.5 * frequency * period;
    let size = if half == 0.0 { 1.0 } else { libm::sin(half) / half };
    Complex::new(size * libm::cos(half), -size * libm::sin(half))
}

/// The first of `frequencies`, rad/s, at which a two-port is not absolutely stable; none if it is at all of them.
///
/// The two-port is a function of the frequency. Poles are not examined: see [`TwoPort::is_absolutely_stable`].
pub fn first_violation(
    frequencies: impl IntoIterator<Item = f64>,
    two_port: impl Fn(f64) -> TwoPort,
) -> Option<f64> {
    frequencies.into_iter().find(|frequency| !two_port(*frequency).is_absolutely_stable())
}
