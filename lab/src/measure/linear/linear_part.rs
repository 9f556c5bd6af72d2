//! Linear part of a scene.

use std::f64::consts::TAU;
use std::fmt;

use lyapunov::bodies::{DampedMass, ElasticJoint, Impedance};

use crate::files::scene::{Effects, Filter, Integrator, Scalar, Scene, Velocity};
use crate::text::given;

/// The linear part of a scene, contact assumed: the stiffness limits are about it.
///
/// Rows count servo ticks of `T`. The environment is evaluated at every `ratio`-th of them, and its answer,
///
/// ```text
/// f = K x + B v̂ + M (v̂(m) − v̂(m−1)) / (ratio T),
/// ```
///
/// acts from `delay` ticks later until the next answer does. `v̂` is the backward difference of the servo's samples
/// behind its low pass, or the plant's own velocity.
///
/// Left out are rests, loads and pulses, which move the point that the loop swings about; the encoder, noise, friction
/// and saturation; a stabilizer; jitter (the period is the nominal one) and changes of grip (it is the one at the
/// start). A one-sided wall pulls as well. A layered wall counts by its first layer, a varying spring by its mean, a
/// cubic spring at rest, a plane, a sphere or a box by the motion along the normal, a wall after Hunt and Crossley with
/// exponent 1 at the surface, where its damper does not act yet. Everything is in `f64`, even where a scene says `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearPart {
    /// Servo period `T`, s.
    pub period: f64,
    /// Servo ticks from one answer of the environment to the next, 1 or more.
    pub ratio: u64,
    /// Servo ticks from an answer to its correction.
    pub delay: u64,
    /// The source of the velocity.
    pub velocity: VelocitySource,
    /// The mass that the effort acts on.
    pub device: DampedMass<f64>,
    /// The hand.
    pub operator: Impedance<f64>,
    /// The joint between the two; none where they move as one.
    pub link: Option<ElasticJoint<f64>>,
    /// `M`, `B` and `K`.
    pub environment: Impedance<f64>,
}

/// Source of a velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VelocitySource {
    /// The plant's own velocity.
    Exact,
    /// `v̂(n) = v̂(n−1) + share (Δx(n) / T − v̂(n−1))`; a share of 1 is the backward difference.
    Difference {
        /// The share, from 0, excluded, to 1.
        share: f64,
    },
}

/// Reason why a scene has no linear part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotLinear {
    /// The environment's force grows with a power of the depth other than the first.
    Exponent,
    /// The velocity is estimated over a window whose length depends on the motion.
    Window,
    /// Answers are lost at random.
    Dropout,
}

impl fmt::Display for NotLinear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Exponent => {
                "a hunt-crossley wall has a stiffness of its own only with exponent 1"
            }
            Self::Window => {
                "an adaptive window is no linear filter, and the environment uses the velocity"
            }
            Self::Dropout => {
                "a loop that loses answers by chance is not the same from tick to tick"
            }
        })
    }
}

impl LinearPart {
    /// The linear part of `scene`.
    ///
    /// # Errors
    /// A scene that has none.
    pub fn of(scene: &Scene) -> Result<Self, NotLinear> {
        let environment = scene.environment.kind().impedance().ok_or(NotLinear::Exponent)?;
        if scene.effects.dropout.is_some_and(|dropout| dropout.probability.get() > 0.0) {
            return Err(NotLinear::Dropout);
        }
        let period = scene.period();
        let moves = environment.damping != 0.0 || environment.mass != 0.0;
        let velocity = match (scene.velocity, scene.effects.filter) {
            (Velocity::Exact, _) => VelocitySource::Exact,
            (_, None) => VelocitySource::Difference { share: 1.0 },
            (_, Some(Filter::Cutoff(cutoff))) => {
                let turn = TAU * cutoff.get() * period;
                VelocitySource::Difference { share: turn / (1.0 + turn) }
            }
            // A window of one tick is the backward difference.
            (_, Some(Filter::Window(ticks))) if moves && ticks.get() > 1 => {
                return Err(NotLinear::Window);
            }
            (_, Some(Filter::Window(_))) => VelocitySource::Difference { share: 1.0 },
        };
        let operator = &scene.operator;
        Ok(Self {
            period,
            ratio: scene.environment_ratio(),
            delay: scene.delay_ticks().into(),
            velocity,
            device: DampedMass {
                mass: scene.device.mass.get(),
                damping: scene.device.damping.get(),
            },
            operator: Impedance {
                mass: operator.mass.get(),
                damping: operator.damping.get(),
                stiffness: operator.stiffness.get(),
            },
            link: scene.link.map(|link| ElasticJoint {
                stiffness: link.stiffness.get(),
                damping: link.damping.get(),
            }),
            environment,
        })
    }

    /// The place, in words, and the spectral radius of the worst of what this part of `scene` leaves out: the environment
    /// where it is steepest, and each later grip. None where all of it is stable.
    pub(crate) fn unstable_elsewhere(self, scene: &Scene) -> Option<(String, f64)> {
        // A program without every scalar, the page, has no room for it.
        if !cfg!(feature = "every-scalar") {
            return None;
        }
        let steepest = scene.environment.kind().steepest().unwrap_or(self.environment);
        let grip = scene.operator.grip.as_ref();
        let (mut worst, mut place) = (1.0, None);
        for row in 0..=grip.map_or(0, |grip| grip.times.len()) {
            let mut part = self;
            if let (Some(grip), Some(row)) = (grip, row.checked_sub(1)) {
                part.operator.stiffness = grip.stiffness[row].get();
                part.operator.damping = grip.damping[row].get();
            }
            for environment in [self.environment, steepest] {
                part.environment = environment;
                let radius = part.spectral_radius();
                if radius > worst {
                    (worst, place) = (radius, Some((environment, row)));
                }
            }
        }
        let (environment, row) = place?;
        let own = environment == self.environment;
        let mut words = if own { "" } else { " where the environment is steepest" }.to_owned();
        if let (Some(grip), Some(row)) = (grip, row.checked_sub(1)) {
            words += &format!(" with the grip from {} s on", given(grip.times[row].get()));
        }
        Some((words, worst))
    }

    /// Whether the run of `scene` is that of this part but for rounding, since the scene has nothing that the part leaves out.
    pub(crate) fn is_all_of(&self, scene: &Scene) -> bool {
        let Effects { encoder, saturation, noise, jitter, friction, load, pulse, .. } =
            &scene.effects;
        let sees = encoder.is_none() && noise.is_none() && jitter.is_none();
        let moves = saturation.is_none() && friction.is_none() && load.is_none();
        let hand = scene.operator.motion.is_none() && scene.operator.grip.is_none();
        let (environment, kind) = (&scene.environment, scene.environment.kind());
        let touches = environment.surface_stiffness().is_none() && kind.impedance_note().is_none();
        // An integrator may be unstable where the motion is not, and `f32` holds less.
        let is_exact = scene.integrator == Integrator::Exact && scene.scalar == Scalar::F64;
        is_exact
            && sees
            && moves
            && pulse.is_none()
            && hand
            && touches
            && scene.stabilizer.is_none()
    }

    /// Whether the environment needs the velocity.
    pub(super) fn needs_velocity(&self) -> bool {
        self.environment.damping != 0.0 || self.environment.mass != 0.0
    }

    /// The environment's period, s.
    pub fn environment_period(&self) -> f64 {
        self.period * self.ratio as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(hand: &str, environment: &str) -> (LinearPart, Scene) {
        let text = format!(
            "duration = 6\nservo_rate = 1000\ndevice = {{ mass = 0.2, damping = 0.1 }}\neffects.delay.ticks = 1\n\
             operator = {{ mass = 0.1, {hand} }}\nenvironment.{environment}"
        );
        let scene = Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        (LinearPart::of(&scene).unwrap(), scene)
    }

    /// A layer and a later grip are told with the radius of a scene that has nothing else.
    #[test]
    fn a_steeper_layer_and_a_later_grip_are_told() {
        let hand = "damping = 12, stiffness = 300, rest = 0.02";
        let layers = "layered-wall = { depth = 1e-3, stiffness = [300, 20000], damping = 1 }";
        let (own, scene) = part(hand, layers);
        let (alone, _) = part(hand, "wall = { stiffness = 20000, damping = 1 }");
        let place = " where the environment is steepest".to_owned();
        assert!(own.spectral_radius() < 1.0 && alone.spectral_radius() > 1.0);
        assert_eq!(own.unstable_elsewhere(&scene), Some((place, alone.spectral_radius())));

        let wall = "wall = { stiffness = 4000, damping = 1 }";
        let grip = "grip = { times = [1.5], stiffness = [200], damping = [0.2] }";
        let (own, scene) = part(&format!("{hand}, {grip}"), wall);
        let (alone, _) = part("damping = 0.2, stiffness = 200, rest = 0.02", wall);
        let place = " with the grip from 1.5 s on".to_owned();
        assert!(own.spectral_radius() < 1.0 && alone.spectral_radius() > 1.0);
        assert_eq!(own.unstable_elsewhere(&scene), Some((place, alone.spectral_radius())));

        let (own, scene) = part(hand, wall);
        assert_eq!(own.unstable_elsewhere(&scene), None);
    }
}
