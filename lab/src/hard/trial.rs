//! What a case does: it runs, with our stabilizer in every scalar, or with any other.

use std::fmt;

use lyapunov::lanes::{AutoF32x8, AutoF64x8};
use lyapunov::{
    DampingLimit, Dissipation, Lolc, ParameterError, Plant, PortEnergy, Scalar, Stabilizer,
};

use super::naive::Naive;
use super::tally::{Tally, larger};
use super::watched::{Terms, Watched};
use crate::scene::{Candidate, Diagnostic, Environment, Finite, Scene};
use crate::{AnyStabilizer, Assembly, Space, scene};

/// Why a case cannot run: it is not written right.
#[derive(Debug)]
pub enum HardError {
    /// Its scene is not right.
    Scene(Box<Diagnostic>),
    /// A part of it cannot be made.
    Parameter(ParameterError),
    /// Whoever watched ended it.
    Stopped,
}

impl fmt::Display for HardError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene(error) => error.fmt(f),
            Self::Parameter(error) => error.fmt(f),
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

/// The same runs in each kind of number; runs at the same place differ in nothing else.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Runs {
    /// In `f64`; empty where the case is for `f32` alone.
    pub(super) double: Vec<Tally>,
    /// In `f32`; empty where the case is for `f64` alone.
    pub(super) single: Vec<Tally>,
    /// In lanes of `f64`, lane by lane.
    pub(super) double_lanes: Vec<Tally>,
    /// In lanes of `f32`, lane by lane.
    pub(super) single_lanes: Vec<Tally>,
}

/// A program that is the same in every scalar, from starts that differ a little.
pub(super) trait EveryScalar {
    /// One run, with lane `i` from start `first + i`.
    fn ours_in<T: Scalar>(&self, first: usize) -> Result<Vec<Tally>, HardError>;

    /// Whether it is within the range of `f32`.
    fn fits_single(&self) -> bool {
        true
    }
}

/// As many starts as the widest lanes hold.
const STARTS: usize = 8;

impl Runs {
    /// All runs of `program`: start by start, and all at once on lanes.
    pub(super) fn of(program: &impl EveryScalar) -> Result<Self, HardError> {
        let mut runs = Self::default();
        for first in 0..STARTS {
            runs.double.append(&mut program.ours_in::<f64>(first)?);
            if program.fits_single() {
                runs.single.append(&mut program.ours_in::<f32>(first)?);
            }
        }
        runs.double_lanes = program.ours_in::<AutoF64x8>(0)?;
        if program.fits_single() {
            runs.single_lanes = program.ours_in::<AutoF32x8>(0)?;
        }
        Ok(runs)
    }

    /// Whether every lane came to what a scalar run came to: the one at its place, or the first where all lanes run
    /// that one.
    pub(super) fn lanes_equal(&self) -> bool {
        let alike = |lanes: &[Tally], scalars: &[Tally]| {
            let same = scalars.len() != lanes.len();
            lanes.iter().enumerate().all(|(lane, tally)| {
                scalars.get(if same { 0 } else { lane }).is_none_or(|scalar| scalar == tally)
            })
        };
        alike(&self.double_lanes, &self.double) && alike(&self.single_lanes, &self.single)
    }

    /// All of them.
    pub(super) fn all(&self) -> impl Iterator<Item = &Tally> {
        let scalars = self.double.iter().chain(&self.single);
        scalars.chain(self.double_lanes.iter().chain(&self.single_lanes))
    }
}

/// A stabilizer of somebody's own, made anew for every run, on a mass (kg) and a period (s).
pub type Own<'a> = &'a dyn Fn() -> AnyStabilizer<f64>;

/// What a case does.
pub(super) trait Trial: Send + Sync {
    /// With our stabilizer, in every scalar.
    fn ours(&self) -> Result<Runs, HardError>;

    /// With a stabilizer of somebody's own, in `f64`; none where it is about something else.
    fn with(&self, own: Own<'_>) -> Result<Option<Tally>, HardError>;

    /// With the naive one.
    fn naive(&self) -> Result<Option<Tally>, HardError> {
        self.with(&|| AnyStabilizer::new(Naive::<f64>::default()))
    }

    /// The scene, if it is one.
    fn scene(&self) -> Option<&str> {
        None
    }
}

/// A run that is the same program in every scalar, with a number of variations.
pub(super) trait Play: Send + Sync {
    /// Run number `index` under `stabilizer`: lane `i` is of variation `first + i`. Answers with what is measured in a
    /// way of its own.
    fn play<T: Scalar>(
        &self,
        index: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError>;

    /// How many runs there are.
    fn runs(&self) -> u64 {
        1
    }

    /// The device's damping that is credited, N·s/m.
    fn damping(&self) -> f64 {
        0.0
    }

    /// What our stabilizer may inject.
    fn limit<T: Scalar>(&self) -> Result<DampingLimit<T>, ParameterError>;

    /// What has to be known of the runs beside the limit.
    fn terms(&self, limit: f64) -> Terms;

    /// Whether it is within the range of `f32`.
    fn fits_single(&self) -> bool {
        true
    }
}

/// A play with our stabilizer, or any other.
pub(super) struct Played<P>(pub(super) P);

impl<P: Play> Played<P> {
    fn under<T: Scalar, S: Stabilizer<T>>(
        &self,
        first: usize,
        stabilizer: impl Fn() -> Result<S, ParameterError>,
    ) -> Result<Vec<Tally>, HardError> {
        // In f32 the limit is rounded once more.
        let limit = self.0.limit::<T>()?.most().lane(0);
        let mut worst: Option<Vec<Tally>> = None;
        for index in 0..self.0.runs() {
            // The credit is what the scalar makes of the damping.
            let damping = T::of(self.0.damping()).lane(0);
            let terms = Terms { damping, ..self.0.terms(limit) };
            let (watched, record) = Watched::new::<T>(stabilizer()?, terms);
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
}

impl<P: Play> EveryScalar for Played<P> {
    fn ours_in<T: Scalar>(&self, first: usize) -> Result<Vec<Tally>, HardError> {
        let damper = Dissipation::of(T::of(self.0.damping()))?;
        self.under::<T, _>(first, || Ok(Lolc::new((PortEnergy, damper), self.0.limit::<T>()?)))
    }

    fn fits_single(&self) -> bool {
        self.0.fits_single()
    }
}

impl<P: Play> Trial for Played<P> {
    fn ours(&self) -> Result<Runs, HardError> {
        Runs::of(self)
    }

    fn with(&self, own: Own<'_>) -> Result<Option<Tally>, HardError> {
        Ok(self.under::<f64, _>(0, || Ok(own()))?.pop())
    }
}

/// A loop closed as a scene says.
pub(super) struct Looped {
    /// The scene, TOML.
    pub(super) text: String,
    /// Where swings are counted from, m.
    pub(super) rest: f64,
    /// The damping that the naive one credits, N·s/m.
    pub(super) credit: f64,
}

/// The starts of a scene, as shares of its own.
const SHARES: [f64; 4] = [1.0, 0.97, 0.93, 0.88];

impl Looped {
    fn scene(&self, share: f64) -> Result<Scene, HardError> {
        let mut scene = Scene::parse(&self.text, "a hard case")?;
        let moved = |from: f64| Finite::new(from * share).map(Into::into);
        let initial = &mut scene.initial;
        // A share of a finite number is one.
        (initial.position, initial.velocity) =
            match (moved(initial.position.get()), moved(initial.velocity.get())) {
                (Ok(position), Ok(velocity)) => (position, velocity),
                _ => return Ok(scene),
            };
        Ok(scene)
    }

    fn run<V: Space>(
        &self,
        share: f64,
        stabilizer: impl FnOnce(&Scene) -> Result<AnyStabilizer<V>, ParameterError>,
    ) -> Result<Vec<Tally>, HardError> {
        let scene = self.scene(share)?;
        let stabilizer = stabilizer(&scene)?;
        Ok(looped(&scene, self.rest, stabilizer)?)
    }

    fn named<V: Space>(&self, share: f64) -> Result<Vec<Tally>, HardError> {
        self.run::<V>(share, |scene| match scene.stabilizer {
            Some(named) => AnyStabilizer::named(scene, named),
            None => Ok(AnyStabilizer::new(super::cases::Nothing)),
        })
    }
}

/// What the loop of `scene` comes to under `stabilizer`, with swings counted from `rest`, lane by lane.
fn looped<V: Space>(
    scene: &Scene,
    rest: f64,
    stabilizer: AnyStabilizer<V>,
) -> Result<Vec<Tally>, ParameterError> {
    let (watched, record) = Watched::new::<V::Scalar>(stabilizer, terms(scene, rest));
    let mut assembly = Assembly::stabilized_by(scene, AnyStabilizer::new(watched))?;
    let mut drive = assembly.plant.start();
    for _ in 0..=scene.ticks() {
        assembly.tick(&mut drive);
    }
    Ok(record.tallies())
}

/// What the loop of `scene` comes to under the stabilizer that it names, in the scalar of `V`: with swings counted from the
/// origin, and without a word on the account where the candidate is the paper's and the environment not a wall.
///
/// # Errors
/// A parameter that is right by itself but out of the range of the scalar, alone or together with others.
pub fn watch<V: Space>(scene: &Scene) -> Result<Vec<Tally>, ParameterError> {
    let named = AnyStabilizer::<V>::of(scene)?;
    looped(scene, 0.0, named.unwrap_or_else(|| AnyStabilizer::new(super::cases::Nothing)))
}

fn terms(scene: &Scene, rest: f64) -> Terms {
    let (cap, damping, beyond) = match scene.stabilizer {
        None => (0.0, 0.0, 0.0),
        Some(scene::Stabilizer::Popc(popc)) => (popc.damping_cap.get(), 0.0, 0.0),
        Some(scene::Stabilizer::Lolc(lolc)) => {
            let (damping, beyond) = credited(scene, lolc.candidate);
            (lolc.damping_cap.get(), damping, beyond)
        }
    };
    let force = scene.effects.saturation.map_or(f64::INFINITY, |it| it.force.get());
    // What a scene says is rounded once more on its way to f32.
    let limit = (cap * scene.mass() / scene.period() * (1.0 + 1e-6)).min(f64::MAX);
    let force = force * (1.0 + 1e-6);
    Terms { ticks: scene.ticks(), rest, limit, damping, beyond, force }
}

/// The damping that a candidate credits, and the surface beyond which it does.
fn credited(scene: &Scene, candidate: Candidate) -> (f64, f64) {
    match (candidate, &scene.environment) {
        (Candidate::DeviceDamping, _) => (scene.device.damping.get(), f64::NEG_INFINITY),
        (Candidate::MassSpringDamper, Environment::Wall(wall)) => {
            (wall.damping.get(), wall.position.get())
        }
        _ => (0.0, 0.0),
    }
}

impl Trial for Looped {
    fn ours(&self) -> Result<Runs, HardError> {
        let mut runs = Runs::default();
        for share in SHARES {
            runs.double.append(&mut self.named::<f64>(share)?);
            runs.single.append(&mut self.named::<f32>(share)?);
        }
        // Lanes of one start: eight times the same.
        runs.double_lanes = self.named::<AutoF64x8>(SHARES[0])?;
        Ok(runs)
    }

    fn with(&self, own: Own<'_>) -> Result<Option<Tally>, HardError> {
        Ok(self.run::<f64>(SHARES[0], |_| Ok(own()))?.pop())
    }

    fn naive(&self) -> Result<Option<Tally>, HardError> {
        self.with(&|| AnyStabilizer::new(Naive::<f64>::crediting(self.credit)))
    }

    fn scene(&self) -> Option<&str> {
        Some(&self.text)
    }
}
