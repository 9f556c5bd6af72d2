//! Two masses with a link.

use lyapunov_core::{Mechanics, ParameterError, Requirement, Scalar, Signal, State};

use crate::bodies::two_mass_increments;
use crate::{FromParts, ImplicitMechanics, LinearDynamics, TwoMassCoordinates, TwoMassParts};

/// An operator and a device joined by a link, the operator on a spring that rests at the origin, in the coordinates
/// `x_d` and `s = x_o − x_d`, alike on each axis:
///
/// ```text
/// m_o ẍ_o = −k_h x_o − b_o ẋ_o − (k_l s + b_l ṡ)
/// m_d ẍ_d = −b_d ẋ_d − f + (k_l s + b_l ṡ)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoupledOscillators<T> {
    parts: TwoMassParts<T>,
    per_operator: T,
    per_device: T,
}

impl<T: Scalar> CoupledOscillators<T> {
    /// The two oscillators made of `parts`.
    ///
    /// # Errors
    /// A mass or the link's stiffness not above 0 and finite; a damping or the operator's stiffness below 0, infinite
    /// or NaN; a mass so small beside the other values that an acceleration is out of the scalar's range.
    pub fn new(parts: TwoMassParts<T>) -> Result<Self, ParameterError> {
        let parts = parts.checked()?;
        let TwoMassParts { operator, device, link } = parts;
        let one = T::of(1.0);
        let held = one + operator.stiffness + operator.damping + link.stiffness + link.damping;
        let led = one + device.damping + link.stiffness + link.damping;
        let (held, led) = (held / operator.mass, led / device.mass);
        Requirement::InRange.require("operator mass", operator.mass, held.finite())?;
        Requirement::InRange.require("device mass", device.mass, led.finite())?;
        Ok(Self { parts, per_operator: one / operator.mass, per_device: one / device.mass })
    }

    /// The forces on operator and device from outside the link, and the force of the link, which pulls them together.
    #[inline]
    fn forces<V>(
        &self,
        position: TwoMassCoordinates<V>,
        velocity: TwoMassCoordinates<V>,
        effort: V,
    ) -> [V; 3]
    where
        V: Signal<Scalar = T>,
    {
        let TwoMassParts { operator, device, link } = self.parts;
        let place = position.device + position.stretch;
        let rate = velocity.device + velocity.stretch;
        let on_operator = place.scale(-operator.stiffness) - rate.scale(operator.damping);
        let on_device = velocity.device.scale(-device.damping) - effort;
        let pull = position.stretch.scale(link.stiffness) + velocity.stretch.scale(link.damping);
        [on_operator, on_device, pull]
    }
}

impl<T: Scalar> FromParts for CoupledOscillators<T> {
    type Parts = TwoMassParts<T>;

    fn made_of(&self, parts: TwoMassParts<T>) -> Result<Self, ParameterError> {
        Self::new(parts)
    }
}

impl<V: Signal> Mechanics<V> for CoupledOscillators<V::Scalar> {
    type Coordinates = TwoMassCoordinates<V>;

    #[inline]
    fn acceleration(
        &self,
        position: TwoMassCoordinates<V>,
        velocity: TwoMassCoordinates<V>,
        effort: V,
    ) -> TwoMassCoordinates<V> {
        let [on_operator, on_device, pull] = self.forces(position, velocity, effort);
        let operator = (on_operator - pull).scale(self.per_operator);
        let device = (on_device + pull).scale(self.per_device);
        TwoMassCoordinates { device, stretch: operator - device }
    }
}

impl<V: Signal> ImplicitMechanics<V> for CoupledOscillators<V::Scalar> {
    /// Acts as if each mass `m` were heavier, by `α k + β b` of its own spring and damper, and the reduced mass of the
    /// two, which carries the stretch, heavier still by the link's. Every divisor is a sum of non-negative terms.
    #[inline]
    fn implicit_acceleration(
        &self,
        position: TwoMassCoordinates<V>,
        velocity: TwoMassCoordinates<V>,
        effort: V,
        alpha: V::Scalar,
        beta: V::Scalar,
    ) -> TwoMassCoordinates<V> {
        let TwoMassParts { operator, device, link } = self.parts;
        let [on_operator, on_device, pull] = self.forces(position, velocity, effort);
        let held = operator.mass + alpha * operator.stiffness + beta * operator.damping;
        let led = device.mass + beta * device.damping;
        let joint = alpha * link.stiffness + beta * link.damping;
        let (share_held, share_led) = (held / (held + led), led / (held + led));
        // The shares keep every product of two masses in the scalar's range.
        let reduced = held * share_led;
        let outside = on_operator + on_device;
        let stretch = (on_operator.scale(share_led) - on_device.scale(share_held) - pull)
            .scale(V::Scalar::of(1.0) / (reduced + joint));
        let device = outside.scale(V::Scalar::of(1.0) / (held + led)) - stretch.scale(share_held);
        TwoMassCoordinates { device, stretch }
    }
}

impl<V: Signal> LinearDynamics<V> for CoupledOscillators<V::Scalar> {
    type Increments = [[V::Scalar; 5]; 4];

    fn increments(&self, interval: V::Scalar) -> Self::Increments {
        two_mass_increments(self.parts, interval)
    }

    #[inline]
    fn gain(
        increments: &Self::Increments,
        from: State<TwoMassCoordinates<V>>,
        effort: V,
    ) -> State<TwoMassCoordinates<V>> {
        let of = |row: [V::Scalar; 5]| {
            from.position.device.scale(row[0])
                + from.position.stretch.scale(row[1])
                + from.velocity.device.scale(row[2])
                + from.velocity.stretch.scale(row[3])
                + effort.scale(row[4])
        };
        let [device, stretch, velocity, stretching] = increments.map(of);
        State {
            position: TwoMassCoordinates { device, stretch },
            velocity: TwoMassCoordinates { device: velocity, stretch: stretching },
        }
    }
}
