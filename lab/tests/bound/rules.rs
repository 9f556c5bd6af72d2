//! Gil's rule, the limit of friction and encoder, and limits that do not apply.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{HeldTick, OnePort, PortSample};
use lyapunov_lab::bound::Limits;
use lyapunov_lab::{Assembly, Scene};

use crate::bound::systems::{Chance, scene};

/// Gil's rule is the first order of the exact limit where the damping is small against the mass.
#[test]
fn the_exact_limit_tends_to_gil_s_rule() {
    let mut chance = Chance::new(21);
    for _ in 0..2000 {
        let rate = chance.decades(100.0, 4000.0);
        let mass = chance.decades(0.05, 5.0);
        let small = |chance: &mut Chance| mass * rate * chance.decades(1e-6, 1e-4);
        let (device, hand) = (small(&mut chance), small(&mut chance));
        let wall = small(&mut chance);
        let ticks = chance.whole(0, 5);
        let ratio = chance.whole(1, 4);
        // The rule is of first order in the environment's period, and its damper runs at that period.
        let wall = if ratio == 1 { wall } else { 0.0 };
        let text = format!(
            "duration = 1\nservo_rate = {rate}\nenvironment_rate = {}\n\
             device = {{ mass = {mass}, damping = {device} }}\noperator.damping = {hand}\n\
             effects.delay.ticks = {ticks}\n\
             environment.wall = {{ stiffness = 1, damping = {wall} }}\n",
            rate / ratio as f64
        );
        let limits = Limits::of(&scene(&text));
        let share = limits.gil.unwrap() / limits.exact.unwrap();
        assert!(abs_diff_eq!(share, 1.0, epsilon = 0.02), "{share}\n{text}");
    }
}

fn rubbing(device: f64, coulomb: f64, resolution: f64, stiffness: f64) -> String {
    format!(
        "duration = 1\nservo_rate = 1000\ndevice = {{ mass = 0.2, damping = {device} }}\n\
         effects.friction.coulomb = {coulomb}\neffects.encoder.resolution = {resolution}\n\
         environment.spring.stiffness = {stiffness}\n"
    )
}

/// The energy, J, that port, damper and friction have taken, tick by tick, of a motion through `positions`.
fn energies(text: &str, positions: &[f64]) -> Vec<f64> {
    let scene = scene(text);
    let mut port = Assembly::<f64>::of(&scene).unwrap().port;
    let (period, damping) = (scene.period(), scene.device.damping.get());
    let coulomb = scene.effects.friction.unwrap().coulomb.get();
    let (mut place, mut applied) = (0.0, port.respond(&PortSample::starting(period, 0.0, 0.0)));
    let mut energy = 0.0;
    let energies = positions.iter().map(|position| {
        let moved = position - place;
        energy += applied * moved + damping * moved * moved / period + coulomb * moved.abs();
        place = *position;
        applied = port.respond(
            &HeldTick {
                period,
                position: place,
                velocity: moved / period,
                displacement: moved,
                applied,
            }
            .sample(),
        );
        energy
    });
    energies.collect()
}

#[test]
fn friction_covers_half_a_count_and_damping_covers_the_hold() {
    let mut chance = Chance::new(22);
    for _ in 0..1500 {
        let (device, coulomb) = (chance.decades(0.1, 10.0), chance.decades(0.01, 1.0));
        let resolution = chance.decades(1e-6, 1e-3);
        let most = Limits::of(&scene(&rubbing(device, coulomb, resolution, 1.0)));
        let most = most.friction_quantization.unwrap();
        let exact = (2.0 * device * 1000.0).min(2.0 * coulomb / resolution);
        assert_abs_diff_eq!(most / exact, 1.0, epsilon = 1e-14);
        // Inside the limit no random motion over a few counts extracts energy.
        let text = rubbing(device, coulomb, resolution, 0.99 * most);
        let size = resolution * chance.decades(0.1, 30.0);
        let walk: Vec<f64> = (0..200).map(|_| size * chance.within(-1.0, 1.0)).collect();
        let least = energies(&text, &walk).into_iter().fold(0.0, f64::min);
        assert!(least >= -1e-12 * most * size * size, "{text}");
        if exact < 2.0 * device * 1000.0 {
            // Outside the limit a motion to and fro across the edge of a count does.
            let text = rubbing(device, coulomb, resolution, 1.01 * most);
            let step = 1e-6 * resolution;
            let edge = 0.5 * resolution;
            let approach = (0..1000).map(|n| edge * f64::from(n) / 1000.0 - step);
            let swing = (0..2000).map(|n| if n % 2 == 0 { edge - step } else { edge + step });
            let swing: Vec<f64> = approach.chain(swing).collect();
            let energy = |count: usize| energies(&text, &swing[..count]).pop().unwrap();
            assert!(energy(3000) < energy(2000), "{text}");
        }
    }
}

const START: &str = "duration = 1\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 1.0 }\n";

#[test]
fn limits_that_do_not_apply_are_none_with_a_reason() {
    let of = |more: &str| Limits::of(&scene(&format!("{START}{more}")));
    let says = |limits: &Limits, words: &str| limits.notes.iter().any(|note| note.contains(words));

    let ball = of("environment.hunt-crossley = { stiffness = 1e5, exponent = 1.5 }");
    assert_eq!((ball.passive, ball.gil, ball.exact), (None, None, None));
    assert!(says(&ball, "exponent 1"), "{ball:?}");

    let flat = of("environment.hunt-crossley = { stiffness = 100, exponent = 1, damping = 2 }");
    let wall = of("environment.wall.stiffness = 100");
    assert_eq!((flat.passive, flat.gil, flat.exact), (wall.passive, wall.gil, wall.exact));

    let damped = "environment.wall = { stiffness = 100, damping = 1 }\n";
    let window = of(&format!("{damped}effects.filter.window = 8"));
    assert_eq!((window.passive, window.exact, window.spectral_radius), (None, None, None));
    assert!(window.gil.is_some() && says(&window, "window"));
    // A window of one tick is the backward difference.
    let one = of(&format!("{damped}effects.filter.window = 1"));
    let without = of(damped);
    assert_eq!(
        (one.passive, one.exact, one.spectral_radius, one.gil),
        (without.passive, without.exact, without.spectral_radius, without.gil)
    );
    let unused = of("environment.wall.stiffness = 100\neffects.filter.window = 8");
    assert_eq!((unused.passive, unused.exact), (wall.passive, wall.exact));

    let lossy = "effects.dropout = { probability = 0.1, seed = 1, policy = \"hold\" }";
    let lossy = of(&format!("{damped}{lossy}"));
    assert_eq!((lossy.passive, lossy.exact), (None, None));
    assert!(says(&lossy, "loses answers"));
    assert_eq!(wall.friction_quantization, None);
}

#[test]
fn every_environment_with_a_stiffness_has_limits() {
    let wall = Limits::of(&scene(&format!("{START}environment.wall.stiffness = 100")));
    for environment in [
        "spring.stiffness = 100",
        "mass-spring-damper.stiffness = 100",
        "layered-wall = { depth = 1e-3, stiffness = [100, 900] }",
        "moving-wall = { stiffness = 100, amplitude = 1e-3, frequency = 1 }",
        "varying-spring = { stiffness = 100, amplitude = 10, frequency = 1 }",
        "cubic-spring = { stiffness = 100, cubic = 1e6 }",
        "plane = { point = [0, 0], normal = [0, 1], stiffness = 100 }\nspace.dimensions = 2",
        "sphere = { center = [0, 0], radius = 0.1, stiffness = 100 }\nspace.dimensions = 2",
        "box = { center = [0, 0], half = [0.1, 0.1], stiffness = 100 }\nspace.dimensions = 2",
    ] {
        let limits = Limits::of(&scene(&format!("{START}environment.{environment}")));
        assert_eq!(limits.named(), wall.named(), "{environment}");
        assert_eq!((limits.stiffness, limits.spectral_radius), (Some(100.0), wall.spectral_radius));
    }
}

/// Limits of scenes with numbers that are allowed, and that no real loop has.
#[test]
fn extreme_scenes_end_and_report_finite_limits() {
    let values: [f64; 7] = [1e-300, 1e-30, 1e-6, 1.0, 1e6, 1e30, 1e300];
    let mut chance = Chance::new(23);
    let mut any = || values[chance.whole(0, 6) as usize];
    let mut loops = 0;
    for index in 0..300 {
        let (rate, mass, damping) = (any(), any(), any());
        let (stiffness, wall, hand) = (any(), any(), any());
        let text = format!(
            "duration = {}\nservo_rate = {rate}\ndevice = {{ mass = {mass}, damping = {damping} }}\n\
             operator = {{ mass = {hand}, stiffness = {} }}\neffects.delay.ticks = {}\n\
             environment.wall = {{ stiffness = {stiffness}, damping = {wall} }}\n",
            (10.0 / rate).max(f64::MIN_POSITIVE),
            any(),
            index % 3,
        );
        let Ok(scene) = Scene::parse(&text, "test") else { continue };
        let limits = Limits::of(&scene);
        let numbers = limits.named().map(|(_, _, limit)| limit);
        for number in numbers.into_iter().chain([limits.spectral_radius]).flatten() {
            assert!(number.is_finite() && number >= 0.0, "{number}\n{text}");
        }
        loops += 1;
    }
    assert!(loops > 200, "{loops}");
}
