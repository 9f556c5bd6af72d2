//! Remedies, each tried before it is reported.

use std::iter;

use super::Watch;
use super::goal::Goal;
use crate::files::scene::{
    Candidate, Cap, Draft, Integrator, Ledger, Lolc, NonNegative, Popc, Positive, Scene,
    Stabilizer, Work,
};
use crate::measure::balance::{Feel, Trial};
use crate::measure::{LinearPart, Verdict};

/// Safety factor that keeps a remedy inside a limit.
const MARGIN: f64 = 0.95;

/// The factor from one trial to the next.
const FURTHER: f64 = 1.25;

/// Trials before a remedy is given up.
const TRIALS: i32 = 24;

/// Halvings of an interval that is searched by formula.
const HALVINGS: u32 = 40;

/// Largest factor by which a remedy speeds up the servo, and the number of its trials: the runs take as much longer.
const FASTER: f64 = 64.0;
const FASTER_TRIALS: i32 = 5;

/// The damping caps that a stabilizer is tried with where they are below the default, as multiples of m / T.
const CAPS: [f64; 4] = [0.25, 0.1, 0.05, 0.02];

/// Change of a scene after which its run does not grow or, where its own is swinging already, settles.
#[derive(Clone, Debug, PartialEq)]
pub struct Remedy {
    /// The keys of the scene that change, with their new values.
    pub changes: Vec<(String, Change)>,
    /// The scene with the change, as it was run.
    pub scene: Scene,
    /// The verdict on that run.
    pub verdict: Verdict,
    /// Largest force on the plant in that run, N.
    pub peak_force: f64,
    /// Root mean square of the force on the plant minus that of the environment's own law, in contact, N; none without a
    /// contact with a wall or a solid.
    pub force_error: Option<f64>,
}

/// New value of a key.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// A number, in the unit of the key.
    Number(f64),
    /// A word.
    Word(&'static str),
}

/// Run of a scene in one space, reported to a watch; none without a verdict that is wanted, or where the loop does not decay.
pub(super) type Run = fn(&Scene, &dyn Fn(Verdict) -> bool, &Watch<'_>) -> Option<Trial>;

/// Search for changes whose run reaches a goal.
pub(super) struct Search<'a> {
    pub(super) goal: Goal,
    /// The energies moved in the run without a change, J: what leaves them as they are, to the bit, does nothing.
    pub(super) own: f64,
    pub(super) run: Run,
    pub(super) watch: &'a Watch<'a>,
}

impl Search<'_> {
    /// All remedies found for the loop of `scene`.
    pub(super) fn remedies(&self, scene: &Scene) -> Vec<Remedy> {
        let Ok(bare) = (Draft { stabilizer: None, ..scene.to_draft() }).check() else {
            return Vec::new();
        };
        let plain = [
            exactly(&bare, self),
            softer(&bare, self),
            faster(&bare, self),
            damped_device(&bare, self),
            damped_environment(&bare, self),
        ];
        plain.into_iter().flatten().chain(stabilized(&bare, self)).collect()
    }

    fn is_stopped(&self) -> bool {
        (self.watch)(0).is_break()
    }

    /// The changes that made `scene`, if its run reaches the goal.
    fn tried(&self, scene: Scene, changes: Vec<(String, Change)>) -> Option<Remedy> {
        if self.is_stopped() {
            return None;
        }
        let trial = (self.run)(&scene, &|verdict| self.goal.is_reached(verdict), self.watch);
        let trial = trial.filter(|trial| trial.moved != self.own)?;
        let Trial { verdict, feel: Feel { peak, error }, .. } = trial;
        Some(Remedy { changes, scene, verdict, peak_force: peak, force_error: error })
    }
}

/// The exact motion in place of an integrator's.
fn exactly(scene: &Scene, search: &Search<'_>) -> Option<Remedy> {
    let exact = Draft { integrator: Integrator::Exact, ..scene.to_draft() };
    let change = vec![("integrator".to_owned(), Change::Word("exact"))];
    (scene.integrator != Integrator::Exact).then_some(())?;
    search.tried(exact.check().ok()?, change)
}

/// The largest stiffness whose loop holds.
fn softer(scene: &Scene, search: &Search<'_>) -> Option<Remedy> {
    let own = scene.environment.kind().impedance()?.stiffness;
    let limit = LinearPart::of(scene).ok().and_then(|part| part.stable_stiffness());
    let most = match limit {
        Some([from, most]) if most * MARGIN > from => most * MARGIN,
        Some(_) => return None,
        None if LinearPart::of(scene).is_ok() => return None,
        None => own / FURTHER,
    };
    let (tree, name) = (toml::Value::try_from(scene).ok()?, scene.environment.name());
    let trials = (0..TRIALS).map(|trial| rounded_down(most / FURTHER.powi(trial)));
    trials.filter(|stiffness| *stiffness < own && *stiffness > 0.0).find_map(|stiffness| {
        let softer = scene.remade(&with(tree.clone(), name, "stiffness", stiffness)?).ok()?;
        let key = format!("environment.{name}.stiffness");
        search.tried(softer, vec![(key, Change::Number(stiffness))])
    })
}

/// The tree of a scene with another number of its environment; none where it is no single number, as the stiffness of layers.
fn with(mut tree: toml::Value, name: &str, key: &str, number: f64) -> Option<toml::Value> {
    let written = tree.get_mut("environment")?.get_mut(name)?.get_mut(key)?;
    written.as_float()?;
    *written = number.into();
    Some(tree)
}

/// The lowest rate at which the loop holds: the environment's, and if that already is the servo's, both.
fn faster(scene: &Scene, search: &Search<'_>) -> Option<Remedy> {
    let at = |servo: f64, ratio: u64| {
        let mut faster = scene.to_draft();
        faster.servo_rate = Positive::new(servo).ok()?;
        faster.environment_rate =
            if ratio > 1 { Some(Positive::new(servo / ratio as f64).ok()?) } else { None };
        faster.check().ok()
    };
    let own = scene.servo_rate.get();
    // One by one where they are few, and by a sixteenth where the environment takes thousands of ticks.
    let next = |ratio: &u64| (*ratio > 1).then(|| (ratio - ratio / 16).min(ratio - 1));
    let ratios = iter::successors(Some(scene.environment_ratio()), next).skip(1);
    for ratio in ratios {
        if search.is_stopped() {
            return None;
        }
        let Some(faster) = at(own, ratio) else { continue };
        let rate = if ratio > 1 { own / ratio as f64 } else { own };
        let change = vec![("environment_rate".to_owned(), Change::Number(rate))];
        if decays(&faster)
            && let Some(found) = search.tried(faster, change)
        {
            return Some(found);
        }
    }
    let holds = |factor: f64| at(own * factor, 1).is_some_and(|scene| decays(&scene));
    let least = lowest(holds, FASTER)?;
    (0..FASTER_TRIALS).find_map(|trial| {
        let rate = rounded_up(own * least / MARGIN * FURTHER.powi(trial));
        let mut changes = vec![("servo_rate".to_owned(), Change::Number(rate))];
        if scene.environment_rate.is_some() {
            changes.push(("environment_rate".to_owned(), Change::Number(rate)));
        }
        search.tried(at(rate, 1)?, changes)
    })
}

/// The least damping of the environment with which the linear part of a loop holds and its run settles: a plant that bounces on a
/// damper is driven by it.
fn damped_environment(scene: &Scene, search: &Search<'_>) -> Option<Remedy> {
    LinearPart::of(scene).ok()?;
    let (tree, name) = (toml::Value::try_from(scene).ok()?, scene.environment.name());
    let own = tree.get("environment")?.get(name)?.get("damping")?.as_float()?;
    let at = |damping: f64| scene.remade(&with(tree.clone(), name, "damping", damping)?).ok();
    let search = Search { goal: Goal::Settled, ..*search };
    damped(scene, &search, format!("environment.{name}.damping"), own, at)
}

/// The least damping of the device with which the loop holds.
fn damped_device(scene: &Scene, search: &Search<'_>) -> Option<Remedy> {
    let at = |damping: f64| {
        let mut damped = scene.to_draft();
        damped.device.damping = NonNegative::new(damping).ok()?;
        damped.check().ok()
    };
    damped(scene, search, "device.damping".to_owned(), scene.device.damping.get(), at)
}

/// The least damping above its `own` with which the scene `at` it holds.
fn damped(
    scene: &Scene,
    search: &Search<'_>,
    key: String,
    own: f64,
    at: impl Fn(f64) -> Option<Scene>,
) -> Option<Remedy> {
    // Starts from zero damping too: a share of the damping that stops the mass within a period.
    let unit = 1e-6 * scene.port_mass() / scene.period();
    let holds = |factor: f64| at(own + unit * (factor - 1.0)).is_some_and(|scene| decays(&scene));
    let least = own + unit * (lowest(holds, 1e12)? - 1.0);
    (0..TRIALS).find_map(|trial| {
        let damping = rounded_up(least / MARGIN * FURTHER.powi(trial));
        search.tried(at(damping)?, vec![(key.clone(), Change::Number(damping))])
    })
}

/// Each stabilizer with which the loop holds, with the largest of some damping limits.
fn stabilized(scene: &Scene, search: &Search<'_>) -> Vec<Remedy> {
    let ledger = Ledger::default();
    let popc = |cap| Stabilizer::Popc(Popc { work: Work::Held, ledger, damping_cap: Some(cap) });
    let lolc = |cap| {
        let (work, candidate, damping_cap) = (Work::Held, Candidate::DeviceDamping, Some(cap));
        Stabilizer::Lolc(Lolc { work, candidate, ledger, damping_cap })
    };
    let named =
        |key: &str, cap: f64| (format!("stabilizer.{key}.damping_cap"), Change::Number(cap));
    let tried = |key: &'static str, make: &dyn Fn(Cap) -> Stabilizer| {
        let default = rounded_down(scene.default_cap());
        let below = CAPS.into_iter().filter(|cap| *cap < default);
        iter::once(default).chain(below).find_map(|cap| {
            let stabilizer = Some(make(Cap::new(cap).ok()?));
            let mut changes = vec![named(key, cap)];
            if key == "lolc" {
                let word = Change::Word("device-damping");
                changes.push(("stabilizer.lolc.candidate".to_owned(), word));
            }
            let draft = Draft { stabilizer, ..scene.to_draft() };
            search.tried(draft.check().ok()?, changes)
        })
    };
    [tried("popc", &popc), tried("lolc", &lolc)].into_iter().flatten().collect()
}

/// Whether the linear part of a scene decays; without a linear part the run has to decide.
fn decays(scene: &Scene) -> bool {
    LinearPart::of(scene).map_or(true, |part| part.spectral_radius() < 1.0)
}

/// The lowest factor from 1 to `most` that holds, by doubling and halving.
fn lowest(holds: impl Fn(f64) -> bool, most: f64) -> Option<f64> {
    let mut low = 1.0;
    let mut high = 1.0;
    while !holds(high) {
        (low, high) = (high, 2.0 * high);
        if high > most {
            return None;
        }
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if holds(middle) { high = middle } else { low = middle }
    }
    Some(high)
}

/// `value` rounded down to three digits.
fn rounded_down(value: f64) -> f64 {
    rounded(value, f64::floor)
}

fn rounded_up(value: f64) -> f64 {
    rounded(value, f64::ceil)
}

fn rounded(value: f64, by: fn(f64) -> f64) -> f64 {
    if !(value > 0.0 && value.is_finite()) {
        return value;
    }
    let power = 2 - libm::log10(value).floor() as i32;
    let digits = if power >= 0 { value * 10f64.powi(power) } else { value / 10f64.powi(-power) };
    let whole = by(digits);
    if power >= 0 { whole / 10f64.powi(power) } else { whole * 10f64.powi(-power) }
}
