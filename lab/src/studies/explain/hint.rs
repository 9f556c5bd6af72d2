//! Hint of two lines under a run that diverges.

use std::fmt;

use crate::files::Scene;
use crate::measure::balance::Fate;
use crate::measure::{Limits, LinearPart};
use crate::simulate::{Space, Tick};
use crate::text::found;

/// Watches a run; its `Display` gives the reason in two lines after a run that diverges, else nothing.
#[derive(Clone, Debug)]
pub struct Hint {
    scene: Scene,
    fate: Fate,
}

impl Hint {
    /// The hint before the first tick.
    pub fn new(scene: &Scene) -> Self {
        Self { scene: scene.clone(), fate: Fate::new(scene) }
    }

    /// Adds one more tick.
    pub fn add<V: Space>(&mut self, tick: &Tick<V>) {
        self.fate.add(tick);
    }

    /// Whether the run diverged.
    pub fn diverged(&self) -> bool {
        !self.fate.is_bounded()
    }

    /// The reason, as far as a formula gives one, in the words of [`Explanation`](super::Explanation).
    fn reason(&self) -> String {
        let Ok(part) = LinearPart::of(&self.scene) else {
            return "the run grows; no formula applies to this loop".to_owned();
        };
        let own = part.environment.stiffness;
        match part.stable_stiffness() {
            None => "no stiffness of this loop is stable".to_owned(),
            Some([_, most]) if own > most => {
                let (own, most, times) = (found(own), found(most), found(own / most));
                format!("{own} N/m is {times} times what the loop bears by itself, {most} N/m")
            }
            Some([least, _]) if own < least => {
                let (own, least) = (found(own), found(least));
                format!("{own} N/m is less than the {least} N/m from which on the loop decays")
            }
            Some(_) => {
                "in contact the loop decays; what drives it is not in its linear part".to_owned()
            }
        }
    }
}

impl fmt::Display for Hint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.diverged() {
            return Ok(());
        }
        writeln!(f, "  diverges     {}", self.reason())?;
        writeln!(
            f,
            "               `lyapunov explain` says where the energy came from and what helps"
        )
    }
}

/// The limits that the scene's own stiffness breaks: key, name, limit, and own stiffness over limit.
pub(super) fn broken(limits: &Limits) -> Vec<(&'static str, &'static str, f64, Option<f64>)> {
    let Some(own) = limits.stiffness else { return vec![] };
    let named = limits.named().into_iter();
    let all = named.filter_map(|(key, name, limit)| limit.map(|limit| (key, name, limit)));
    let over = all.filter(|(_, _, limit)| own > *limit);
    over.map(|(key, name, limit)| (key, name, limit, (limit > 0.0).then(|| own / limit))).collect()
}
