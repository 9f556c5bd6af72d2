//! Settings that a scene may be computed with.

use crate::files::scene::{
    self, Draft, Integrator, Ledger, Positive, Scene, Stabilizer, StepsPerTick,
};

/// Equal steps per tick.
const STEPS: [i64; 7] = [1, 2, 5, 10, 20, 50, 100];

/// Tolerances of adaptive methods; `f32` gets those that it can keep.
const TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// The least tolerance for `f32`.
const LEAST_IN_SINGLE: f64 = 1e-6;

/// Numbers that a loop computes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// Single precision.
    F32,
    /// Single precision, with a ledger in double.
    F32WithWideLedger,
    /// Double precision.
    F64,
}

impl Number {
    /// The name in one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F32WithWideLedger => "f32+f64",
            Self::F64 => "f64",
        }
    }

    fn scalar(self) -> scene::Scalar {
        match self {
            Self::F32 | Self::F32WithWideLedger => scene::Scalar::F32,
            Self::F64 => scene::Scalar::F64,
        }
    }

    fn ledger(self) -> Ledger {
        match self {
            Self::F32WithWideLedger => Ledger::Wide,
            Self::F32 | Self::F64 => Ledger::Plain,
        }
    }
}

/// Propagator with its step or tolerance, and the numbers that the loop computes in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// The method that moves the plant.
    pub integrator: Integrator,
    /// The numbers that the loop computes in.
    pub number: Number,
}

impl Setting {
    /// Every setting that `scene` can have, with the scene computed that way; a ledger of its own only where there is a
    /// stabilizer.
    pub(super) fn all(scene: &Scene) -> Vec<(Self, Scene)> {
        let numbers = [Number::F64, Number::F32, Number::F32WithWideLedger];
        let numbers = &numbers[..if has_ledger(scene) { 3 } else { 2 }];
        let of = |&number: &Number| {
            integrators(number).into_iter().map(move |integrator| Self { integrator, number })
        };
        let all = numbers.iter().flat_map(of);
        all.filter_map(|setting| Some((setting, setting.put_on(scene).check().ok()?))).collect()
    }

    /// `scene` computed with this setting.
    fn put_on(self, scene: &Scene) -> Draft {
        let stabilizer = scene.stabilizer.map(|stabilizer| match stabilizer {
            Stabilizer::Popc(popc) => {
                Stabilizer::Popc(scene::Popc { ledger: self.number.ledger(), ..popc })
            }
            Stabilizer::Lolc(lolc) => {
                Stabilizer::Lolc(scene::Lolc { ledger: self.number.ledger(), ..lolc })
            }
            other => other,
        });
        let (scalar, integrator) = (self.number.scalar(), self.integrator);
        Draft { scalar, integrator, stabilizer, ..scene.to_draft() }
    }

    /// Steps or tolerance in one word.
    pub(super) fn detail(self) -> String {
        match (self.integrator.steps_per_tick(), self.integrator.tolerance()) {
            (Some(1), _) => "1 step".to_owned(),
            (Some(steps), _) => format!("{steps} steps"),
            (_, Some(tolerance)) => format!("{tolerance:e}"),
            (None, None) => "-".to_owned(),
        }
    }

    /// The keys of a scene file that ask for this setting on `scene`, in their tables.
    pub(super) fn keys(self, scene: &Scene) -> String {
        let Self { integrator, number } = self;
        let mut keys = format!("integrator = \"{}\"\n", integrator.name());
        if let Some(steps) = integrator.steps_per_tick() {
            keys += &format!("steps_per_tick = {steps}\n");
        }
        if let Some(tolerance) = integrator.tolerance() {
            keys += &format!("tolerance = {tolerance:e}\n");
        }
        let single = number.scalar() == scene::Scalar::F32;
        keys += &format!("scalar = \"{}\"\n", if single { "f32" } else { "f64" });
        let table = match scene.stabilizer {
            Some(Stabilizer::Popc(_)) => "popc",
            Some(Stabilizer::Lolc(_)) => "lolc",
            _ => return keys,
        };
        let ledger = if number.ledger() == Ledger::Wide { "wide" } else { "plain" };
        keys + &format!("# and in [stabilizer.{table}]:\nledger = \"{ledger}\"\n")
    }
}

/// Whether the stabilizer of `scene` has a ledger to choose.
fn has_ledger(scene: &Scene) -> bool {
    matches!(scene.stabilizer, Some(Stabilizer::Popc(_) | Stabilizer::Lolc(_)))
}

fn integrators(number: Number) -> Vec<Integrator> {
    let mut all = vec![Integrator::Exact];
    for steps in STEPS.into_iter().filter_map(|steps| StepsPerTick::new(steps).ok()) {
        all.push(Integrator::SemiImplicitEuler { steps_per_tick: steps });
        all.push(Integrator::ImplicitMidpoint { steps_per_tick: steps });
        all.push(Integrator::Rk4 { steps_per_tick: steps });
    }
    let least = if number.scalar() == scene::Scalar::F32 { LEAST_IN_SINGLE } else { 0.0 };
    let kept = TOLERANCES.into_iter().filter(|&tolerance| tolerance >= least);
    for tolerance in kept.filter_map(|tolerance| Positive::new(tolerance).ok()) {
        all.push(Integrator::Dopri5 { tolerance });
        all.push(Integrator::Dop853 { tolerance });
    }
    all
}
