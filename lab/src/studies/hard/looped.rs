//! Hard cases that are scenes.

use lyapunov::{ParameterError, Scalar};

use super::member;
use super::naive::Naive;
use super::tally::Tally;
use super::terms::{Terms, Unsound};
use super::trial::{HardError, MakeStabilizer, Runs, Trial};
use super::watched::Meters;
use crate::files::scene::{Candidate, Finite, Lolc, Pledge, Scene, Stabilizer};
use crate::simulate::family::StabilizerName;
use crate::simulate::{AnyStabilizer, F64x8, Fitted, Rollout, Space, Tick};

/// The loop of a scene.
pub(super) struct Looped {
    /// The scene, TOML.
    pub(super) text: String,
    /// The position that swings are measured from, m.
    pub(super) rest: f64,
    /// The damping that the naive stabilizer credits, N·s/m.
    pub(super) credit: f64,
}

/// Starts of each scene, as shares of its own start.
const SHARES: [f64; 4] = [1.0, 0.97, 0.93, 0.88];

impl Looped {
    fn scene(&self, share: f64) -> Result<Scene, HardError> {
        Ok(from_start(&Scene::parse(&self.text, "a hard case")?, share))
    }

    fn named<V: Space>(&self, share: f64) -> Result<Vec<Tally>, HardError> {
        let scene = self.scene(share)?;
        Ok(looped::<V>(&scene, self.rest, named_in::<V>(&scene), Fitted::of(&scene)?)?)
    }

    fn of_family<T: Scalar + Space>(
        &self,
        member: StabilizerName,
        share: f64,
    ) -> Result<Vec<Tally>, HardError> {
        let scene = self.scene(share)?;
        if !member.fits(&scene) {
            return Err(HardError::NoPart);
        }
        let pledge = member::pledge_on::<T>(member.table(&scene), &scene);
        Ok(looped::<T>(&scene, self.rest, pledge, member.on(&scene)?)?)
    }
}

/// The same scene from a `share` of its start.
pub(super) fn from_start(scene: &Scene, share: f64) -> Scene {
    let moved = |from: f64| Finite::new(from * share).map(Into::into);
    let mut draft = scene.to_draft();
    let initial = &mut draft.initial;
    if let (Ok(position), Ok(velocity)) =
        (moved(initial.position.get()), moved(initial.velocity.get()))
    {
        (initial.position, initial.velocity) = (position, velocity);
    }
    // A share of a start is a start.
    draft.check().unwrap_or_else(|_| scene.clone())
}

/// Measurements of the loop of `scene` under `stabilizer`, with swings measured from `rest`, lane by lane.
fn looped<V: Space>(
    scene: &Scene,
    rest: f64,
    pledge: Pledge,
    fitted: Fitted<V>,
) -> Result<Vec<Tally>, ParameterError> {
    let mut meters = Meters::new::<V::Scalar>(terms(scene, rest, pledge));
    let mut rollout = Rollout::assemble(scene, fitted)?;
    // The run goes to its end even if the motion leaves the range of the scalar.
    for _ in 0..=scene.ticks() {
        let Tick { measured, environment, correction, .. } = rollout.tick();
        meters.watch(&measured, environment, &correction);
    }
    Ok(meters.tallies())
}

/// The pledge of the stabilizer that a scene names.
pub(super) fn named_in<V: Space>(scene: &Scene) -> Pledge {
    member::pledge_on::<V::Scalar>(scene.stabilizer, scene)
}

/// The terms of a run of `scene`, with swings measured from `rest`.
pub(super) fn terms(scene: &Scene, rest: f64, pledge: Pledge) -> Terms {
    let cap = scene.damping_cap();
    let force = scene.effects.saturation.map_or(f64::INFINITY, |it| it.force.get());
    // The numbers of a scene are rounded once more on their way to f32.
    let most = scene.damping(cap).limit().map_or(f64::MAX, |limit| limit.most());
    let limit = (most * (1.0 + 1e-6)).min(f64::MAX);
    let force = force * (1.0 + 1e-6);
    Terms { ticks: scene.ticks(), rest, limit, pledge, force, unsound: Unsound::Range }
}

impl Trial for Looped {
    fn promised_by(&self, member: StabilizerName) -> Result<bool, HardError> {
        let scene = self.scene(SHARES[0])?;
        let credits = |named| {
            matches!(named, Some(Stabilizer::Lolc(Lolc { candidate, .. }))
                if candidate == Candidate::MassSpringDamper)
        };
        // Only the paper's candidate promises the bound of a case with the paper's credit.
        let alike = || member.table(&scene) == scene.stabilizer;
        Ok(if credits(scene.stabilizer) { alike() } else { member::promises(member) })
    }

    fn ours(&self) -> Result<Runs, HardError> {
        let mut runs = Runs::default();
        for share in SHARES {
            runs.double.append(&mut self.named::<f64>(share)?);
            runs.single.append(&mut self.named::<f32>(share)?);
        }
        // All eight lanes run the same start.
        runs.double_lanes = self.named::<F64x8>(SHARES[0])?;
        Ok(runs)
    }

    fn under(&self, member: StabilizerName) -> Result<Runs, HardError> {
        let mut runs = Runs::default();
        for share in SHARES {
            runs.double.append(&mut self.of_family::<f64>(member, share)?);
            runs.single.append(&mut self.of_family::<f32>(member, share)?);
        }
        Ok(runs)
    }

    fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        let scene = self.scene(SHARES[0])?;
        Ok(looped(&scene, self.rest, named_in::<f64>(&scene), Fitted::Behind(own()))?.pop())
    }

    fn naive(&self) -> Result<Option<Tally>, HardError> {
        self.with(&|| AnyStabilizer::new(Naive::<f64>::crediting(self.credit)))
    }

    fn scene(&self) -> Option<&str> {
        Some(&self.text)
    }
}
