//! Closed loop of a scene, tick by tick.

use lyapunov::{OnePort, ParameterError, Plant, PortSample, Signal, Stabilizer};

use super::building::{AnyStabilizer, Assembly, Fitted, Scenes, Seen, Space};
use super::family::StabilizerName;
use super::row::Row;
use super::stabilizing::Stabilizing;
use super::tick::Tick;
use crate::files::Scene;

/// The ticks of a scene, from tick 0 to the last, computed on demand.
///
/// Ends early, after the last tick on which everything is finite, if the motion leaves the range of the scalar.
#[derive(Debug)]
pub struct Rollout<V: Signal = f64> {
    pub(crate) stabilizing: Stabilizing,
    rate: f64,
    number: u64,
    last: u64,
    assembly: Assembly<V>,
    seen: Seen<V>,
    truth: PortSample<V>,
}

impl<V: Space> Rollout<V> {
    /// The loop of `scene` with the stabilizer it names, in the scalar of `V`, whatever scalar `scene` names.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others.
    pub fn of(scene: &Scene) -> Result<Self, ParameterError> {
        let stabilizing = Stabilizing::Table(scene.stabilizer);
        Ok(Self { stabilizing, ..Self::assemble(scene, Fitted::of(scene)?)? })
    }

    /// The loop of `scene` with `stabilizer` instead of the scene's own.
    ///
    /// # Errors
    /// Those of [`Rollout::of`].
    pub fn stabilized_by<S: Stabilizer<V> + 'static>(
        scene: &Scene,
        stabilizer: S,
    ) -> Result<Self, ParameterError> {
        let fitted = Fitted::Behind(AnyStabilizer::new(stabilizer));
        Ok(Self { stabilizing: Stabilizing::foreign::<S>(), ..Self::assemble(scene, fitted)? })
    }

    /// The same loop, whose summary calls a stabilizer of the caller's by this name and not by that of its type.
    #[must_use]
    pub fn called(mut self, name: String) -> Self {
        if let Stabilizing::Foreign(known) = &mut self.stabilizing {
            *known = name.into();
        }
        self
    }

    /// The loop of `scene` under `member` of the family, whatever `scene` names.
    ///
    /// # Errors
    /// Those of [`Rollout::of`].
    pub fn under(scene: &Scene, member: StabilizerName) -> Result<Self, ParameterError> {
        let stabilizing = Stabilizing::Table(member.table(scene));
        Ok(Self { stabilizing, ..Self::assemble(scene, member.on(scene)?)? })
    }

    /// The ticks as rows along the first axis.
    pub fn rows(self) -> impl Iterator<Item = Row> {
        self.map(|tick| Row::of(&tick))
    }

    /// The loop of `scene` with what is already boxed.
    ///
    /// # Errors
    /// Those of [`Rollout::of`].
    pub fn assemble(scene: &Scene, fitted: Fitted<V>) -> Result<Self, ParameterError> {
        Self::on(Scenes::of(scene), fitted)
    }

    /// The loop of the scenes with what is already boxed.
    ///
    /// # Errors
    /// Those of [`Rollout::of`].
    pub(crate) fn on(scenes: Scenes<'_>, fitted: Fitted<V>) -> Result<Self, ParameterError> {
        let seen = Seen::default();
        let assembly = Assembly::put_together(scenes, Some(&seen), fitted)?;
        let scene = scenes.common();
        let (rate, last, truth) = (scene.servo_rate.get(), scene.ticks(), assembly.plant.start());
        let stabilizing = Stabilizing::Foreign("Fitted".into());
        Ok(Self { stabilizing, rate, number: 0, last, assembly, seen, truth })
    }

    /// The next tick, in range or not, even after the end of the scene.
    #[inline(always)]
    pub(crate) fn tick(&mut self) -> Tick<V> {
        let truth = self.truth;
        let applied = self.assembly.port.respond(&truth);
        let tick = self.seen.tick(self.number as f64 / self.rate, truth, applied);
        self.assembly.plant.advance_into(applied, &mut self.truth);
        self.number += 1;
        tick
    }
}

impl<V: Space> Iterator for Rollout<V> {
    type Item = Tick<V>;

    fn next(&mut self) -> Option<Tick<V>> {
        if self.number > self.last {
            return None;
        }
        let tick = self.tick();
        if tick.in_range() {
            return Some(tick);
        }
        self.number = u64::MAX;
        None
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;
    use nalgebra::Vector2;

    use super::*;
    use crate::simulate::equilibrium::{equilibria, never_rests};

    /// A slow hand of 200 N/m, 3 mm beyond a wall of 900 N/m at 2 mm, that comes to rest within 20 s.
    const HAND: &str = "duration = 20.0\nservo_rate = 1000.0\ndevice.mass = 0.2\n\
        operator = { mass = 0.1, damping = 20.0, stiffness = 200.0, rest = 0.005 }\n";
    const WALL: &str = "environment.wall = { position = 0.002, stiffness = 900.0 }\n";

    fn scene(hand: &str, more: &str) -> Scene {
        Scene::parse(&format!("{hand}{more}"), "test").unwrap_or_else(|fault| panic!("{fault}"))
    }

    #[test]
    fn a_run_that_rests_does_so_at_the_equilibrium() {
        let led = |motion: &str| HAND.replace(" }\n", &format!(", motion = {{ {motion} }} }}\n"));
        let grip = HAND.replace(
            " }\n",
            ", grip = { times = [1.0, 99.0], stiffness = [400.0, 1.0], damping = [30.0, 1.0] } }\n",
        );
        let cases = [
            scene(HAND, WALL),
            scene(HAND, &format!("{WALL}effects.load.force = 1.0\n")),
            scene(HAND, &format!("{WALL}effects.saturation.force = 0.3\n")),
            scene(HAND, &format!("{WALL}link.stiffness = 300.0\neffects.load.force = 1.0\n")),
            scene(
                HAND,
                &format!("{WALL}effects.pulse = {{ start = 1, duration = 99, force = 2 }}"),
            ),
            scene(&led("kind = \"step\", at = 99.0, to = 0.1"), WALL),
            scene(&led("kind = \"ramp\", to = 0.1, rate = 0.0"), WALL),
            scene(&led("kind = \"ramp\", to = 0.01, rate = 0.01"), WALL),
            scene(&led("kind = \"sine\", amplitude = 0.0, frequency = 1.0"), WALL),
            scene(&grip, WALL),
            scene(
                HAND,
                "environment.moving-wall = { position = 0.002, stiffness = 900.0, \
                amplitude = 0.0, frequency = 1.0 }",
            ),
            scene(HAND, "environment.spring.stiffness = -50.0"),
            scene(HAND, "environment.layered-wall = { depth = 1e-3, stiffness = [100.0, 2000.0] }"),
            scene(HAND, "environment.hunt-crossley = { stiffness = 1e5, exponent = 1.5 }"),
            scene(HAND, "environment.cubic-spring = { stiffness = 100.0, cubic = 2e7 }"),
            scene(
                HAND,
                "environment.cubic-spring = { position = 0.009, stiffness = 0.0, cubic = 2e7 }",
            ),
        ];
        for scene in &cases {
            let last = Rollout::<f64>::of(scene).unwrap().rows().last().unwrap();
            let [told] = equilibria(scene)[..] else { panic!("{scene:?} has none") };
            assert_abs_diff_eq!(last.x, told.axes()[0], epsilon = 1e-9);
        }
    }

    #[test]
    fn a_scene_that_still_moves_at_the_end_has_no_equilibrium() {
        let motion = "motion = { kind = \"ramp\", to = 1.0, rate = 0.01 } }\n";
        let ramp = scene(&HAND.replace(" }\n", &format!(", {motion}")), WALL);
        assert!(never_rests(&ramp) && equilibria(&ramp).is_empty());
    }

    /// The last of 98 ticks at 49 Hz is at 2 s, though 98 times the period, rounded, is less.
    #[test]
    fn a_motion_that_ends_with_the_run_rests() {
        let hand = HAND.replace("20.0\nservo_rate = 1000.0", "2.0\nservo_rate = 49.0");
        let ramp = "rest = 1.0, motion = { kind = \"ramp\", at = 1.0, to = 0.0, rate = 1.0 }";
        let ramp = scene(&hand.replace("rest = 0.005", ramp), WALL);
        assert!(!never_rests(&ramp) && !equilibria(&ramp).is_empty());
    }

    /// A light device without a hand.
    const USUAL: &str =
        "duration = 0.5\nservo_rate = 1000\ndevice = { mass = 0.1, damping = 0.1 }\n";

    /// The force of the controller is what the commanded force is more than the environment's, in any stabilizer.
    #[test]
    fn the_controller_s_force_is_what_it_adds() {
        let line =
            "initial = { position = -0.001, velocity = 0.3 }\nenvironment.wall.stiffness = 2000\n";
        for table in [
            "popc = {}",
            "lolc = {}",
            "tank.start = 1e-4",
            "force-bound.budget = 1e-4",
            "energy-bounding = {}",
            "force-bounding = {}",
            "memory-based = {}",
            "slope-bound = {}",
            "iss = {}",
            "virtual-coupling = {}",
            "least-norm = {}",
        ] {
            let scene = scene(USUAL, &format!("{line}stabilizer.{table}\n"));
            let rows: Vec<Row> = Rollout::<f64>::of(&scene).unwrap().rows().collect();
            for row in &rows {
                assert_abs_diff_eq!(row.f_env + row.f_ctl, row.f_out, epsilon = 1e-12);
            }
            assert!(rows.iter().any(|row| row.f_ctl != 0.0), "{table}");
        }
    }

    #[test]
    fn a_directed_damper_adds_no_force_across_its_direction() {
        let scene = scene(
            USUAL,
            "space.dimensions = 2\ninitial = { position = [0.0, -0.001], velocity = [0.2, 0.3] }\n\
             environment.plane = { point = [0.0, 0.0], normal = [0.0, -1.0], stiffness = 2000 }\n\
             stabilizer.directed-damping.direction = [0.0, 1.0]\n",
        );
        let ticks: Vec<_> = Rollout::<Vector2<f64>>::of(&scene).unwrap().collect();
        assert!(ticks.iter().any(|tick| tick.correction.alpha > 0.0 && tick.control().x != 0.0));
        for tick in &ticks {
            let added = tick.added();
            assert_eq!(added.x, 0.0);
            assert_abs_diff_eq!(tick.environment.y + added.y, tick.command.y, epsilon = 1e-12);
        }
    }

    /// A reference is counted from what was measured first, here half a count away from where the plant is.
    #[test]
    fn a_reference_begins_at_the_first_sample() {
        for initial in [0.00996, 0.01004] {
            let text = format!(
                "duration = 1\nservo_rate = 1000\nvelocity = \"exact\"\neffects.encoder.resolution = 1e-4\n\
                 device = {{ mass = 1, damping = 1 }}\ninitial.position = {initial}\n\
                 environment.wall.stiffness = 10000\nstabilizer.reference-following = {{}}\n"
            );
            let scene = Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"));
            let rows: Vec<Row> = Rollout::<f64>::of(&scene).unwrap().rows().collect();
            let stored = |x: f64| 0.5 * 10000.0 * x.max(0.0) * x.max(0.0);
            assert_eq!((rows[0].observed_energy, rows[0].alpha), (0.0, 0.0));
            let mut work = 0.0;
            for (before, row) in rows.iter().zip(&rows[1..]) {
                work += before.f_act * (row.x_measured - before.x_measured);
                let wanted = work - (stored(row.x_measured) - stored(rows[0].x_measured));
                assert_abs_diff_eq!(row.observed_energy, wanted, epsilon = 1e-12);
            }
        }
    }
}
