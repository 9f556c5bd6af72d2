//! Hint under a run: the reason of one that grows, a remark on one that starts in balance.

use std::fmt;

use crate::files::Scene;
use crate::files::scene::Integrator;
use crate::measure::{Limits, LinearPart, Summary, Verdict};
use crate::simulate::Stabilizing;
use crate::text::{folded, found, given, near_one};

/// The reason where a run left the range of the numbers and no force had acted.
pub(super) const LEFT: &str =
    "the first force or way leaves the range of the numbers: a value is far too large";

/// The reason where nothing acts beside a linear loop that is stable.
pub(super) const TRANSIENT: &str =
    "the loop is linear and stable: the growth is a beat or a transient; run longer";

/// The last line under a reason.
pub(crate) const NEXT: &str = "`lyapunov explain` says where the energy came from and what helps";

/// The reason why a run grows, or swings in a linear loop that is not stable and that nothing stabilizes: its `Display` gives
/// it with the command that says more. Under a run that starts in balance and stays there it is a remark on that, and under
/// another run nothing.
#[derive(Clone, Debug)]
pub struct Hint<'a>(&'a Summary);

impl<'a> Hint<'a> {
    /// The hint to a run.
    pub fn of(summary: &'a Summary) -> Self {
        Self(summary)
    }

    /// The reason why a run grows, or the remark, in one sentence; none under a run that does not grow and needs no remark.
    pub fn sentence(&self) -> Option<String> {
        if self.0.verdict() == Verdict::Grows {
            return Some(self.reason());
        }
        self.remark()
    }

    /// The remark on a run that starts in balance and stays there.
    pub(crate) fn remark(&self) -> Option<String> {
        let in_balance = self.0.fate.criterion(0).starts_in_balance;
        (in_balance && self.0.settling_time() == Some(0.0)).then(|| undisturbed(&self.0.scene))
    }

    /// The reason why the run grows or swings.
    fn why(&self) -> Option<String> {
        match self.0.verdict() {
            Verdict::Grows => Some(self.reason()),
            Verdict::Swinging if self.is_loose() => {
                let is_limited = self.0.scene.effects.saturation.is_some();
                let bound = if is_limited { "; the saturation bounds the run" } else { "" };
                Some(self.reason() + bound)
            }
            _ => None,
        }
    }

    /// Whether a force acts in a linear loop that is not stable and that nothing stabilizes.
    fn is_loose(&self) -> bool {
        let is_unstable =
            || LinearPart::of(&self.0.scene).is_ok_and(|part| part.spectral_radius() > 1.0);
        self.0.acts() && self.0.stabilizing == Stabilizing::Table(None) && is_unstable()
    }

    /// The reason, as far as a formula gives one, in the words of [`Explanation`](super::Explanation).
    fn reason(&self) -> String {
        if !self.0.acts() {
            if self.0.left_range().is_some() {
                return LEFT.to_owned();
            }
            return "no force acts in this run: the loop is not what drives it".to_owned();
        }
        if let Some(unpaid) = self.unpaid() {
            return unpaid;
        }
        let Ok(part) = LinearPart::of(&self.0.scene) else {
            return "no formula applies to this loop".to_owned();
        };
        if self.0.left_range().is_none() && is_transient(&self.0.scene) {
            return TRANSIENT.to_owned();
        }
        let own = part.environment.stiffness;
        match part.stable_stiffness() {
            _ if own < 0.0 && part.spectral_radius() >= 1.0 => {
                let own = found(own);
                format!("the environment pushes away by {own} N/m, and nothing holds it")
            }
            None => "no stiffness of the linear loop is stable".to_owned(),
            Some([_, most]) if own > most => {
                let (own, most, times) = (found(own), found(most), found(own / most));
                format!(
                    "{own} N/m is {times} times what the linear loop bears by itself, {most} N/m"
                )
            }
            Some([least, _]) if own >= 0.0 && own < least => {
                let (own, least) = (found(own), found(least));
                format!(
                    "{own} N/m is less than the {least} N/m from which on the linear loop is stable"
                )
            }
            Some(_) => self.beyond(part),
        }
    }

    /// The reason where the linear loop is stable.
    fn beyond(&self, part: LinearPart) -> String {
        let scene = &self.0.scene;
        let more = match part.unstable_elsewhere(scene) {
            Some((place, radius)) => {
                format!(", but not{place}: spectral radius {}", near_one(radius, 8))
            }
            None if scene.integrator != Integrator::Exact => {
                "; what drives the run is not in it, and may be the integrator's own error: compare with integrator = \"exact\""
                    .to_owned()
            }
            None => "; what drives the run is not in it".to_owned(),
        };
        format!("in contact the linear loop is stable{more}")
    }

    /// The debt that a cap below the default left, beside which the stiffness explains little.
    fn unpaid(&self) -> Option<String> {
        let Summary { scene, shortfall, .. } = self.0;
        let cap = scene.written_cap().filter(|cap| *cap < scene.default_cap())?;
        let (cap, most) = (given(cap), given(scene.default_cap()));
        let told = format!(
            "the damping cap {cap} m / T left a debt unpaid; a larger damping_cap, up to {most}, may help"
        );
        (*shortfall > 0.0).then_some(told)
    }
}

impl fmt::Display for Hint<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.why(), self.remark()) {
            (Some(why), _) => {
                writeln!(f, "{}\n               {NEXT}", folded("  why          ", &why))
            }
            (None, Some(remark)) => writeln!(f, "{}", folded("  note         ", &remark)),
            (None, None) => Ok(()),
        }
    }
}

/// The remark on a run that starts in balance and never leaves it: it would do so in a loop that is not stable too, and what
/// rounding starts may take longer than the run to show.
pub(super) fn undisturbed(scene: &Scene) -> String {
    let radius = LinearPart::of(scene).ok().map(|part| part.spectral_radius());
    let radius = radius.filter(|radius| *radius > 1.0 && scene.stabilizer.is_none());
    let linear = radius.map_or_else(String::new, |radius| {
        format!(", and its linear loop is not stable: spectral radius {}", near_one(radius, 8))
    });
    in_balance("the run", &linear)
}

/// The remark on `runs` that start in balance and never leave it, with what else is `known` of the loop.
pub(crate) fn in_balance(runs: &str, known: &str) -> String {
    format!(
        "{runs} starts in balance and nothing takes it out of its band, so the verdict says nothing about the loop{known}; \
         start it elsewhere"
    )
}

/// Whether a loop is all linear and stable, so that whatever grows in its run decays in a longer one.
pub(super) fn is_transient(scene: &Scene) -> bool {
    LinearPart::of(scene).is_ok_and(|part| part.is_all_of(scene) && part.spectral_radius() < 1.0)
}

/// The limits that the scene's own stiffness breaks: key, name, limit, and own stiffness over limit.
pub(super) fn broken(limits: &Limits) -> Vec<(&'static str, &'static str, f64, Option<f64>)> {
    let Some(own) = limits.stiffness else { return vec![] };
    let named = limits.named().into_iter();
    let all = named.filter_map(|(key, name, limit)| limit.map(|limit| (key, name, limit)));
    let over = all.filter(|(_, _, limit)| own > *limit);
    over.map(|(key, name, limit)| (key, name, limit, (limit > 0.0).then(|| own / limit))).collect()
}
