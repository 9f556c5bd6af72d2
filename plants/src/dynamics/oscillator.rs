//! One mass on a spring and a damper.

use lyapunov_core::{Mechanics, ParameterError, Requirement, Scalar, Signal, State};

use crate::bodies::impedance_increments;
use crate::{FromParts, Impedance, ImplicitMechanics, LinearDynamics};

/// A mass with a damper and a spring that rests at the origin: `ẍ = −(k x + b ẋ + f) / m`, alike on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator<T> {
    parts: Impedance<T>,
    by_position: T,
    by_velocity: T,
    by_effort: T,
}

impl<T: Scalar> Oscillator<T> {
    /// The oscillator made of `parts`.
    ///
    /// # Errors
    /// `mass` not above 0 and finite; `damping` or `stiffness` below 0, infinite or NaN; a mass so small beside the
    /// other values that an acceleration is out of the scalar's range.
    pub fn new(parts: Impedance<T>) -> Result<Self, ParameterError> {
        let Impedance { mass, damping, stiffness } = parts.checked()?;
        let per_mass = |value: T| -value / mass;
        let by_position = per_mass(stiffness);
        let by_velocity = per_mass(damping);
        let by_effort = per_mass(T::of(1.0));
        let largest = by_position + by_velocity + by_effort;
        Requirement::InRange.require("mass", mass, largest.finite())?;
        Ok(Self { parts, by_position, by_velocity, by_effort })
    }

    /// `yes` in the lanes of `mask`, `no` elsewhere.
    pub(super) fn chosen(mask: T::Mask, yes: Self, no: Self) -> Self {
        let choose = |yes: T, no: T| T::choose(mask, yes, no);
        Self {
            parts: Impedance {
                mass: choose(yes.parts.mass, no.parts.mass),
                damping: choose(yes.parts.damping, no.parts.damping),
                stiffness: choose(yes.parts.stiffness, no.parts.stiffness),
            },
            by_position: choose(yes.by_position, no.by_position),
            by_velocity: choose(yes.by_velocity, no.by_velocity),
            by_effort: choose(yes.by_effort, no.by_effort),
        }
    }

    /// The force on the mass at rest at `position`, N.
    #[inline]
    pub(super) fn force_at_rest(&self, position: T, effort: T) -> T {
        -(self.parts.stiffness * position) - effort
    }

    /// The decrease of an implicit step's acceleration per unit of effort, 1/kg.
    #[inline]
    pub(super) fn mobility(&self, alpha: T, beta: T) -> T {
        -self.by_effort / self.heavier(alpha, beta)
    }

    /// The factor by which the mass of an implicit step is larger than the mass itself.
    #[inline]
    fn heavier(&self, alpha: T, beta: T) -> T {
        T::of(1.0) - alpha * self.by_position - beta * self.by_velocity
    }
}

impl<T: Scalar> FromParts for Oscillator<T> {
    type Parts = Impedance<T>;

    fn made_of(&self, parts: Impedance<T>) -> Result<Self, ParameterError> {
        Self::new(parts)
    }
}

impl<V: Signal> Mechanics<V> for Oscillator<V::Scalar> {
    type Coordinates = V;

    #[inline]
    fn acceleration(&self, position: V, velocity: V, effort: V) -> V {
        position.scale(self.by_position)
            + velocity.scale(self.by_velocity)
            + effort.scale(self.by_effort)
    }
}

impl<V: Signal> ImplicitMechanics<V> for Oscillator<V::Scalar> {
    /// Acts as if the mass were `m + α k + β b`.
    #[inline]
    fn implicit_acceleration(
        &self,
        position: V,
        velocity: V,
        effort: V,
        alpha: V::Scalar,
        beta: V::Scalar,
    ) -> V {
        let share = V::Scalar::of(1.0) / self.heavier(alpha, beta);
        self.acceleration(position, velocity, effort).scale(share)
    }
}

impl<V: Signal> LinearDynamics<V> for Oscillator<V::Scalar> {
    type Increments = [[V::Scalar; 3]; 2];

    fn increments(&self, interval: V::Scalar) -> Self::Increments {
        impedance_increments(self.parts, interval)
    }

    #[inline]
    fn gain(increments: &Self::Increments, from: State<V>, effort: V) -> State<V> {
        let of = |row: [V::Scalar; 3]| {
            from.position.scale(row[0]) + from.velocity.scale(row[1]) + effort.scale(row[2])
        };
        State { position: of(increments[0]), velocity: of(increments[1]) }
    }
}
