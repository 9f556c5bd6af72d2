//! The plants of model files.

use lyapunov as library;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::files::scene::{Finite, NonNegative, Positive, two};

/// A control-affine plant, with what its V needs beside the plant's own numbers and the controller's springs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Plant {
    /// The Van der Pol oscillator, with V = (x² + ẋ²) / 2.
    VanDerPol(VanDerPol),
    /// A pendulum held upright, with its energy and that of the controller's spring.
    InvertedPendulum(InvertedPendulum),
    /// A DC motor, with the energy of a spring wanted on its shaft.
    DcMotor(DcMotor),
    /// A device that measures a force and moves, with the energy of the hand's spring and of the mass that it renders.
    AdmittanceDevice(AdmittanceDevice),
    /// An arm of two links, with its energy and that of the controller's springs.
    TwoLinkArm(TwoLinkArm),
    /// A leg on a test stand, with its energy and that of ground and controller's springs.
    ProstheticLeg(ProstheticLeg),
}

/// The Van der Pol oscillator.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VanDerPol {
    /// Its parameter, 0 or more, without a unit; required.
    pub mu: NonNegative,
}

/// A pendulum on a motor, held upright by the controller's spring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InvertedPendulum {
    /// Point mass in kg, greater than 0; required.
    pub mass: Positive,
    /// Length in m, greater than 0; required.
    pub length: Positive,
    /// Friction of the joint in N.m.s/rad, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
}

/// A DC motor under a voltage, and the spring and the damper that its V wants on the shaft.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DcMotor {
    /// Inertia of the rotor and what it turns in kg.m², greater than 0; required.
    pub inertia: Positive,
    /// Viscous friction in N.m.s/rad, 0 or more; default 0.
    #[serde(default)]
    pub friction: NonNegative,
    /// Torque constant in N.m/A, greater than 0; required.
    pub torque_constant: Positive,
    /// Resistance of the winding in Ω, greater than 0; required.
    pub resistance: Positive,
    /// Inductance of the winding in H, greater than 0; required.
    pub inductance: Positive,
    /// Stiffness that V wants on the shaft in N.m/rad, greater than 0; required.
    pub wanted_stiffness: Positive,
    /// Damping that V wants on the shaft in N.m.s/rad, 0 or more; default 0.
    #[serde(default)]
    pub wanted_damping: NonNegative,
}

/// A device that measures the force of a hand's spring and moves as it is told, and the mass that its V wants rendered.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AdmittanceDevice {
    /// Stiffness of the hand in N/m, greater than 0; required.
    pub hand_stiffness: Positive,
    /// Mass that V wants felt in kg, greater than 0: -1 over the controller's derivative; required.
    pub wanted_mass: Positive,
}

/// An arm of two links that hangs, its joints held by the controller's springs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TwoLinkArm {
    /// The link at the shoulder; required.
    pub upper: Limb,
    /// The link at the elbow; required.
    pub lower: Limb,
}

/// A leg on a test stand, held in a posture by the controller's springs and the torques that gravity asks for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProstheticLeg {
    /// Angles of hip and knee in rad at which the foot just touches; required.
    #[serde(deserialize_with = "two")]
    pub posture: [Finite; 2],
    /// The limb at the hip; required.
    pub thigh: Limb,
    /// The limb at the knee; required.
    pub shank: Limb,
    /// What the foot stands on; required.
    pub ground: Ground,
}

/// A limb: a uniform rod, but for what is given otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limb {
    /// Mass in kg, greater than 0; required.
    pub mass: Positive,
    /// From joint to joint, or to the tip, in m, greater than 0; required.
    pub length: Positive,
    /// From the joint to the centre of mass in m, greater than 0; default: half the length.
    pub centre: Option<Positive>,
    /// About the centre of mass in kg.m², 0 or more; default: mass length² / 12.
    pub inertia: Option<NonNegative>,
}

/// What a foot stands on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Stiffness in N/m, 0 or more; required.
    pub stiffness: NonNegative,
    /// Damping of the penetration's rate in s/m, 0 or more; default 0.
    #[serde(default)]
    pub damping: NonNegative,
    /// Drag of sliding, as a share of the load per m/s, in s/m, 0 or more; default 0.
    #[serde(default)]
    pub drag: NonNegative,
}

impl Plant {
    /// The name in a model file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::VanDerPol(_) => "van-der-pol",
            Self::InvertedPendulum(_) => "inverted-pendulum",
            Self::DcMotor(_) => "dc-motor",
            Self::AdmittanceDevice(_) => "admittance-device",
            Self::TwoLinkArm(_) => "two-link-arm",
            Self::ProstheticLeg(_) => "prosthetic-leg",
        }
    }

    /// The states in the order of `initial`, with their units.
    pub fn states(&self) -> &'static [&'static str] {
        match self {
            Self::VanDerPol(_) => &["x", "rate of x"],
            Self::InvertedPendulum(_) => &["angle in rad", "rate in rad/s"],
            Self::DcMotor(_) => &["angle in rad", "rate in rad/s", "current in A"],
            Self::AdmittanceDevice(_) => &["place in m", "impulse of the hand in N.s"],
            Self::TwoLinkArm(_) => {
                &["shoulder in rad", "elbow in rad", "rate of shoulder in rad/s", "of elbow"]
            }
            Self::ProstheticLeg(_) => {
                &["hip in rad", "knee in rad", "rate of hip in rad/s", "of knee"]
            }
        }
    }

    /// The number of inputs, each with its own gain.
    pub fn inputs(&self) -> usize {
        match self {
            Self::VanDerPol(_)
            | Self::InvertedPendulum(_)
            | Self::DcMotor(_)
            | Self::AdmittanceDevice(_) => 1,
            Self::TwoLinkArm(_) | Self::ProstheticLeg(_) => 2,
        }
    }

    /// The unit of V; empty if V has none.
    pub fn unit_of_value(&self) -> &'static str {
        if let Self::VanDerPol(_) = self { "" } else { "J" }
    }

    /// The unit of the inputs; empty if they have none.
    pub fn unit_of_input(&self) -> &'static str {
        match self {
            Self::VanDerPol(_) => "",
            Self::DcMotor(_) => "V",
            Self::AdmittanceDevice(_) => "m/s",
            Self::InvertedPendulum(_) | Self::TwoLinkArm(_) | Self::ProstheticLeg(_) => "N.m",
        }
    }
}

impl Limb {
    /// The library's link for this limb, in the scalar of a loop.
    pub(crate) fn limb<T: library::Scalar>(&self) -> library::models::RigidLink<T> {
        let rod = library::models::RigidLink::rod(T::of(self.mass.get()), T::of(self.length.get()));
        library::models::RigidLink {
            centre: self.centre.map_or(rod.centre, |it| T::of(it.get())),
            inertia: self.inertia.map_or(rod.inertia, |it| T::of(it.get())),
            ..rod
        }
    }
}
