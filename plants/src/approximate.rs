//! Comparison of values within a tolerance: `approx`'s traits, as in `lyapunov-core`.

use lyapunov_core::{Scalar, approximate};

use crate::{
    DampedMass, ElasticJoint, Impedance, RigidParts, Stribeck, TwoMassCoordinates, TwoMassParts,
    WithState,
};

approximate!(impl[T: PartialEq] Impedance<T>, of T { mass, damping, stiffness });
approximate!(impl[T: PartialEq] DampedMass<T>, of T { mass, damping });
approximate!(impl[T: PartialEq] ElasticJoint<T>, of T { stiffness, damping });
approximate!(impl[T: PartialEq] TwoMassParts<T>, of T { operator, device, link });
approximate!(impl[T: Scalar] RigidParts<T>, of T { mass, moments, damping, rotational_damping });
approximate!(impl[T: PartialEq] Stribeck<T>, of T { coulomb, breakaway, stribeck_velocity });
approximate!(impl[V: PartialEq] TwoMassCoordinates<V>, of V { device, stretch });
approximate!(impl[T: Scalar, const N: usize, const M: usize] WithState<T, N, M>, of T {
    input, state
});
