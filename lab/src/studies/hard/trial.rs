//! The runs of a case: with our stabilizer in every scalar, or with any other.

use std::fmt;

use lyapunov::lanes::{AutoF32x8, AutoF64x8};
use lyapunov::{DampingLimit, Dissipation, ParameterError, PortEnergy, Scalar};

use super::member;
use super::naive::Naive;
use super::tally::{Tally, larger};
use super::terms::Terms;
use super::watched::Watched;
use crate::files::scene::{Basis, Diagnostic, Pledge};
use crate::simulate::family::StabilizerName;
use crate::simulate::{AnyStabilizer, Space};

/// Reason why a case did not run.
#[derive(Debug)]
pub enum HardError {
    /// Its scene is not valid.
    Scene(Box<Diagnostic>),
    /// A part of it cannot be built.
    Parameter(ParameterError),
    /// The stabilizer cannot take part: the case lacks what it is set by, or an environment that it can ask.
    NoPart,
    /// The caller stopped it.
    Stopped,
}

impl fmt::Display for HardError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene(error) => error.fmt(f),
            Self::Parameter(error) => error.fmt(f),
            Self::NoPart => f.write_str("the stabilizer takes no part"),
            Self::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for HardError {}

impl From<Diagnostic> for HardError {
    fn from(error: Diagnostic) -> Self {
        Self::Scene(Box::new(error))
    }
}

impl From<ParameterError> for HardError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

/// The same runs in each kind of number; runs at the same place differ only in that.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Runs {
    /// Runs in `f64`; empty where the case is for `f32` alone.
    pub(super) double: Vec<Tally>,
    /// Runs in `f32`; empty where the case is for `f64` alone.
    pub(super) single: Vec<Tally>,
    /// Runs in lanes of `f64`, lane by lane.
    pub(super) double_lanes: Vec<Tally>,
    /// Runs in lanes of `f32`, lane by lane.
    pub(super) single_lanes: Vec<Tally>,
}

/// A program that runs alike in every scalar, from slightly different starts.
pub(super) trait EveryScalar {
    /// Measurements of one run, with lane `i` from start `first + i`.
    fn ours_in<T: Scalar>(&self, first: usize) -> Result<Vec<Tally>, HardError>;
}

/// Number of starts: as many as the widest lanes hold.
const STARTS: usize = 8;

impl Runs {
    /// All runs of `program`: start by start in scalars, and all starts at once in lanes.
    pub(super) fn of(program: &impl EveryScalar) -> Result<Self, HardError> {
        let double = |first| program.ours_in::<f64>(first);
        let mut runs = Self::of_scalars(double, |first| program.ours_in::<f32>(first))?;
        runs.double_lanes = program.ours_in::<AutoF64x8>(0)?;
        runs.single_lanes = program.ours_in::<AutoF32x8>(0)?;
        Ok(runs)
    }

    /// The runs of a program in scalars alone, start by start.
    pub(super) fn of_scalars(
        double: impl Fn(usize) -> Result<Vec<Tally>, HardError>,
        single: impl Fn(usize) -> Result<Vec<Tally>, HardError>,
    ) -> Result<Self, HardError> {
        let mut runs = Self::default();
        for first in 0..STARTS {
            runs.double.append(&mut double(first)?);
            runs.single.append(&mut single(first)?);
        }
        Ok(runs)
    }

    /// Whether every lane equals a scalar run: the one at its place, or the first one where all lanes run that; none
    /// without lanes.
    pub(super) fn lanes_equal(&self) -> Option<bool> {
        let alike = |lanes: &[Tally], scalars: &[Tally]| {
            let same = scalars.len() != lanes.len();
            lanes.iter().enumerate().all(|(lane, tally)| {
                scalars.get(if same { 0 } else { lane }).is_none_or(|scalar| scalar == tally)
            })
        };
        let lanes = self.double_lanes.len() + self.single_lanes.len();
        (lanes > 0).then(|| {
            alike(&self.double_lanes, &self.double) && alike(&self.single_lanes, &self.single)
        })
    }

    /// The measurements of all runs.
    pub(super) fn all(&self) -> impl Iterator<Item = &Tally> {
        let scalars = self.double.iter().chain(&self.single);
        scalars.chain(self.double_lanes.iter().chain(&self.single_lanes))
    }
}

/// A maker of your own stabilizer, called anew for every run.
pub type MakeStabilizer<'a> = &'a dyn Fn() -> AnyStabilizer<f64>;

/// The runs of a case.
pub(super) trait Trial: Send + Sync {
    /// Runs with our stabilizer, in every scalar.
    fn ours(&self) -> Result<Runs, HardError>;

    /// Runs with a member of the family, in `f64` and `f32`.
    ///
    /// # Errors
    /// [`HardError::NoPart`] of one that takes no part; a case that is not well-formed.
    fn under(&self, member: StabilizerName) -> Result<Runs, HardError>;

    /// Whether the bound is a promise of `member`.
    fn promised_by(&self, member: StabilizerName) -> Result<bool, HardError> {
        Ok(member::promises(member))
    }

    /// A run with the caller's own stabilizer, in `f64`; none where the case is about something else.
    fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError>;

    /// A run with the naive stabilizer.
    fn naive(&self) -> Result<Option<Tally>, HardError> {
        self.with(&|| AnyStabilizer::new(Naive::<f64>::default()))
    }

    /// The scene's text, if the case is a scene.
    fn scene(&self) -> Option<&str> {
        None
    }
}

/// A program that runs alike in every scalar, in several variations.
pub(super) trait Play: Send + Sync {
    /// Run number `index` under `stabilizer`, with lane `i` from start `first + i`. Returns the value that the case
    /// measures itself.
    fn play<T: Scalar>(
        &self,
        index: u64,
        first: usize,
        stabilizer: impl lyapunov::Stabilizer<T>,
    ) -> Result<T, ParameterError>;

    /// The number of runs.
    fn runs(&self) -> u64 {
        1
    }

    /// The loop that stabilizers are set for; ours credits its damping.
    fn basis(&self) -> Basis;

    /// The limit of the injected damping.
    fn limit<T: Scalar>(&self) -> Result<DampingLimit<T>, ParameterError> {
        self.basis().limit.limit()
    }

    /// The terms of the runs under that limit, N·s/m.
    fn terms(&self, limit: f64) -> Terms;
}

/// A play under our stabilizer or any other.
pub(super) struct Played<P>(pub(super) P);

impl<P: Play> Played<P> {
    fn run<T: Scalar, S: lyapunov::Stabilizer<T> + 'static>(
        &self,
        first: usize,
        pledge: Pledge,
        stabilizer: impl Fn() -> Result<S, HardError>,
    ) -> Result<Vec<Tally>, HardError> {
        // In f32 the limit is rounded once more.
        let limit = self.0.limit::<T>()?.most().lane(0);
        let mut worst: Option<Vec<Tally>> = None;
        for index in 0..self.0.runs() {
            let terms = Terms { pledge: pledge.clone(), ..self.0.terms(limit) };
            let (watched, record) = Watched::new(stabilizer()?, terms);
            let value = self.0.play::<T>(index, first, watched)?;
            let mut tallies = record.tallies();
            for (lane, tally) in tallies.iter_mut().enumerate() {
                tally.value = larger(tally.value, value.lane(lane));
            }
            worst = Some(match worst {
                None => tallies,
                Some(worst) => worst.into_iter().zip(tallies).map(|(a, b)| a.worse(b)).collect(),
            });
        }
        Ok(worst.unwrap_or_default())
    }

    fn of_family<T: Scalar + Space>(
        &self,
        member: StabilizerName,
        first: usize,
    ) -> Result<Vec<Tally>, HardError> {
        let basis = self.0.basis();
        let pledge = member::pledge_of::<T>(member, &basis);
        self.run::<T, _>(first, pledge, || member::set_by::<T>(member, &basis))
    }
}

impl<P: Play> EveryScalar for Played<P> {
    fn ours_in<T: Scalar>(&self, first: usize) -> Result<Vec<Tally>, HardError> {
        let damping = T::of(self.0.basis().damping);
        let (damper, pledge) = (Dissipation::of(damping)?, Pledge::damper(damping.lane(0)));
        let lolc = || Ok(lyapunov::Lolc::new((PortEnergy, damper), self.0.limit::<T>()?));
        self.run::<T, _>(first, pledge, lolc)
    }
}

impl<P: Play> Trial for Played<P> {
    fn ours(&self) -> Result<Runs, HardError> {
        Runs::of(self)
    }

    fn under(&self, member: StabilizerName) -> Result<Runs, HardError> {
        let double = |first| self.of_family::<f64>(member, first);
        let single = |first| self.of_family::<f32>(member, first);
        Runs::of_scalars(double, single)
    }

    fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        let pledge = Pledge::damper(self.0.basis().damping);
        Ok(self.run::<f64, _>(0, pledge, || Ok(own()))?.pop())
    }
}
