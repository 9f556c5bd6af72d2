//! A stabilizer that is chosen at run time.

use std::fmt;

use lyapunov::{
    Action, DampingLimit, Dissipation, Drive, Lolc, LyapunovCandidate, ParameterError, PortEnergy,
    Scalar, Stabilizer, Wall,
};

use crate::scene::{self, Candidate, Environment, Scene, Work};

/// Any stabilizer, boxed: what a scene file names, or one of one's own.
pub struct AnyStabilizer<T: Scalar>(Box<dyn Replay<T>>);

impl<T: Scalar> AnyStabilizer<T> {
    /// Boxes `stabilizer`.
    pub fn new(stabilizer: impl Stabilizer<T> + 'static) -> Self {
        Self(Box::new(stabilizer))
    }

    /// The stabilizer that `scene` names, if it names one.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of `T`, alone or together with others.
    pub fn of(scene: &Scene) -> Result<Option<Self>, ParameterError> {
        Ok(match scene.stabilizer {
            None => None,
            Some(named) => Some(Self::named(scene, named)?),
        })
    }

    /// The stabilizer `named` on the loop of `scene`, whatever the scene itself names.
    ///
    /// # Errors
    /// As [`AnyStabilizer::of`].
    pub fn named(scene: &Scene, named: scene::Stabilizer) -> Result<Self, ParameterError> {
        let lolc = match named {
            scene::Stabilizer::Popc(popc) => {
                return Self::watching(scene, PortEnergy, popc.work, popc.damping_cap.get());
            }
            scene::Stabilizer::Lolc(lolc) => lolc,
        };
        let (work, cap) = (lolc.work, lolc.damping_cap.get());
        match lolc.candidate {
            Candidate::Spring => Self::watching(scene, PortEnergy, work, cap),
            Candidate::DeviceDamping => {
                let damper = Dissipation::of(T::of(scene.device.damping.get()))?;
                Self::watching(scene, (PortEnergy, damper), work, cap)
            }
            Candidate::MassSpringDamper => {
                let Environment::Wall(parameters) = scene.environment;
                let credit = wall::<T>(parameters)?.dissipation();
                Self::watching(scene, (PortEnergy, credit), work, cap)
            }
        }
    }

    fn watching(
        scene: &Scene,
        candidate: impl LyapunovCandidate<T> + 'static,
        work: Work,
        cap: f64,
    ) -> Result<Self, ParameterError> {
        let mass = scene.operator.mass.get() + scene.device.mass.get();
        let limit = DampingLimit::of_mass(T::of(cap), T::of(mass), T::of(scene.period()))?;
        let lolc = Lolc::new(candidate, limit);
        Ok(match work {
            Work::Held => Self::new(lolc),
            Work::Sampled => Self::new(lolc.sampled()),
        })
    }

    /// Bytes that the stabilizer keeps from tick to tick, parameters included.
    pub fn state_bytes(&self) -> usize {
        size_of_val(self.0.as_ref())
    }

    /// Takes the stabilizer through `samples`, one after the other, without a call through a table for each.
    pub(crate) fn replay(&mut self, samples: &[(Drive<T>, T)], actions: &mut [Action<T>]) {
        self.0.replay(samples, actions);
    }
}

impl<T: Scalar> fmt::Debug for AnyStabilizer<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyStabilizer").finish_non_exhaustive()
    }
}

impl<T: Scalar> Stabilizer<T> for AnyStabilizer<T> {
    fn stabilize(&mut self, drive: &Drive<T>, effort: T) -> Action<T> {
        self.0.stabilize(drive, effort)
    }
}

/// A stabilizer with a loop of its own around it, compiled for its type.
trait Replay<T: Scalar>: Stabilizer<T> {
    fn replay(&mut self, samples: &[(Drive<T>, T)], actions: &mut [Action<T>]);
}

impl<T: Scalar, S: Stabilizer<T>> Replay<T> for S {
    #[inline(never)]
    fn replay(&mut self, samples: &[(Drive<T>, T)], actions: &mut [Action<T>]) {
        for ((drive, effort), action) in samples.iter().zip(actions) {
            *action = self.stabilize(drive, *effort);
        }
    }
}

/// The wall of a scene.
pub(crate) fn wall<T: Scalar>(wall: scene::Wall) -> Result<Wall<T>, ParameterError> {
    let surface = T::of(wall.position.get());
    Ok(Wall::new(T::of(wall.stiffness.get()), T::of(wall.damping.get()))?.at(surface))
}
