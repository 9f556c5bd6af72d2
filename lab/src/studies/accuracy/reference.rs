//! References that errors are measured against.

use lyapunov::{ParameterError, Scalar, accumulators::DoubleDouble};

use super::AccuracyError;
use super::extrapolation::Extrapolation;
use super::trace::{Progress, trace};
use crate::files::scene::{Conflict, Draft, Integrator, Positive, Scene};
use crate::simulate::Assembly;

/// The factor by which an error must exceed the distance of the two references to be known.
pub(super) const SURE: f64 = 100.0;

/// The second reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Second {
    /// Extrapolation, in double-double like the first.
    Extrapolation,
    /// An adaptive method with located switches: friction's exact trajectory is computed in `f64` whatever the scalar.
    Adaptive,
    /// The exact map in `f64`: part of the scene is computed in `f64` whatever the scalar.
    Double,
}

/// Two computations of one scene by different methods.
#[derive(Debug)]
pub(super) struct References {
    /// The exact map in double-double: position and velocity at every tick.
    pub(super) first: Vec<[DoubleDouble; 2]>,
    pub(super) second: Second,
    /// The distance of the second from the first at every tick, m.
    distances: Vec<f64>,
}

impl References {
    pub(super) fn of(
        scene: &Scene,
        ticks: usize,
        progress: Progress<'_>,
    ) -> Result<Self, AccuracyError> {
        let scene = exact(scene)?;
        let second = Second::on(&scene);
        // The second takes longer, so it alone tells of progress.
        let still = progress.part(0.0, 0.0);
        let (first, other) = rayon::join(
            || trace::<DoubleDouble>(Assembly::of(&scene)?, ticks, still),
            || second.trace(&scene, ticks, progress),
        );
        let (first, other) = (first?, other?);
        let apart = |(one, other): (&[DoubleDouble; 2], &[DoubleDouble; 2])| off(one[0], other[0]);
        let distances: Vec<f64> = first.iter().zip(&other).map(apart).collect();
        let first = first[..distances.len()].to_vec();
        let mut references = Self { first, second, distances };
        if second != Second::Extrapolation {
            // The part that both share is computed to this, so they may agree better than they are accurate.
            let least = f64::EPSILON * references.reach();
            references.distances.iter_mut().for_each(|apart| *apart = apart.max(least));
        }
        Ok(references)
    }

    /// The largest distance of the second reference within `ticks`, m.
    pub(super) fn distance(&self, ticks: usize) -> f64 {
        self.distances[..ticks.min(self.distances.len())].iter().copied().fold(0.0, f64::max)
    }

    /// The ticks over which the references stay within `distance` m of each other.
    pub(super) fn agree_within(&self, distance: f64) -> usize {
        let parted = self.distances.iter().position(|&apart| apart > distance);
        parted.unwrap_or(self.distances.len())
    }

    /// The largest distance of the motion from its start, m.
    pub(super) fn reach(&self) -> f64 {
        let start = self.first.first().map_or(DoubleDouble::of(0.0), |state| state[0]);
        self.first.iter().map(|state| off(state[0], start)).fold(0.0, f64::max)
    }
}

impl Second {
    /// The second reference for `scene`. Friction's trajectory and some environments' forces are computed in `f64`,
    /// whatever the loop computes in.
    fn on(scene: &Scene) -> Self {
        let in_double = scene.environment.kind().is_double();
        match (scene.effects.friction.is_some(), in_double) {
            (false, false) => Self::Extrapolation,
            (true, false) if scene.link.is_none() => Self::Adaptive,
            _ => Self::Double,
        }
    }

    /// The motion of `scene` by this reference.
    fn trace(
        self,
        scene: &Scene,
        ticks: usize,
        progress: Progress<'_>,
    ) -> Result<Vec<[DoubleDouble; 2]>, AccuracyError> {
        match self {
            Self::Extrapolation => {
                trace::<DoubleDouble>(Assembly::moved_by(scene, Extrapolation)?, ticks, progress)
            }
            Self::Adaptive => {
                let scene = Draft { integrator: adaptive(), ..scene.to_draft() }.check()?;
                trace::<DoubleDouble>(Assembly::of(&scene)?, ticks, progress)
            }
            Self::Double => {
                let run = trace::<f64>(Assembly::of(scene)?, ticks, progress)?;
                Ok(run.into_iter().map(|state| state.map(DoubleDouble::of)).collect())
            }
        }
    }
}

/// The integrator that follows friction by another method.
fn adaptive() -> Integrator {
    Positive::new(1e-13).map_or(Integrator::Exact, |tolerance| Integrator::Dop853 { tolerance })
}

/// The magnitude of a difference, m.
pub(super) fn off(one: DoubleDouble, other: DoubleDouble) -> f64 {
    (one - other).magnitude().high()
}

/// `scene` with exact motion.
pub(super) fn exact(scene: &Scene) -> Result<Scene, Conflict> {
    Draft { integrator: Integrator::Exact, ..scene.to_draft() }.check()
}

impl From<ParameterError> for AccuracyError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}
