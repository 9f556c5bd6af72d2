//! What an environment stores.

use lyapunov::Scalar;

use crate::scene::{Environment, Scene};

/// The energy that the spring and the mass of an ideal environment hold, as a function of position and velocity; 0 for one
/// that is not a function of these, which swings by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Reference {
    /// Nothing.
    None,
    /// A spring that pushes on both sides, and a mass: N/m, kg.
    Oscillator { position: f64, stiffness: f64, mass: f64 },
    /// A wall of two layers: the depth of the first, m, and N/m.
    Layers { position: f64, depth: f64, stiffness: [f64; 2] },
    /// A contact whose force is a power of the depth: N/mᵉ.
    Power { position: f64, stiffness: f64, exponent: f64 },
}

impl Reference {
    pub(super) fn of(scene: &Scene) -> Self {
        match &scene.environment {
            Environment::Wall(it) => Self::Layers {
                position: it.position.get(),
                depth: f64::INFINITY,
                stiffness: [it.stiffness.get(); 2],
            },
            Environment::LayeredWall(it) => Self::Layers {
                position: it.position.get(),
                depth: it.depth.get(),
                stiffness: it.stiffness.map(|layer| layer.get()),
            },
            Environment::Spring(it) => Self::Oscillator {
                position: it.position.get(),
                stiffness: it.stiffness.get(),
                mass: 0.0,
            },
            Environment::MassSpringDamper(it) => Self::Oscillator {
                position: it.position.get(),
                stiffness: it.stiffness.get(),
                mass: it.mass.get(),
            },
            Environment::HuntCrossley(it) => Self::Power {
                position: it.position.get(),
                stiffness: it.stiffness.get(),
                exponent: it.exponent.get(),
            },
            _ => Self::None,
        }
    }

    /// `S(x, v)`, J.
    pub(crate) fn stored<T: Scalar>(&self, x: T, v: T) -> T {
        let (zero, half) = (T::zero(), T::of(0.5));
        let depth = |position: f64| (x - T::of(position)).larger(zero);
        match *self {
            Self::None => zero,
            Self::Oscillator { position, stiffness, mass } => {
                let away = x - T::of(position);
                half * (T::of(stiffness) * away * away + T::of(mass) * v * v)
            }
            Self::Layers { position, depth: layer, stiffness: [outer, inner] } => {
                let (depth, outer) = (depth(position), T::of(outer));
                let soft = depth.smaller(T::of(layer));
                let hard = depth - soft;
                half * outer * soft * soft + outer * soft * hard + half * T::of(inner) * hard * hard
            }
            Self::Power { position, stiffness, exponent } => {
                let depth = depth(position);
                let power = |lane| libm::pow(depth.lane(lane), exponent + 1.0);
                T::of(stiffness / (exponent + 1.0)) * T::from_lanes(power)
            }
        }
    }
}
