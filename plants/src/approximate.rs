//! Comparison of values within a tolerance: `approx`'s traits, as in `lyapunov-core`.

use lyapunov_core::{Scalar, approximate};

use crate::{DampedMass, Impedance, Joined, Link, Stribeck, TwoMass, WithState};

approximate!(impl[T: PartialEq] Impedance<T>, of T { mass, damping, stiffness });
approximate!(impl[T: PartialEq] DampedMass<T>, of T { mass, damping });
approximate!(impl[T: PartialEq] Link<T>, of T { stiffness, damping });
approximate!(impl[T: PartialEq] TwoMass<T>, of T { operator, device, link });
approximate!(impl[T: PartialEq] Stribeck<T>, of T { coulomb, breakaway, stribeck_velocity });
approximate!(impl[V: PartialEq] Joined<V>, of V { device, stretch });
approximate!(impl[T: Scalar, const N: usize, const M: usize] WithState<T, N, M>, of T {
    input, state
});
