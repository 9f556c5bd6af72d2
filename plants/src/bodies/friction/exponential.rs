//! Power series of the friction of a changing velocity.

use lyapunov_core::Scalar;
use lyapunov_core::lanes::apart;

use super::Stribeck;
use super::root::{ORDER, Polynomial};

/// The power series of `q = exp(−y²)`, from `k q_k = Σ j g_j q_(k−j)` for `q = exp g` (Knuth, The Art of Computer
/// Programming, volume 2, section 4.7).
pub(super) struct Exponential<T> {
    ratio: Polynomial<T>,
    /// Coefficient `j` of the exponent, `j` times.
    exponent: Polynomial<T>,
    value: Polynomial<T>,
}

impl<T: Scalar> Exponential<T> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        let none = [T::zero(); ORDER + 1];
        Self { ratio: none, exponent: none, value: none }
    }

    /// The friction at the start. A function of its own: `exp` runs lane by lane, and beside it the compiler would split the other
    /// numbers into lanes too.
    #[inline(always)]
    pub(super) fn first(&mut self, law: &Stribeck<T>, velocity: T) -> T {
        let ratio = velocity / law.stribeck_velocity;
        let square = ratio * ratio;
        let value = T::from_lanes(|lane| libm::exp(-square.lane(lane)));
        (self.ratio[0], self.value[0]) = (ratio, value);
        law.coulomb + (law.breakaway - law.coulomb) * value
    }

    /// Coefficient `k` of the friction, not the first; the earlier ones must have been computed.
    #[inline(always)]
    pub(super) fn coefficient(&mut self, law: &Stribeck<T>, velocity: T, k: usize) -> T {
        self.ratio[k] = velocity / law.stribeck_velocity;
        let square = product(&self.ratio, &self.ratio, 0, k);
        self.exponent[k] = T::of(k as f64) * -square;
        let sum = product(&self.exponent, &self.value, 1, k);
        self.value[k] = sum / T::of(k as f64);
        (law.breakaway - law.coulomb) * self.value[k]
    }
}

/// The sum of `a_j b_(k − j)` for `j` from `first` to `k`.
#[inline(always)]
pub(super) fn product<T: Scalar>(
    a: &Polynomial<T>,
    b: &Polynomial<T>,
    first: usize,
    k: usize,
) -> T {
    let mut sum = a[first] * b[k - first];
    for j in first + 1..k + 1 {
        apart::<T>();
        sum += a[j] * b[k - j];
    }
    sum
}
