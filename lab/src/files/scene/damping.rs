//! The damping limit of a scene.

use lyapunov::{DampingLimit, ParameterError, Scalar};

use super::Draft;

/// The factors of a loop's damping limit `cap · port_mass / T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Damping {
    /// The cap: the limit as a share of `port_mass / T`.
    pub(crate) cap: f64,
    /// The mass guaranteed to move with the port, kg.
    pub(crate) port_mass: f64,
    /// The servo period T, s.
    pub(crate) period: f64,
}

impl Damping {
    /// The limit in the scalar of the loop.
    pub(crate) fn limit<T: Scalar>(self) -> Result<DampingLimit<T>, ParameterError> {
        Self::limit_of_lanes(|_| self)
    }

    /// The limit of each lane.
    pub(crate) fn limit_of_lanes<T: Scalar>(
        lane: impl Fn(usize) -> Self,
    ) -> Result<DampingLimit<T>, ParameterError> {
        let each = |number: fn(Self) -> f64| T::from_lanes(|index| number(lane(index)));
        DampingLimit::of_mass(each(|it| it.cap), each(|it| it.port_mass), each(|it| it.period))
    }
}

impl Draft {
    /// The mass in kg guaranteed to move with the port: the device's, plus the operator's if no link is between them.
    pub fn port_mass(&self) -> f64 {
        let operator = if self.link.is_some() { 0.0 } else { self.operator.mass.get() };
        operator + self.device.mass.get()
    }

    /// The factors of this loop's damping limit, for a stabilizer with the damping cap `cap`.
    pub(crate) fn damping(&self, cap: f64) -> Damping {
        Damping { cap, port_mass: self.port_mass(), period: self.period() }
    }
}
