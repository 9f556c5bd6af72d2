//! Stabilizer in the scalar of its scene, asked in `f64`.

use lyapunov::{Correction, Mask, PortSample, Scalar, Stabilizer};

use super::account::Account;
use super::{Asked, Left};
use crate::files::log::LogError;
#[cfg(feature = "every-scalar")]
use crate::files::scene::Scalar as Width;
use crate::files::scene::Scene;
use crate::simulate::family::StabilizerName;
use crate::simulate::{AnyStabilizer, Fitted, Space};

/// Reason why a port around the environment is not asked.
const AROUND: &str =
    "a port around the environment, which it asks for other forces than those of the log";

/// Stabilizer of efforts, in the scalar of its scene.
#[derive(Debug)]
pub(super) enum Entrant {
    Wide(AnyStabilizer<f64>),
    #[cfg(feature = "every-scalar")]
    Narrow(AnyStabilizer<f32>),
}

/// Answer of a stabilizer to one tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Answer {
    /// The force that it adds, N.
    pub(super) added: f64,
    /// The debt that it cannot serve, J.
    pub(super) shortfall: f64,
    pub(super) accepted: bool,
}

impl Entrant {
    pub(super) fn answer(&mut self, sample: &PortSample<f64>, effort: f64) -> Answer {
        match self {
            Self::Wide(stabilizer) => told(stabilizer, sample, effort),
            #[cfg(feature = "every-scalar")]
            Self::Narrow(stabilizer) => told(stabilizer, sample, effort),
        }
    }
}

/// The answer of a stabilizer of `T`; what it adds is subtracted in `T`, so that nothing stays nothing.
fn told<T: Scalar + Space>(
    stabilizer: &mut AnyStabilizer<T>,
    sample: &PortSample<f64>,
    effort: f64,
) -> Answer {
    let [period, position, velocity] = [sample.period, sample.position, sample.velocity].map(T::of);
    let [displacement, applied, work] =
        [sample.displacement, sample.applied, sample.work].map(T::of);
    let sample = PortSample { period, position, velocity, displacement, applied, work };
    let effort = T::of(effort);
    let Correction { effort: commanded, shortfall, accepted, .. } =
        stabilizer.stabilize(&sample, effort);
    let added = (commanded - effort).lane(0);
    Answer { added, shortfall: shortfall.lane(0), accepted: Mask::all(accepted) }
}

/// Those who are asked, and those who cannot be.
///
/// # Errors
/// A scene in several dimensions; a stabilizer that is named and lacks a number; nobody left.
pub(super) fn entered(asked: &Asked) -> Result<(Vec<Account>, Vec<Left>), LogError> {
    let (scene, name) = (&asked.scene, &asked.name);
    if scene.dimensions() > 1 {
        let axes = scene.dimensions();
        return Err(LogError::about(name, format!("the scene has {axes} axes, and a log has one"))
            .with_help("give --scene one without [space]"));
    }
    let (mut accounts, mut left) = (Vec::new(), Vec::new());
    for member in asked.stabilizers.on(scene) {
        match entrant(member, scene).map_err(|error| {
            LogError::new(format!("{member} on {name}: {error}"))
                .with_help("give the scene what it lacks, or leave that stabilizer out")
        })? {
            Some(entrant) => accounts.push(Account::new(member, entrant, scene.delay_ticks())),
            None => left.push(Left { stabilizer: member.name(), reason: AROUND }),
        }
    }
    if accounts.is_empty() {
        let names: Vec<&str> = left.iter().map(|it| it.stabilizer).collect();
        let message = format!("{} cannot be replayed: {AROUND}", names.join(", "));
        return Err(LogError::new(message).with_help(
            "name one that answers a force, such as popc; lyapunov compare runs these",
        ));
    }
    Ok((accounts, left))
}

/// The stabilizer on a motion that starts at `start` m and m/s, and not where its scene does; none where that makes none.
pub(super) fn started(member: StabilizerName, scene: &Scene, start: [f64; 2]) -> Option<Entrant> {
    let scene = member.started_in(scene, start).ok()?;
    entrant(member, &scene).ok()?
}

/// The stabilizer; none for a port around the environment.
fn entrant(
    member: StabilizerName,
    scene: &Scene,
) -> Result<Option<Entrant>, lyapunov::ParameterError> {
    #[cfg(feature = "every-scalar")]
    if scene.scalar == Width::F32 {
        return Ok(member.on(scene).map(Fitted::behind)?.map(Entrant::Narrow));
    }
    Ok(member.on(scene).map(Fitted::behind)?.map(Entrant::Wide))
}
