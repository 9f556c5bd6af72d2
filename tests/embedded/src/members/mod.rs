//! Every member of the family, with parameters.

mod bounding;
mod channel;
mod damping;
mod several_axes;

use lyapunov_core::{ParameterError, PortEnergy, Scalar, Signal, Stabilizer};
use lyapunov_stabilizers::{DampingLimit, Popc, TankLimits};

/// Scalar that may go to another thread.
pub trait Number: Scalar<Mask: Send + Sync> + Send + Sync + 'static {}

impl<T: Scalar<Mask: Send + Sync> + Send + Sync + 'static> Number for T {}

/// Visitor of members, each with its name and its type.
pub trait Visit<T: Number> {
    /// One member, a value without borrows that may go to another thread or to an interrupt.
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static;
}

/// Shows every member to a visitor. Those that docs/family.md has by name go by that name.
///
/// # Errors
/// A parameter that was refused.
pub fn visit<T: Number>(visit: &mut impl Visit<T>) -> Result<(), ParameterError> {
    damping::plain(visit)?;
    damping::credit(visit)?;
    damping::shaping(visit)?;
    damping::candidates(visit)?;
    damping::guarded(visit)?;
    bounding::forces(visit)?;
    bounding::memories(visit)?;
    bounding::stores(visit)?;
    bounding::ports(visit)?;
    channel::ends(visit)?;
    channel::waves(visit)?;
    several_axes::metrics(visit)?;
    several_axes::inertias(visit)?;
    several_axes::apart(visit)
}

fn period<T: Scalar>() -> T {
    T::of(1e-3)
}

fn limit<T: Scalar>() -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::of_mass(T::of(0.5), T::of(0.2), period())
}

fn popc<T: Scalar>() -> Result<Popc<T>, ParameterError> {
    Ok(Popc::new(PortEnergy, limit()?))
}

fn store<T: Scalar>() -> TankLimits<T> {
    let [start, floor, ceiling, power] = [2e-3, 1e-3, 5e-3, 3.0].map(T::of);
    TankLimits { start, floor, ceiling, power }
}
