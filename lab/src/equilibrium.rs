//! Where a scene comes to rest.

use lyapunov::environments::{Kinematics, Time};

use crate::scene::{Draft, Motion, StaticSpring};

/// Halvings of an interval: more than the digits of f64.
const HALVINGS: usize = 200;

/// Where the operator's spring, the environment and what pushes at the end balance, m; none where no spring pulls, where
/// something never rests, and in more than one dimension.
pub(crate) fn equilibrium(scene: &Draft) -> Option<f64> {
    let (pull, rest) = (last_pull(scene), last_rest(scene)?);
    if scene.dimensions() > 1 || pull <= 0.0 {
        return None;
    }
    let free = rest + last_push(scene) / pull;
    let balanced = balance(scene, pull, free)?;
    let most = scene.effects.saturation.map_or(f64::INFINITY, |limit| limit.force.get());
    let pushed = pull * (free - balanced);
    Some(if pushed.abs() > most { free - most.copysign(pushed) / pull } else { balanced })
}

/// Whether the scene is driven for as long as it lasts.
pub(crate) fn never_rests(scene: &Draft) -> bool {
    last_rest(scene).is_none() || scene.environment.kind().swings()
}

/// Where a spring of `pull` N/m that would rest at `free` and the environment balance.
fn balance(scene: &Draft, pull: f64, free: f64) -> Option<f64> {
    let kind = scene.environment.kind();
    if kind.swings() {
        return None;
    }
    let law = scene.law()?;
    let surface = law.surface(Time::Seconds(0.0)).map(|surface| surface.position);
    if surface.is_some_and(|surface| free <= surface) {
        return Some(free);
    }
    if let Some(StaticSpring { stiffness: push, position }) = kind.static_spring() {
        return match surface {
            Some(surface) => Some(surface + (free - surface) * (pull / (pull + push))),
            None => (pull + push > 0.0).then(|| (pull * free + push * position) / (pull + push)),
        };
    }
    let force = |x: f64| law.force(&Kinematics::at(x, 0.0));
    // A force that grows with the position is no larger than at `free` on the way there.
    let reach = force(free).abs() / pull;
    let [mut low, mut high] = surface.map_or([free - reach, free + reach], |it| [it, free]);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if pull * (middle - free) + force(middle) > 0.0 { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}

/// How far the plant would swing about `rest` if nothing else applied.
pub(crate) fn swing(scene: &Draft, rest: f64) -> f64 {
    let mass = scene.operator.mass.get() + scene.device.mass.get();
    let frequency = (last_pull(scene) / mass).sqrt();
    let away = scene.initial.position.get() - rest;
    away.hypot(scene.initial.velocity.get() / frequency)
}

fn swings(amplitude: f64, frequency: f64) -> bool {
    amplitude != 0.0 && frequency != 0.0
}

/// The stiffness that the device is pulled back with at the end, N/m: the operator's spring, and a link in series.
pub(crate) fn last_pull(scene: &Draft) -> f64 {
    let operator = &scene.operator;
    let changes = operator.grip.iter().flat_map(|grip| grip.times.iter().zip(&grip.stiffness));
    let mut gone = changes.filter(|(time, _)| scene.tick_of(time.get()) <= scene.ticks());
    let hand = gone.next_back().map_or(operator.stiffness, |(_, stiffness)| *stiffness).get();
    match scene.link {
        Some(link) if hand > 0.0 => (hand.recip() + link.stiffness.get().recip()).recip(),
        _ => hand,
    }
}

/// The force in +x on the device at the end, N.
fn last_push(scene: &Draft) -> f64 {
    let load = scene.effects.load.map_or(0.0, |load| load.force.get());
    let pulse = scene.effects.pulse.filter(|pulse| {
        let (start, duration) = (pulse.start.get(), pulse.duration.get());
        (scene.tick_of(start)..scene.tick_of(start + duration)).contains(&scene.ticks())
    });
    load + pulse.map_or(0.0, |pulse| pulse.force.get())
}

/// Where the operator's spring rests at the end, m; none if that still moves.
fn last_rest(scene: &Draft) -> Option<f64> {
    let rest = scene.operator.rest.get();
    let end = scene.ticks() as f64 * scene.period();
    match &scene.operator.motion {
        None => Some(rest),
        Some(Motion::Step { at, to }) => {
            Some(if scene.tick_of(at.get()) <= scene.ticks() { to.get() } else { rest })
        }
        Some(Motion::Ramp { at, to, rate }) => {
            let (way, speed, time) = (to.get() - rest, rate.get(), end - at.get());
            let moved = speed * time.max(0.0);
            if moved >= way.abs() { Some(to.get()) } else { (moved == 0.0).then_some(rest) }
        }
        Some(Motion::Sine { amplitude, frequency }) => {
            (!swings(amplitude.get(), frequency.get())).then_some(rest)
        }
        Some(Motion::File { samples, .. }) => {
            samples.last().filter(|(time, _)| *time <= end).map(|(_, rest)| *rest)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rollout, Scene};

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
            let told = equilibrium(scene).unwrap_or_else(|| panic!("{scene:?} has none"));
            assert!((last.x - told).abs() < 1e-9, "{} but {told} of {scene:?}", last.x);
        }
    }

    #[test]
    fn what_moves_at_the_end_has_no_equilibrium() {
        let motion = "motion = { kind = \"ramp\", to = 1.0, rate = 0.01 } }\n";
        let ramp = scene(&HAND.replace(" }\n", &format!(", {motion}")), WALL);
        assert!(never_rests(&ramp) && equilibrium(&ramp).is_none());
    }
}
