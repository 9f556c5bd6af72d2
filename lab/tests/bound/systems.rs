//! Random scenes with a linear loop.

use lyapunov_lab::Scene;
use lyapunov_lab::scene::{Environment, Finite, NonNegative};

/// Generator of numbers that are the same on every machine (Steele, Lea and Flood, OOPSLA 2014).
pub(crate) struct Chance(u64);

impl Chance {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// A number from `low` to `high`, uniform in its logarithm.
    pub(crate) fn decades(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.share())
    }

    pub(crate) fn whole(&mut self, low: u64, high: u64) -> u64 {
        low + self.bits() % (high - low + 1)
    }

    pub(crate) fn happens(&mut self, probability: f64) -> bool {
        self.share() < probability
    }
}

pub(crate) fn scene(text: &str) -> Scene {
    Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}\n{text}"))
}

/// Features that a random scene may have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    pub(crate) slowest: u64,
    pub(crate) delay: u64,
    pub(crate) link: bool,
    pub(crate) exact: bool,
    pub(crate) damping: bool,
}

/// A random scene with a two-sided environment of stiffness 1.
pub(crate) fn random(chance: &mut Chance, kind: Kind) -> Scene {
    let rate = chance.decades(50.0, 5000.0);
    let ratio = if chance.happens(0.5) { 1 } else { chance.whole(1, kind.slowest) };
    let mass = chance.decades(0.02, 5.0);
    // Damping in units of the mass over the environment's period: such a loop dissipates within a few thousand ticks.
    let unit = mass * rate / ratio as f64;
    let share = |chance: &mut Chance| chance.decades(0.02, 1.0);
    let mut text = format!("duration = 1\nservo_rate = {rate}\n");
    if ratio > 1 {
        text += &format!("environment_rate = {}\n", rate / ratio as f64);
    }
    text += &format!("device = {{ mass = {mass}, damping = {} }}\n", unit * share(chance));
    let linked = kind.link && chance.happens(0.3);
    let hand = if linked || chance.happens(0.5) { mass * chance.decades(0.1, 10.0) } else { 0.0 };
    let spring = if chance.happens(0.6) {
        unit * rate / ratio as f64 * chance.decades(1e-4, 0.3)
    } else {
        0.0
    };
    let grip = unit * share(chance);
    text += &format!("operator = {{ mass = {hand}, damping = {grip}, stiffness = {spring} }}\n");
    if linked {
        let stiffness = unit * rate / ratio as f64 * chance.decades(1e-2, 10.0);
        let damping = unit * share(chance);
        text += &format!("link = {{ stiffness = {stiffness}, damping = {damping} }}\n");
    }
    if kind.exact && chance.happens(0.3) {
        text += "velocity = \"exact\"\n";
    } else if chance.happens(0.4) {
        text += &format!("effects.filter.cutoff = {}\n", rate * chance.decades(0.03, 3.0));
    }
    if chance.happens(0.6) {
        text += &format!("effects.delay.ticks = {}\n", chance.whole(0, kind.delay));
    }
    let damping =
        if kind.damping && chance.happens(0.7) { 0.5 * unit * share(chance) } else { 0.0 };
    let inertia =
        if kind.damping && chance.happens(0.1) { mass * 0.1 * chance.share() } else { 0.0 };
    text += &format!(
        "environment.mass-spring-damper = {{ stiffness = 1, damping = {damping}, mass = {inertia} }}\n"
    );
    scene(&text)
}

/// The same scene with another stiffness.
pub(crate) fn stiffened(scene: &Scene, stiffness: f64) -> Scene {
    let mut draft = scene.to_draft();
    match &mut draft.environment {
        Environment::MassSpringDamper(it) => it.stiffness = NonNegative::new(stiffness).unwrap(),
        Environment::Spring(it) => it.stiffness = Finite::new(stiffness).unwrap(),
        other => panic!("{other:?}"),
    }
    draft.check().unwrap_or_else(|conflict| panic!("{conflict}"))
}
