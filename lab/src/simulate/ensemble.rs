//! Ensemble of scenes: a scene with the numbers moved that nobody knows exactly.

use lyapunov::Plant;
use lyapunov::effects::{Random, Source};
use serde::Serialize;

use super::building::{Scenes, Space, in_space};
use crate::files::Scene;
use crate::files::scene::{
    Conflict, Draft, Effects, Finite, Initial, Integrator, NonNegative, Operator, Positive, Scalar,
    Seed,
};

/// Draws that every member has: more than there are numbers to move.
const DRAWS: u64 = 64;

/// The first of the quantities that seeds of random effects are drawn by, behind those of [`Constant`].
const SEEDS: u64 = 8;

/// The values of a uniform number, which has 53 bits.
const DIGITS: f64 = (1u64 << 53) as f64;

/// A number of a scene that an ensemble moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constant {
    /// The phase of the clock.
    Phase = 0,
    /// The operator's mass.
    OperatorMass = 1,
    /// The device's mass.
    DeviceMass = 2,
    /// The operator's damping.
    OperatorDamping = 3,
    /// The device's damping.
    DeviceDamping = 4,
    /// The stiffness of the operator's spring.
    OperatorStiffness = 5,
    /// The link's damping.
    LinkDamping = 6,
    /// The link's stiffness.
    LinkStiffness = 7,
}

/// How far an ensemble moves the numbers of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Moves {
    /// The largest delay of the first tick, in periods of the environment: 1 moves the clock over a whole tick of it.
    pub phase: f64,
    /// The largest change of each mass, as a share of it, below 1.
    pub mass: f64,
    /// The same of each damping.
    pub damping: f64,
    /// The same of each stiffness of operator and link.
    pub stiffness: f64,
}

impl Moves {
    /// Nothing moves.
    pub const NONE: Self = Self { phase: 0.0, mass: 0.0, damping: 0.0, stiffness: 0.0 };

    /// The moves that members of `scene` make: without the phase where a scene [starts as it is](Ensemble).
    pub fn of(self, scene: &Draft) -> Self {
        Self { phase: if starts_as_it_is(scene) { 0.0 } else { self.phase }, ..self }
    }
}

fn starts_as_it_is(scene: &Draft) -> bool {
    scene.link.is_some() || scene.operator.motion.is_some()
}

impl Default for Moves {
    /// The clock over a whole tick, everything else by 10 %.
    fn default() -> Self {
        Self { phase: 1.0, mass: 0.1, damping: 0.1, stiffness: 0.1 }
    }
}

/// Scenes around a scene, numbered from 0: each has its numbers moved by independent uniform random numbers.
///
/// A member is a function of scene, seed and number, so members can be made in any order and on any thread; one number
/// that moves less or not at all leaves the others as they are. Random effects get new seeds, which follow from the seeds of
/// ensemble and scene and the member's number.
/// The environment is left alone, since it is what is asked about; so are the stabilizer, the hand's motion and the
/// duration.
///
/// **The clock's phase.** The plant is released at `t = 0`, and the first tick comes `phase · r T` later, `r T` being
/// the environment's period: a member starts where the plant's exact free motion has got to by then. That is the same
/// run with the clock moved wherever the environment does not push at the start, since a clock that ran before the
/// release would then have held no force. Where it pushes at the start, the computer is switched on that much later.
/// The first sample reports no displacement, as every first sample. What goes by ticks (a grip, a pulse, a moving
/// environment) goes with the clock. A scene whose hand is led starts as it is, since the hand moves at ticks, and so does
/// one with a link, since a scene has one start for both masses.
///
/// ```
/// use lyapunov_lab::{Ensemble, Moves, Scene};
/// let scene = Scene::parse(
///     "duration = 1.0\nservo_rate = 100.0\ndevice.mass = 0.2\noperator.stiffness = 50.0\n\
///      initial.position = -0.004\nenvironment.wall.stiffness = 8000.0\n",
///     "tap.toml",
/// )?;
/// let ensemble = Ensemble { seed: 1, moves: Moves::default() };
/// let members: Vec<Scene> = (0..100).map(|member| ensemble.member(&scene, member)).collect::<Result<_, _>>()?;
/// assert!(members.iter().all(|member| (member.device.mass.get() / 0.2 - 1.0).abs() <= 0.1));
/// assert!(members.iter().all(|member| member.initial.position.get() >= -0.004));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ensemble {
    /// Seed of all random numbers.
    pub seed: u64,
    /// How far the numbers move.
    pub moves: Moves,
}

impl Ensemble {
    /// The scene with this number.
    ///
    /// # Errors
    /// A moved number that the scene does not allow, as where a share of [`Moves`] is not below 1.
    pub fn member(&self, scene: &Draft, member: u64) -> Result<Scene, Conflict> {
        let mut draft = scene.clone();
        self.move_parts(&mut draft, member)?;
        self.draw_seeds(&mut draft.effects, member);
        let waited = self.moves.phase * self.drawn(member, Constant::Phase);
        let period = draft.environment_ratio() as f64 * draft.period();
        draft.initial = released(&draft, waited * period)?;
        draft.check()
    }

    /// The uniform number in `[0, 1)` that a member's `constant` is moved by: 0 is the least, 1 the most.
    pub fn drawn(&self, member: u64, constant: Constant) -> f64 {
        self.uniform(member, constant as u64)
    }

    /// The uniform number in `[0, 1)` for `quantity` of a member. Quantities below 16 belong to [`Constant`] and to seeds, those
    /// from there to 63 to whoever moves more than an ensemble does.
    pub(crate) fn uniform(&self, member: u64, quantity: u64) -> f64 {
        let call = member.wrapping_mul(DRAWS).wrapping_add(quantity);
        Random::<f64>::new(|_| self.seed, Source::Ensemble).from_call(call).uniform()
    }

    /// Gives each random effect of a member a seed of its own. One that went by the member's number alone would be the same
    /// under each seed of the ensemble.
    fn draw_seeds(&self, effects: &mut Effects, member: u64) {
        let Effects { noise, jitter, dropout, .. } = effects;
        let seeds = [
            noise.as_mut().map(|it| &mut it.seed),
            jitter.as_mut().map(|it| &mut it.seed),
            dropout.as_mut().map(|it| &mut it.seed),
        ];
        for (quantity, seed) in (SEEDS..).zip(seeds) {
            let drawn = (self.uniform(member, quantity) * DIGITS) as u64;
            let Some(seed) = seed else { continue };
            let moved = (seed.get().wrapping_add(drawn) & i64::MAX as u64) as i64;
            *seed = Seed::new(moved).unwrap_or(*seed);
        }
    }

    fn move_parts(&self, draft: &mut Draft, member: u64) -> Result<(), Conflict> {
        let Moves { mass, damping, stiffness, .. } = self.moves;
        let factor =
            |most: f64, constant: Constant| 1.0 + most * (2.0 * self.drawn(member, constant) - 1.0);
        let of_operator = (
            factor(damping, Constant::OperatorDamping),
            factor(stiffness, Constant::OperatorStiffness),
        );
        let Operator { grip, .. } = &mut draft.operator;
        for grip in grip.iter_mut() {
            scale_all(&mut grip.damping, of_operator.0, "operator.grip.damping")?;
            scale_all(&mut grip.stiffness, of_operator.1, "operator.grip.stiffness")?;
        }
        let Operator { mass: hand, damping: damper, stiffness: spring, .. } = &mut draft.operator;
        scale(hand, factor(mass, Constant::OperatorMass), "operator.mass")?;
        scale(damper, of_operator.0, "operator.damping")?;
        scale(spring, of_operator.1, "operator.stiffness")?;
        let device = &mut draft.device;
        scale(&mut device.mass, factor(mass, Constant::DeviceMass), "device.mass")?;
        scale(&mut device.damping, factor(damping, Constant::DeviceDamping), "device.damping")?;
        if let Some(link) = &mut draft.link {
            scale(&mut link.damping, factor(damping, Constant::LinkDamping), "link.damping")?;
            let factor = factor(stiffness, Constant::LinkStiffness);
            scale(&mut link.stiffness, factor, "link.stiffness")?;
        }
        Ok(())
    }
}

/// Multiplies the number at `key` by `factor`.
fn scale<Q>(quantity: &mut Q, factor: f64, key: &str) -> Result<(), Conflict>
where
    Q: Copy + Into<f64> + TryFrom<f64, Error: std::fmt::Display>,
{
    *quantity = Q::try_from((*quantity).into() * factor).map_err(|error| {
        Conflict::new(key, format!("a moved `{key}` {error}"), "move it by a share below 1")
    })?;
    Ok(())
}

fn scale_all(quantities: &mut [NonNegative], factor: f64, key: &str) -> Result<(), Conflict> {
    quantities.iter_mut().try_for_each(|quantity| scale(quantity, factor, key))
}

/// The start of `draft` after `interval` s of exact motion without environment, pulse and leading hand.
fn released(draft: &Draft, interval: f64) -> Result<Initial, Conflict> {
    let (Ok(duration), Ok(rate)) = (Positive::new(interval), Positive::new(interval.recip()))
    else {
        return Ok(draft.initial.clone());
    };
    if starts_as_it_is(draft) {
        return Ok(draft.initial.clone());
    }
    let alone = Draft {
        duration,
        servo_rate: rate,
        environment_rate: None,
        scalar: Scalar::F64,
        integrator: Integrator::Exact,
        operator: Operator { grip: None, ..draft.operator.clone() },
        effects: Effects {
            friction: draft.effects.friction,
            load: draft.effects.load,
            ..Effects::default()
        },
        ..draft.clone()
    };
    let alone = alone.by_rules()?;
    in_space!(alone, Axes => at_the_end::<Axes>(&alone))
}

/// The state of the plant of `alone` after a period without an effort at its port.
fn at_the_end<V: Space>(alone: &Scene) -> Result<Initial, Conflict> {
    let plant = V::plant(Scenes::of(alone), &Default::default());
    let mut plant = plant.map_err(|error| alone.out_of_range(&error, "f64"))?;
    let sample = plant.advance(V::zero());
    let along = |signal: V| -> Result<Vec<Finite>, Conflict> {
        let axes = (0..V::DIMENSIONS).map(|axis| Finite::new(signal.axis(axis)));
        axes.collect::<Result<_, _>>().map_err(|error| {
            let problem = format!("the place where the first tick finds the plant {error}");
            Conflict::new("initial", problem, "move the clock's phase by less")
        })
    };
    Ok(Initial {
        position: along(sample.position)?.into(),
        velocity: along(sample.velocity)?.into(),
    })
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const SEED: u64 = 5;

    /// A second at 100 Hz on a spring of 50 N/m, 4 mm off a wall; `more` adds keys.
    fn scene(more: &str) -> Scene {
        let usual = "duration = 1.0\nservo_rate = 100.0\ninitial.position = -0.004\n\
            environment.wall.stiffness = 1e3\noperator.stiffness = 50.0\ndevice.mass = 0.3\n";
        Scene::parse(&format!("{usual}{more}"), "test").unwrap_or_else(|fault| panic!("{fault}"))
    }

    fn members(scene: &Scene, moves: Moves, count: u64) -> Vec<Scene> {
        let ensemble = Ensemble { seed: SEED, moves };
        (0..count).map(|member| ensemble.member(scene, member).unwrap()).collect()
    }

    fn phase(member: u64) -> f64 {
        Ensemble { seed: SEED, moves: Moves::NONE }.drawn(member, Constant::Phase)
    }

    #[test]
    fn shares_spread_evenly_about_each_number_and_by_themselves() {
        let own = scene("operator.mass = 2.0\noperator.damping = 3.0\ndevice.damping = 4.0\n");
        let numbers: [fn(&Scene) -> f64; 5] = [
            |it| it.operator.mass.get() / 2.0,
            |it| it.device.mass.get() / 0.3,
            |it| it.operator.damping.get() / 3.0,
            |it| it.device.damping.get() / 4.0,
            |it| it.operator.stiffness.get() / 50.0,
        ];
        let moves = Moves { phase: 0.0, ..Moves::default() };
        let all = members(&own, moves, 1000);
        let shares =
            |number: fn(&Scene) -> f64| all.iter().map(move |it| 10.0 * (number(it) - 1.0));
        for number in numbers {
            assert!(shares(number).all(|share| share.abs() <= 1.0 + 1e-9));
            // A uniform share in [-1, 1] has the mean 0 and the variance 1/3: four standard errors of 1000 of them.
            let mean = shares(number).sum::<f64>() / 1000.0;
            let square = shares(number).map(|it| it * it).sum::<f64>() / 1000.0;
            assert!(mean.abs() < 4.0 * (1.0 / 3000.0_f64).sqrt(), "{mean}");
            assert!(
                (square - 1.0 / 3.0).abs() < 4.0 * (4.0 / 45.0 / 1000.0_f64).sqrt(),
                "{square}"
            );
        }
        for (index, one) in numbers.iter().enumerate() {
            for other in &numbers[..index] {
                let product = shares(*one).zip(shares(*other)).map(|(one, other)| one * other);
                let mean = product.sum::<f64>() / 1000.0;
                assert!(mean.abs() < 4.0 * (1.0 / 9.0 / 1000.0_f64).sqrt(), "{mean}");
            }
        }
        // A number that stays leaves the others as they were.
        let still = members(&own, Moves { mass: 0.0, ..moves }, 10);
        for (still, moved) in still.iter().zip(&all) {
            assert_eq!(still.device.mass, own.device.mass);
            assert_eq!(still.operator.stiffness, moved.operator.stiffness);
        }
        assert_eq!(members(&own, Moves::NONE, 1)[0], own);
    }

    /// Released at -4 mm, an undamped mass on a spring is at -4 mm cos(w t).
    #[test]
    fn the_first_tick_finds_the_plant_where_free_motion_has_brought_it() {
        let moves = Moves { phase: 1.0, ..Moves::NONE };
        let frequency = (50.0_f64 / 0.3).sqrt();
        for (more, period) in [("", 0.01), ("environment_rate = 20.0\n", 0.05)] {
            for (member, moved) in members(&scene(more), moves, 20).iter().enumerate() {
                let (sin, cos) = (frequency * period * phase(member as u64)).sin_cos();
                assert_abs_diff_eq!(moved.initial.position.get(), -0.004 * cos, epsilon = 1e-16);
                let velocity = 0.004 * frequency * sin;
                assert_abs_diff_eq!(moved.initial.velocity.get(), velocity, epsilon = 1e-15);
            }
        }
        // A load moves the rest by 1 N / (50 N/m); friction of 1 N holds against 50 N/m · 4 mm.
        let loaded = members(&scene("effects.load.force = 1.0\n"), moves, 5);
        let stuck = members(&scene("effects.friction.coulomb = 1.0\n"), moves, 5);
        for (member, (loaded, stuck)) in loaded.iter().zip(&stuck).enumerate() {
            let position = 0.02 - 0.024 * (frequency * 0.01 * phase(member as u64)).cos();
            assert_abs_diff_eq!(loaded.initial.position.get(), position, epsilon = 1e-16);
            assert_eq!(stuck.initial, scene("").initial);
        }
    }

    #[test]
    fn what_goes_by_ticks_keeps_its_start_and_chance_gets_its_own_seeds() {
        let led =
            scene("operator.motion = { kind = \"sine\", amplitude = 0.01, frequency = 1.0 }\n");
        let linked = scene("operator.mass = 0.1\nlink = { stiffness = 1e3, damping = 2.0 }\n");
        for own in [led, linked] {
            let moved = members(&own, Moves::default(), 3);
            assert!(moved.iter().all(|member| member.initial == own.initial));
            assert!(moved[0].operator.stiffness != moved[1].operator.stiffness);
        }
    }

    /// The seeds of noise, jitter and dropout, under two seeds of the scene and two of the ensemble, of members near and far.
    #[test]
    fn chance_is_drawn_anew_under_each_seed_and_for_each_member() {
        let mut seeds = std::collections::BTreeSet::new();
        for of_scene in [7, 8] {
            let random = scene(&format!(
                "effects.noise = {{ deviation = 1e-6, seed = {of_scene} }}\n\
                 effects.jitter = {{ deviation = 0.01, seed = {of_scene} }}\n\
                 effects.dropout = {{ probability = 0.1, policy = \"hold\", seed = {of_scene} }}\n"
            ));
            for seed in [1, 2] {
                let ensemble = Ensemble { seed, moves: Moves::NONE };
                for member in (0..50).chain((1 << 32)..(1 << 32) + 50) {
                    let moved = ensemble.member(&random, member).unwrap();
                    assert_eq!(moved, ensemble.member(&random, member).unwrap());
                    let Effects { noise, jitter, dropout, .. } = &moved.effects;
                    let drawn = [
                        noise.map(|it| it.seed.get()),
                        jitter.map(|it| it.seed.get()),
                        dropout.map(|it| it.seed.get()),
                    ];
                    seeds.extend(drawn.map(Option::unwrap));
                }
            }
        }
        assert_eq!(seeds.len(), 2 * 2 * 100 * 3);
    }

    #[test]
    fn in_space_every_axis_moves() {
        let own = "duration = 1.0\nservo_rate = 100.0\nspace.dimensions = 2\ndevice.mass = 0.3\n\
            operator = { stiffness = 50.0, rest = [0.0, 0.0] }\ninitial.position = [-0.004, 0.002]\n\
            environment.plane = { point = [0.01, 0.0], normal = [-1.0, 0.0], stiffness = 1e3 }\n";
        let own = Scene::parse(own, "plane").unwrap();
        let moved = &members(&own, Moves { phase: 1.0, ..Moves::NONE }, 2)[1].initial.position;
        let share = moved.axis(0) / -0.004;
        assert!(share < 1.0);
        assert_abs_diff_eq!(moved.axis(1) / 0.002, share, epsilon = 1e-14);
    }

    #[test]
    fn a_share_beyond_the_whole_is_refused_by_its_key() {
        let ensemble = Ensemble { seed: SEED, moves: Moves { mass: 3.0, ..Moves::NONE } };
        let refused = (0..20).find_map(|member| ensemble.member(&scene(""), member).err());
        let refused = refused.unwrap();
        assert_eq!(refused.key(), "device.mass");
        assert!(refused.to_string().contains("move it by a share below 1"), "{refused}");
    }
}
