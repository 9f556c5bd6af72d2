//! A stabilizer that is chosen at run time.

use std::fmt;

use lyapunov::{
    Action, DampingLimit, Dissipation, Drive, Lolc, LyapunovCandidate, OnePort, ParameterError,
    PortEnergy, Signal, Stabilizer,
};

use super::assembly::measured;
use super::environment::{Render, of};
use super::{Port, Space};
use crate::scene::{self, Candidate, Scene, Work};

/// Any stabilizer, boxed: what a scene file names, or one of one's own.
pub struct AnyStabilizer<V: Signal>(Box<dyn Replay<V>>);

impl<V: Signal> AnyStabilizer<V> {
    /// Bytes that the stabilizer keeps from tick to tick, parameters included.
    pub fn state_bytes(&self) -> usize {
        size_of_val(self.0.as_ref())
    }

    /// `port` watched and corrected by this stabilizer, and told of the motion as `scene` measures it: one part, compiled
    /// for its type, instead of a box in a box.
    pub(super) fn on(self, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError> {
        self.0.on(port, scene)
    }

    /// Takes the stabilizer through `samples`, one after the other, without a call through a table for each.
    pub(crate) fn replay(&mut self, samples: &[(Drive<V>, V)], actions: &mut [Action<V>]) {
        self.0.replay(samples, actions);
    }
}

impl<V: Space> AnyStabilizer<V> {
    /// Boxes `stabilizer`.
    pub fn new(stabilizer: impl Stabilizer<V> + 'static) -> Self {
        Self(Box::new(stabilizer))
    }

    /// The stabilizer that `scene` names, if it names one.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or together with others.
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
                let damper = Dissipation::of(of(scene.device.damping))?;
                Self::watching(scene, (PortEnergy, damper), work, cap)
            }
            Candidate::MassSpringDamper => V::render(scene, Crediting { scene, work, cap }),
        }
    }

    fn watching(
        scene: &Scene,
        candidate: impl LyapunovCandidate<V> + 'static,
        work: Work,
        cap: f64,
    ) -> Result<Self, ParameterError> {
        let limit = DampingLimit::of_mass(of(cap), of(scene.mass()), of(scene.period()))?;
        let lolc = Lolc::new(candidate, limit);
        Ok(match work {
            Work::Held => Self::new(lolc),
            Work::Sampled => Self::new(lolc.sampled()),
        })
    }
}

impl<V: Signal> fmt::Debug for AnyStabilizer<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyStabilizer").finish_non_exhaustive()
    }
}

impl<V: Signal> Stabilizer<V> for AnyStabilizer<V> {
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V> {
        self.0.stabilize(drive, effort)
    }
}

/// LOLC with the credit of the scene's own environment.
struct Crediting<'a> {
    scene: &'a Scene,
    work: Work,
    cap: f64,
}

impl<V: Space> Render<V> for Crediting<'_> {
    type Made = AnyStabilizer<V>;

    fn render(
        self,
        _environment: impl OnePort<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError> {
        AnyStabilizer::watching(self.scene, (PortEnergy, credit), self.work, self.cap)
    }
}

/// A stabilizer with a loop or a port of its own around it, compiled for its type.
trait Replay<V: Signal>: Stabilizer<V> {
    fn on(self: Box<Self>, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError>;

    fn replay(&mut self, samples: &[(Drive<V>, V)], actions: &mut [Action<V>]);
}

impl<V: Space, S: Stabilizer<V> + 'static> Replay<V> for S {
    fn on(self: Box<Self>, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError> {
        measured(scene, port.stabilized(*self))
    }

    #[inline(never)]
    fn replay(&mut self, samples: &[(Drive<V>, V)], actions: &mut [Action<V>]) {
        for ((drive, effort), action) in samples.iter().zip(actions) {
            *action = self.stabilize(drive, *effort);
        }
    }
}
