//! Parts of two masses and the link between them.

use lyapunov_core::{ParameterError, Requirement, Scalar};

use crate::Impedance;

/// An operator and a device, joined by an elastic link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoMassParts<T> {
    /// The operator; its stiffness ties it to its rest.
    pub operator: Impedance<T>,
    /// The device, which the operator holds.
    pub device: DampedMass<T>,
    /// The link between the two.
    pub link: ElasticJoint<T>,
}

/// A mass on a damper to the ground, without a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedMass<T> {
    /// Mass, kg.
    pub mass: T,
    /// Damping, N·s/m.
    pub damping: T,
}

/// A spring and a damper side by side between two masses (Kelvin and Voigt's element).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticJoint<T> {
    /// Stiffness, N/m.
    pub stiffness: T,
    /// Damping, N·s/m.
    pub damping: T,
}

impl<T: Scalar> TwoMassParts<T> {
    /// `number` of each part.
    #[inline(always)]
    pub(crate) fn map<R>(self, number: impl Fn(T) -> R) -> TwoMassParts<R> {
        let Self { operator, device, link } = self;
        let device = DampedMass { mass: number(device.mass), damping: number(device.damping) };
        let link =
            ElasticJoint { stiffness: number(link.stiffness), damping: number(link.damping) };
        TwoMassParts { operator: operator.map(&number), device, link }
    }

    pub(crate) fn checked(self) -> Result<Self, ParameterError> {
        let Self { operator, device, link } = self;
        Requirement::Positive.check("operator mass", operator.mass)?;
        Requirement::NonNegative.check("operator damping", operator.damping)?;
        Requirement::NonNegative.check("operator stiffness", operator.stiffness)?;
        Requirement::Positive.check("device mass", device.mass)?;
        Requirement::NonNegative.check("device damping", device.damping)?;
        Requirement::Positive.check("link stiffness", link.stiffness)?;
        Requirement::NonNegative.check("link damping", link.damping)?;
        Ok(self)
    }
}
