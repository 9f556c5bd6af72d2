//! The paper's steps exactly as printed: the implementation that the hard cases break.
//!
//! Steps 1 to 6 of example 1, and with a `damping` those of example 2, in plain `f64` or `f32`:
//!
//! ```text
//! 3, 4  L(n) = L(n−1) + f₂(n) v₂(n) + α(n−1) v₂(n−1)² (+ b v₂(n)²)
//! 5     α(n) = −L(n) / v₂(n)² if L(n) < 0, else 0
//! 6     f₁(n) = f₂(n) + α(n) v₂(n)
//! ```
//!
//! Nothing is added: no period in the sum (it cancels in α), no limit, no check of the divisor, of the measurement
//! or of the applied force.

use lyapunov::{Correction, PortSample, Stabilizer};
use nalgebra::SVector;

/// The observer/controller of the paper's examples, as printed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Naive<T> {
    /// The environment's damping as example 2 credits it, N·s/m; 0 is example 1.
    pub damping: T,
    sum: T,
    alpha: T,
    square: T,
}

macro_rules! naive {
    ($($real:ident),*) => {$(
        impl Naive<$real> {
            /// Example 2 with this damping.
            pub fn crediting(damping: $real) -> Self {
                Self { damping, sum: 0.0, alpha: 0.0, square: 0.0 }
            }

            /// Steps 3 to 5: the damping of this tick, from the power `f₂ v₂` and the square `v₂²`.
            fn alpha(&mut self, power: $real, square: $real) -> $real {
                self.sum += power + self.alpha * self.square + self.damping * square;
                self.alpha = if self.sum < 0.0 { -self.sum / square } else { 0.0 };
                self.square = square;
                self.alpha
            }
        }

        impl Stabilizer<$real> for Naive<$real> {
            fn stabilize(&mut self, sample: &PortSample<$real>, f: $real) -> Correction<$real> {
                let v = sample.velocity;
                let alpha = self.alpha(f * v, v * v);
                let sum = self.sum * sample.period;
                Correction { observed_energy: sum, alpha, ..Correction::none(f + alpha * v) }
            }
        }

        impl<const N: usize> Stabilizer<SVector<$real, N>> for Naive<$real> {
            fn stabilize(
                &mut self,
                sample: &PortSample<SVector<$real, N>>,
                f: SVector<$real, N>,
            ) -> Correction<SVector<$real, N>> {
                let v = sample.velocity;
                let alpha = self.alpha(f.dot(&v), v.dot(&v));
                let sum = self.sum * sample.period;
                Correction { observed_energy: sum, alpha, ..Correction::none(f + v * alpha) }
            }
        }
    )*};
}

naive!(f64, f32);

#[cfg(test)]
mod tests {
    use lyapunov::HeldTick;

    use super::*;

    /// −1 N at 0.5 m/s gives L = −0.5 W, α = 2 N·s/m, f₁ = 0; then f₂ = 0, L = −0.5 + 0.5 = 0.
    #[test]
    fn two_ticks_by_hand() {
        let mut naive = Naive::<f64>::default();
        let sample = HeldTick {
            period: 1e-3,
            position: 0.0,
            velocity: 0.5,
            displacement: 5e-4,
            applied: 0.0,
        }
        .sample();
        let correction = naive.stabilize(&sample, -1.0);
        assert_eq!(
            (correction.effort, correction.alpha, correction.observed_energy),
            (0.0, 2.0, -0.5e-3)
        );
        let correction = naive.stabilize(&sample, 0.0);
        assert_eq!(
            (correction.effort, correction.alpha, correction.observed_energy),
            (0.0, 0.0, 0.0)
        );
    }

    /// A debt without motion gives −L / v² = ∞, times v = 0.
    #[test]
    fn a_debt_at_rest_is_divided_by_zero() {
        let mut naive = Naive::<f64>::default();
        naive.stabilize(
            &HeldTick {
                period: 1e-3,
                position: 0.0,
                velocity: 1e-3,
                displacement: 1e-6,
                applied: 0.0,
            }
            .sample(),
            -1.0,
        );
        naive.square = 0.0;
        assert!(naive.stabilize(&PortSample::starting(1e-3, 0.0, 0.0), -1.0).effort.is_nan());
    }
}
