//! Random scenes without end: `lyapunov hard --minutes`.

mod breach;
mod draw;
mod drawn;
mod effects;
mod environment;
mod hand;
mod promises;
mod shrink;
mod size;
mod ticks;

pub use breach::Breach;
pub use promises::breach;

use std::fmt;
use std::ops::ControlFlow;

use rayon::prelude::*;
use serde::{Serialize, Serializer};

use self::draw::Draw;
use crate::files::Scene;
use crate::show::json;
use crate::simulate::family::{BasicName, StabilizerName};

/// Cases that run side by side, and between two reports.
const BATCH: u64 = 64;

/// Cases of which one has a stabilizer that takes part in any.
const LOOKED_AT: u64 = 256;

/// Random scenes under a seed: case `k` is the same on every machine, whatever ran before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Soak {
    /// The seed.
    pub seed: u64,
    /// The stabilizer of all scenes; none takes each of those that ship and of the program's own.
    pub stabilizer: Option<StabilizerName>,
}

/// Result of some cases.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Soaked {
    /// The seed.
    pub seed: u64,
    /// The stabilizer, if it was given.
    pub stabilizer: Option<&'static str>,
    /// The cases that ran: those from 0 on, up to the first that breaks a promise.
    pub cases: u64,
    /// The first case that breaks a promise.
    pub found: Option<Found>,
}

/// A case that breaks a promise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Found {
    /// The case.
    pub case: u64,
    /// The promise that the scene breaks, in words.
    #[serde(serialize_with = "in_words")]
    pub broken: Breach,
    /// The text of the smallest scene that breaks it.
    pub scene: String,
}

fn in_words<S: Serializer>(breach: &Breach, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(breach)
}

impl Soak {
    /// The scene of a case; none if no draw made one, as under a stabilizer that takes part in no random loop.
    pub fn scene(&self, case: u64) -> Option<Scene> {
        self.drawn(case, &self.members())
    }

    /// Whether the stabilizer takes part in any random scene.
    pub fn takes_part(&self) -> bool {
        (0..LOOKED_AT).any(|case| self.scene(case).is_some())
    }

    /// Runs case after case on all cores until one breaks a promise. `watch` is called with the number of cases done,
    /// now and then, and may stop it.
    pub fn run(&self, watch: &mut dyn FnMut(u64) -> ControlFlow<()>) -> Soaked {
        let members = self.members();
        let stabilizer = self.stabilizer.map(StabilizerName::name);
        let done = |cases, found| Soaked { seed: self.seed, stabilizer, cases, found };
        let mut cases = 0;
        loop {
            let batch = (cases..cases + BATCH).into_par_iter();
            let found = batch.find_map_first(|case| {
                let scene = self.drawn(case, &members)?;
                let broken = promises::breach(&scene).ok()??;
                Some((case, scene, broken))
            });
            if let Some((case, scene, broken)) = found {
                return done(case + 1, Some(Found::of(case, &scene, broken)));
            }
            cases += BATCH;
            if watch(cases).is_break() {
                return done(cases, None);
            }
        }
    }

    fn drawn(&self, case: u64, members: &[StabilizerName]) -> Option<Scene> {
        drawn::scene(Draw::of(self.seed, case), members)
    }

    fn members(&self) -> Vec<StabilizerName> {
        let nobody = StabilizerName::Basic(BasicName::NoStabilizer);
        let all = StabilizerName::all().filter(|name| *name != nobody);
        self.stabilizer.map_or_else(|| all.collect(), |one| vec![one])
    }
}

impl Soaked {
    /// The results as JSON.
    pub fn to_json(&self) -> String {
        json::text(self)
    }
}

impl Found {
    fn of(case: u64, scene: &Scene, broken: Breach) -> Self {
        let whole = || (toml::to_string(scene).unwrap_or_default(), broken);
        let (scene, broken) = shrink::shrunk(scene, broken).unwrap_or_else(whole);
        Self { case, broken, scene }
    }

    /// The scene's file, with what it breaks and the `command` that says so at its head.
    pub fn file(&self, command: &str) -> String {
        format!("# {}: {}\n{}", command, self.broken, self.scene)
    }
}

impl fmt::Display for Soaked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { seed, cases, .. } = self;
        let who = self.stabilizer.map(|name| format!(" under {name}")).unwrap_or_default();
        match &self.found {
            None => {
                writeln!(f, "seed {seed}, cases 0 to {}{who}: every promise is kept", cases - 1)
            }
            Some(found) => {
                writeln!(f, "seed {seed}, case {}{who}: {}", found.case, found.broken)?;
                write!(f, "\n{}", found.scene)
            }
        }
    }
}
