//! What helps, tried before it is told.

use crate::files::scene::{
    Candidate, Cap, Draft, Ledger, Lolc, NonNegative, Popc, Positive, Scene, Stabilizer, Work,
};
use crate::measure::LinearPart;
use crate::measure::balance::{Feel, Trial};
use crate::simulate::Space;

/// How far inside of a limit a remedy stays.
const MARGIN: f64 = 0.95;

/// How much further each trial goes than the last.
const FURTHER: f64 = 1.25;

/// Trials before a remedy is given up.
const TRIALS: i32 = 24;

/// Halvings of an interval that is searched by formula.
const HALVINGS: u32 = 40;

/// How many times faster a servo may become, and how often that is tried: its runs are as much longer.
const FASTER: f64 = 64.0;
const FASTER_TRIALS: i32 = 5;

/// The damping limits a stabilizer is tried with, of m / T, the default first.
const CAPS: [f64; 5] = [0.5, 0.25, 0.1, 0.05, 0.02];

/// A change of a scene after which its run is bounded.
#[derive(Clone, Debug, PartialEq)]
pub struct Remedy {
    /// The keys of the scene that change, with what they change to.
    pub changes: Vec<(String, Change)>,
    /// The scene with the change; it was run.
    pub scene: Scene,
    /// Largest force on the plant in that run, N.
    pub peak_force: f64,
    /// Root mean square of the force on the plant less that of the environment's own law, in contact, N.
    pub force_error: f64,
}

/// What a key changes to.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// A number, in the unit of the key.
    Number(f64),
    /// A word.
    Word(&'static str),
}

/// All that is found to help the loop of `scene`.
pub(super) fn remedies<V: Space>(scene: &Scene) -> Vec<Remedy> {
    let Ok(bare) = (Draft { stabilizer: None, ..scene.to_draft() }).check() else {
        return Vec::new();
    };
    let found = [softer::<V>(&bare), faster::<V>(&bare), damped::<V>(&bare)];
    found.into_iter().flatten().chain(stabilized::<V>(&bare)).collect()
}

fn remedy<V: Space>(scene: Scene, changes: Vec<(String, Change)>) -> Option<Remedy> {
    let Feel { peak, error } = Trial::that_holds::<V>(&scene)?.feel;
    Some(Remedy { changes, scene, peak_force: peak, force_error: error })
}

/// The largest stiffness that holds.
fn softer<V: Space>(scene: &Scene) -> Option<Remedy> {
    let own = scene.environment.kind().impedance()?.stiffness;
    let limit = LinearPart::of(scene).ok().and_then(|part| part.stable_stiffness());
    let most = match limit {
        Some([from, most]) if most * MARGIN > from => most * MARGIN,
        Some(_) => return None,
        None if LinearPart::of(scene).is_ok() => return None,
        None => own / FURTHER,
    };
    let trials = (0..TRIALS).map(|trial| rounded_down(most / FURTHER.powi(trial)));
    trials.filter(|stiffness| *stiffness < own && *stiffness > 0.0).find_map(|stiffness| {
        let mut softer = scene.to_draft();
        softer.environment.kind_mut().set_stiffness(stiffness)?;
        let key = format!("environment.{}.stiffness", softer.environment.name());
        remedy::<V>(softer.check().ok()?, vec![(key, Change::Number(stiffness))])
    })
}

/// The lowest rate that holds: the environment's, and where that is the servo's already, both.
fn faster<V: Space>(scene: &Scene) -> Option<Remedy> {
    let at = |servo: f64, ratio: u64| {
        let mut faster = scene.to_draft();
        faster.servo_rate = Positive::new(servo).ok()?;
        faster.environment_rate =
            if ratio > 1 { Some(Positive::new(servo / ratio as f64).ok()?) } else { None };
        faster.check().ok()
    };
    let own = scene.servo_rate.get();
    let ratios = (1..scene.environment_ratio()).rev();
    for ratio in ratios {
        let Some(faster) = at(own, ratio) else { continue };
        let rate = if ratio > 1 { own / ratio as f64 } else { own };
        let change = vec![("environment_rate".to_owned(), Change::Number(rate))];
        if decays(&faster)
            && let Some(found) = remedy::<V>(faster, change)
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
        remedy::<V>(at(rate, 1)?, changes)
    })
}

/// The least damping of the device that holds.
fn damped<V: Space>(scene: &Scene) -> Option<Remedy> {
    let own = scene.device.damping.get();
    // From nothing too: a share of what stops the mass within a period.
    let unit = 1e-6 * scene.port_mass() / scene.period();
    let at = |damping: f64| {
        let mut damped = scene.to_draft();
        damped.device.damping = NonNegative::new(damping).ok()?;
        damped.check().ok()
    };
    let holds = |factor: f64| at(own + unit * (factor - 1.0)).is_some_and(|scene| decays(&scene));
    let least = own + unit * (lowest(holds, 1e12)? - 1.0);
    (0..TRIALS).find_map(|trial| {
        let damping = rounded_up(least / MARGIN * FURTHER.powi(trial));
        remedy::<V>(at(damping)?, vec![("device.damping".to_owned(), Change::Number(damping))])
    })
}

/// Each stabilizer that holds, with the largest of some damping limits.
fn stabilized<V: Space>(scene: &Scene) -> Vec<Remedy> {
    let ledger = Ledger::default();
    let popc = |damping_cap| Stabilizer::Popc(Popc { work: Work::Held, ledger, damping_cap });
    let lolc = |damping_cap| {
        let candidate = Candidate::DeviceDamping;
        Stabilizer::Lolc(Lolc { work: Work::Held, candidate, ledger, damping_cap })
    };
    let named =
        |key: &str, cap: f64| (format!("stabilizer.{key}.damping_cap"), Change::Number(cap));
    let with = |key: &'static str, make: &dyn Fn(Cap) -> Stabilizer| {
        CAPS.into_iter().find_map(|cap| {
            let stabilizer = Some(make(Cap::new(cap).ok()?));
            let mut changes = vec![named(key, cap)];
            if key == "lolc" {
                let word = Change::Word("device-damping");
                changes.push(("stabilizer.lolc.candidate".to_owned(), word));
            }
            let draft = Draft { stabilizer, ..scene.to_draft() };
            remedy::<V>(draft.check().ok()?, changes)
        })
    };
    [with("popc", &popc), with("lolc", &lolc)].into_iter().flatten().collect()
}

/// Whether the linear part of a scene decays; where there is none the run has to tell.
fn decays(scene: &Scene) -> bool {
    LinearPart::of(scene).map_or(true, |part| part.spectral_radius() < 1.0)
}

/// The lowest factor from 1 on that holds, within `most`, by doubling and halving.
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

/// To three digits.
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
