//! Scenes with each effect, alone and together.

use super::{CostsError, timing};
use crate::files::Scene;
use crate::files::scene::{Draft, Effects};

/// A hand that runs into a wall at 0.1 m/s, 1 kHz over 100 Hz, under POPC.
const LOOP: &str = "duration = 1.0
servo_rate = 1000.0
environment_rate = 100.0
operator.mass = 0.1
operator.damping = 0.2
operator.stiffness = 50.0
device = { mass = 0.2, damping = 0.001 }
stabilizer.popc = {}
";

const START: &str = "initial = { position = -0.001, velocity = 0.1 }\n";

const WALL: &str = "environment.wall = { stiffness = 2000.0, damping = 1.0 }\n";

/// Tables that go together, and whose time hardly depends on the motion.
const TOGETHER: [(&str, &str); 11] = [
    ("encoder", "effects.encoder = { resolution = 1e-5 }"),
    ("delay", "effects.delay = { ticks = 2 }"),
    ("saturation", "effects.saturation = { force = 8.0 }"),
    (CUTOFF, "effects.filter = { cutoff = 200.0 }"),
    ("noise", "effects.noise = { deviation = 2e-6, seed = 7 }"),
    ("dropout", "effects.dropout = { probability = 0.1, seed = 7, policy = \"hold\" }"),
    ("load", "effects.load = { force = 0.2 }"),
    ("pulse", "effects.pulse = { start = 0.1, duration = 0.1, force = 1.0 }"),
    ("link", "link = { stiffness = 2000.0, damping = 1.0 }"),
    (SINE, "operator.motion = { kind = \"sine\", amplitude = 0.002, frequency = 2.0 }"),
    ("grip", "operator.grip = { times = [0.1], stiffness = [100.0], damping = [0.4] }"),
];

/// Tables that join those above but are not among the others of any effect: they take microseconds (friction as many as
/// the motion has events), which would hide any nanosecond.
const LONG: [(&str, &str); 2] = [
    ("jitter", "effects.jitter = { deviation = 2e-5, seed = 7 }"),
    ("friction", "effects.friction = { coulomb = 0.05, static = 0.08, stribeck_velocity = 0.01 }"),
];

const CUTOFF: &str = "filter, cutoff";

const SINE: &str = "motion, sine";

/// Other kinds of an effect, each with the effect that it replaces.
const OTHERS: [(&str, &str, &str); 3] = [
    ("filter, window", "effects.filter = { window = 16 }", CUTOFF),
    ("motion, step", "operator.motion = { kind = \"step\", at = 0.1, to = 0.002 }", SINE),
    (
        "motion, ramp",
        "operator.motion = { kind = \"ramp\", at = 0.1, to = 0.002, rate = 0.01 }",
        SINE,
    ),
];

/// Environments that replace the wall.
const ENVIRONMENTS: [(&str, &str); 6] = [
    ("spring", "environment.spring = { stiffness = 500.0 }"),
    (
        "mass-spring-damper",
        "environment.mass-spring-damper = { mass = 0.01, damping = 1.0, stiffness = 500.0 }",
    ),
    (
        "layered wall",
        "environment.layered-wall = { depth = 0.001, stiffness = [1000.0, 2000.0], damping = 1.0 }",
    ),
    (
        "Hunt-Crossley",
        "environment.hunt-crossley = { stiffness = 5e4, exponent = 1.5, damping = 0.5 }",
    ),
    (
        "moving wall",
        "environment.moving-wall = { stiffness = 2000.0, damping = 1.0, amplitude = 0.001, frequency = 2.0 }",
    ),
    (
        "varying spring",
        "environment.varying-spring = { stiffness = 500.0, amplitude = 100.0, frequency = 2.0 }",
    ),
];

/// Spaces of several axes.
const SPACES: [(&str, &str); 4] = [
    (
        "plane, 2 axes",
        "space.dimensions = 2
operator.rest = [0.0, 0.0]
initial = { position = [-0.001, 0.0], velocity = [0.1, 0.0] }
environment.plane = { point = [0.0, 0.0], normal = [-1.0, 0.0], stiffness = 2000.0, damping = 1.0 }
",
    ),
    (
        "plane, 3 axes",
        "space.dimensions = 3
operator.rest = [0.0, 0.0, 0.0]
initial = { position = [-0.001, 0.0, 0.0], velocity = [0.1, 0.0, 0.0] }
environment.plane = { point = [0.0, 0.0, 0.0], normal = [-1.0, 0.0, 0.0], stiffness = 2000.0, damping = 1.0 }
",
    ),
    (
        "sphere, 3 axes",
        "space.dimensions = 3
operator.rest = [0.0, 0.0, 0.0]
initial = { position = [-0.001, 0.0, 0.0], velocity = [0.1, 0.0, 0.0] }
environment.sphere = { center = [0.05, 0.0, 0.0], radius = 0.05, stiffness = 2000.0, damping = 1.0 }
",
    ),
    (
        "box, 3 axes",
        "space.dimensions = 3
operator.rest = [0.0, 0.0, 0.0]
initial = { position = [-0.001, 0.0, 0.0], velocity = [0.1, 0.0, 0.0] }
environment.box = { center = [0.05, 0.0, 0.0], half = [0.05, 0.1, 0.1], stiffness = 2000.0, damping = 1.0 }
",
    ),
];

/// A scene without one of its effects.
type Clear = fn(Draft) -> Draft;

/// Every effect that a scene can name, with the scene that lacks it.
const NAMED: &[(&str, Clear)] = &[
    ("encoder", |it| with(&it, Effects { encoder: None, ..it.effects })),
    ("delay", |it| with(&it, Effects { delay: None, ..it.effects })),
    ("saturation", |it| with(&it, Effects { saturation: None, ..it.effects })),
    ("filter", |it| with(&it, Effects { filter: None, ..it.effects })),
    ("noise", |it| with(&it, Effects { noise: None, ..it.effects })),
    ("jitter", |it| with(&it, Effects { jitter: None, ..it.effects })),
    ("dropout", |it| with(&it, Effects { dropout: None, ..it.effects })),
    ("friction", |it| with(&it, Effects { friction: None, ..it.effects })),
    ("load", |it| with(&it, Effects { load: None, ..it.effects })),
    ("pulse", |it| with(&it, Effects { pulse: None, ..it.effects })),
    ("link", |it| Draft { link: None, ..it }),
    ("motion", |mut it| {
        it.operator.motion = None;
        it
    }),
    ("grip", |mut it| {
        it.operator.grip = None;
        it
    }),
];

fn with(scene: &Draft, effects: Effects) -> Draft {
    Draft { effects, ..scene.clone() }
}

/// Effect, and the indices of the loops without and with it.
#[derive(Debug)]
pub(super) struct Effect {
    pub(super) name: &'static str,
    pub(super) alone: [usize; 2],
    pub(super) composed: [usize; 2],
}

/// The index of the loop without any effect.
pub(super) const BARE: usize = 0;

/// All loops that are timed, each once, and the effects computed from them.
#[derive(Debug)]
pub(super) struct Calls {
    /// The first has none of the effects.
    pub(super) all: Vec<Scene>,
    pub(super) effects: Vec<Effect>,
}

impl Calls {
    pub(super) fn new() -> Result<Self, CostsError> {
        let mut calls = Self { all: Vec::new(), effects: Vec::new() };
        calls.place(&format!("{START}{WALL}"), &[])?;
        for (name, table) in TOGETHER {
            calls.joins((name, table), &without(&[name]))?;
        }
        for (name, table, instead) in OTHERS {
            calls.joins((name, table), &without(&[instead]))?;
        }
        for long in LONG {
            calls.joins(long, &without(&[]))?;
        }
        for (name, environment) in ENVIRONMENTS {
            calls.stands_for_the_wall(name, &format!("{START}{environment}\n"))?;
        }
        for (name, space) in SPACES {
            calls.stands_for_the_wall(name, space)?;
        }
        Ok(calls)
    }

    /// The loops of the effects that `scene` names: each alone, and among all others.
    pub(super) fn of(scene: &Scene) -> Result<Self, CostsError> {
        let whole = scene.to_draft();
        let bare = NAMED.iter().fold(whole.clone(), |bare, (_, clear)| clear(bare));
        let mut calls = Self { all: Vec::new(), effects: Vec::new() };
        calls.seat(bare.check()?);
        let all = calls.seat(whole.clone().check()?);
        for (name, clear) in NAMED {
            let without = clear(whole.clone());
            if without == whole {
                continue;
            }
            let others = NAMED.iter().filter(|(other, _)| other != name);
            let only = others.fold(whole.clone(), |only, (_, clear)| clear(only));
            let alone = [BARE, calls.seat(only.check()?)];
            let composed = [calls.seat(without.check()?), all];
            calls.effects.push(Effect { name, alone, composed });
        }
        Ok(calls)
    }

    /// The loops on a line, which lanes can run, and the effects that they tell: those in a space come last.
    pub(super) fn on_a_line(&self) -> (&[Scene], impl Iterator<Item = &Effect>) {
        let in_space = |scene: &Scene| scene.dimensions() > 1;
        let line = self.all.iter().position(in_space).unwrap_or(self.all.len());
        let told = move |it: &&Effect| it.alone.iter().chain(&it.composed).all(|at| *at < line);
        (&self.all[..line], self.effects.iter().filter(told))
    }

    /// The number of loops that are timed, once by themselves and once on lanes.
    pub(super) fn rounds(&self) -> usize {
        (timing::ROUNDS + 1) * (self.all.len() + self.on_a_line().0.len())
    }

    /// The index of the loop of `scene`; adds the loop if it is not there.
    fn seat(&mut self, scene: Scene) -> usize {
        self.all.iter().position(|seated| *seated == scene).unwrap_or_else(|| {
            self.all.push(scene);
            self.all.len() - 1
        })
    }

    /// Adds an effect that joins `others`.
    fn joins(
        &mut self,
        (name, table): (&'static str, &'static str),
        others: &[&str],
    ) -> Result<(), CostsError> {
        let walled = format!("{START}{WALL}");
        let all: Vec<&str> = others.iter().copied().chain([table]).collect();
        let alone = [BARE, self.place(&walled, &[table])?];
        let composed = [self.place(&walled, others)?, self.place(&walled, &all)?];
        self.effects.push(Effect { name, alone, composed });
        Ok(())
    }

    /// Adds an effect that replaces the wall: its cost is the difference to the wall's.
    fn stands_for_the_wall(&mut self, name: &'static str, world: &str) -> Result<(), CostsError> {
        let (walled, others) = (format!("{START}{WALL}"), without(&[]));
        let alone = [BARE, self.place(world, &[])?];
        let composed = [self.place(&walled, &others)?, self.place(world, &others)?];
        self.effects.push(Effect { name, alone, composed });
        Ok(())
    }

    /// The index of the loop in `world` with `tables`; adds the loop if it is not there.
    fn place(&mut self, world: &str, tables: &[&str]) -> Result<usize, CostsError> {
        let text = format!("{LOOP}{world}{}\n", tables.join("\n"));
        Ok(self.seat(Scene::parse(&text, "a scene of the costs")?))
    }
}

/// All tables that go together, except those of these names.
fn without(names: &[&str]) -> Vec<&'static str> {
    let others = TOGETHER.iter().filter(|(name, _)| !names.contains(name));
    others.map(|(_, table)| *table).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::scene::Effects;

    #[test]
    fn every_effect_of_a_scene_has_a_price() {
        let keys = serde_json::to_value(Effects::default()).unwrap();
        let tables = || TOGETHER.iter().chain(&LONG);
        for key in keys.as_object().unwrap().keys() {
            assert!(
                tables().any(|(_, table)| table.starts_with(&format!("effects.{key} ="))),
                "{key}"
            );
        }
    }

    #[test]
    fn a_loop_is_compared_with_the_same_less_one_effect() {
        let calls = Calls::new().unwrap();
        assert_eq!(
            calls.effects.len(),
            TOGETHER.len() + LONG.len() + OTHERS.len() + ENVIRONMENTS.len() + SPACES.len()
        );
        let names = |at: usize| calls.all[at].effects;
        let encoder = &calls.effects[0];
        let [without, with] = encoder.composed.map(names);
        assert!(without.encoder.is_none() && with.encoder.is_some());
        assert_eq!(Effects { encoder: None, ..with }, without);
        assert!(with.noise.is_some() && with.jitter.is_none());
        let [bare, alone] = encoder.alone.map(names);
        assert_eq!(bare, Effects::default());
        assert_eq!(Effects { encoder: None, ..alone }, bare);
    }
}
