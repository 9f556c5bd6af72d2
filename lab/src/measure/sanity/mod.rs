//! Signs of a mistake in a scene, a run or a log: [docs/sanity.md](../../../../docs/sanity.md) has the thresholds.

mod fit;
mod hold;
mod log;
mod miscount;
mod reading;
mod run;
mod scene;

use serde::Serialize;

use crate::files::scene::{Scene, Stabilizer};

pub(crate) use log::{LogSigns, SHARE};
pub(crate) use run::RunSigns;

/// What a sign hints at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sign {
    /// A sign is turned: the environment or the stabilizer pushes along the motion.
    Reversed,
    /// A number is out of anything that a hand does, as if its unit were another.
    Unit,
    /// Nothing was touched.
    Untouched,
    /// A force never acts.
    Idle,
    /// A force does not act from its row of a log until the next.
    Hold,
    /// A reading of a log looks bad.
    Reading,
    /// A stabilizer stands before an environment that it does not assume.
    Outside,
    /// Steps of an integrator are too long for the motion.
    Coarse,
    /// A stabilizer brakes for a debt that is none of the true port.
    Miscounted,
}

/// One sign of a mistake, in a sentence that says what was seen and where.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Oddity {
    /// What it hints at.
    pub sign: Sign,
    /// The sentence.
    pub text: String,
}

impl Oddity {
    pub(crate) fn new(sign: Sign, text: impl Into<String>) -> Self {
        Self { sign, text: text.into() }
    }

    /// The sign of a stabilizer of `table` before an environment of `scene` that gives energy by its own law, where that is
    /// outside of what it assumes.
    pub(crate) fn outside(scene: &Scene, table: Stabilizer) -> Option<Self> {
        let assumed = table.kind().assumes().filter(|_| scene.environment.kind().is_active())?;
        let (name, environment) = (table.name(), scene.environment.name());
        let text = format!(
            "{name} assumes {assumed}, and this {environment} gives energy by its own law: outside of what it promises"
        );
        Some(Self::new(Sign::Outside, text))
    }
}

/// Rate below which no loop holds a hand, Hz.
const SLOWEST: f64 = 10.0;

/// Rate above which no such loop runs, Hz.
const FASTEST: f64 = 1e6;

/// Distance that no hand goes to and fro, m: a tall man's arms span 2 m.
const REACH: f64 = 2.0;

/// Force that no hand exerts, N: the weight of 200 kg.
const STRONGEST: f64 = 2000.0;
