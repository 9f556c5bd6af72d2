//! The exact limit against the loop.

use approx::assert_relative_eq;
use lyapunov::Plant;
use lyapunov_lab::bound::{Limits, LinearPart};
use lyapunov_lab::{Assembly, Scene, Space};

use crate::bound::systems::{Chance, Kind, random, scene, stiffened};

/// Ticks of a stretch, over which the largest swing is taken.
const STRETCH: usize = 4096;

/// Largest number of stretches in which a loop must have grown or decayed.
const MOST: usize = 3000;

/// Whether the simulated motion of the loop of `scene` decays.
#[track_caller]
fn decays<V: Space>(scene: &Scene) -> bool {
    let mut moved = scene.to_draft();
    moved.initial.velocity = lyapunov_lab::scene::Finite::new(1.0).unwrap().into();
    let mut assembly = Assembly::<V>::of(&moved.check().unwrap()).unwrap();
    let mut sample = assembly.plant.start();
    let mut stretch = || {
        let mut most = 0.0_f64;
        for _ in 0..STRETCH {
            assembly.tick(&mut sample);
            let away = sample.position.axis(0).abs();
            most = if away.is_finite() { most.max(away) } else { f64::INFINITY };
        }
        most
    };
    let start = stretch();
    if start == f64::INFINITY {
        return false;
    }
    for _ in 0..MOST {
        let most = stretch();
        if most >= 1e4 * start {
            return false;
        }
        if most < 1e-4 * start {
            return true;
        }
    }
    panic!("neither grows nor decays: {scene:?}")
}

const ANY: Kind = Kind { slowest: 8, delay: 12, link: true, exact: true, damping: true };

#[track_caller]
fn is_the_limit<V: Space>(scene: &Scene, band: f64) -> bool {
    let limits = Limits::of(scene);
    let (from, most) = (limits.exact_from.unwrap(), limits.exact.unwrap());
    if most == 0.0 {
        // No stiffness decays.
        let part = LinearPart::of(scene).unwrap();
        let unit = part.device.mass / part.environment_period().powi(2);
        let any = stiffened(scene, 1e-2 * unit);
        let radius = LinearPart::of(&any).unwrap().spectral_radius();
        assert!(radius > 1.0 && (radius < 1.0 + band || !decays::<V>(&any)), "{scene:?}");
        return false;
    }
    // A narrower range of stable stiffnesses has no room for the points to be tested.
    if most * (1.0 - 2.0 * band) < from {
        return false;
    }
    let at = |share: f64| decays::<V>(&stiffened(scene, from + share * (most - from)));
    let outside = (most * (1.0 + band) - from) / (most - from);
    let inside = (most * (1.0 - band) - from) / (most - from);
    assert!(at(inside), "inside of {from} to {most}: {scene:?}");
    assert!(!at(outside), "outside of {from} to {most}: {scene:?}");
    // No stiffness below is unstable.
    for share in [0.1, 0.37, 0.71] {
        assert!(at(share), "{share} of {from} to {most}: {scene:?}");
    }
    true
}

#[test]
fn one_percent_inside_decays_and_one_percent_outside_grows() {
    let mut chance = Chance::new(1);
    let shown = (0..2000).filter(|_| is_the_limit::<f64>(&random(&mut chance, ANY), 0.01)).count();
    assert!(shown > 1500, "{shown}");
}

#[test]
fn three_percent_inside_decays_and_three_percent_outside_grows_in_f32() {
    let mut chance = Chance::new(2);
    let shown = (0..500).filter(|_| is_the_limit::<f32>(&random(&mut chance, ANY), 0.03)).count();
    assert!(shown > 350, "{shown}");
}

#[test]
fn long_delays_have_a_limit_too() {
    for ticks in [40, 333, 1024] {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice = {{ mass = 0.2, damping = 2.0 }}\n\
             operator = {{ damping = 1.0, stiffness = 10.0 }}\neffects.delay.ticks = {ticks}\n\
             environment.mass-spring-damper.stiffness = 1.0"
        );
        assert!(is_the_limit::<f64>(&scene(&text), 0.01));
    }
}

/// A link that yields by less than rounding makes one mass of two, as far as scenes may have such a link.
#[test]
fn a_link_that_hardly_yields_has_the_limits_of_one_mass() {
    for (rate, delay, damping) in [(1000, 0, 2.0), (100, 3, 0.0)] {
        let with = |link: &str| {
            scene(&format!(
                "duration = 1\nservo_rate = {rate}\ndevice = {{ mass = 0.2, damping = 0.1 }}\n\
                 operator = {{ mass = 0.1, damping = 4.0, stiffness = 50.0 }}\neffects.delay.ticks = {delay}\n\
                 environment.mass-spring-damper = {{ stiffness = 100.0, damping = {damping} }}\n{link}"
            ))
        };
        let joined = Limits::of(&with(""));
        let of = |limits: &Limits| [limits.exact, limits.spectral_radius].map(Option::unwrap);
        let most = (2f64.powi(42) * f64::from(rate)).powi(2) / (1.0 / 0.1 + 1.0 / 0.2);
        for stiffness in [1e20, 1e24, 0.999 * most] {
            // Within a tick a damper of 1e4 N.s/m takes the link's own swing away.
            let linked = with(&format!("link = {{ stiffness = {stiffness:e}, damping = 1e4 }}"));
            let limits = Limits::of(&linked);
            for (found, joined) in of(&limits).into_iter().zip(of(&joined)) {
                assert_relative_eq!(found, joined, max_relative = 1e-13);
            }
            assert!(is_the_limit::<f64>(&linked, 0.01));
        }
    }
}

#[test]
fn the_radius_passes_one_at_the_limit() {
    let mut chance = Chance::new(3);
    for _ in 0..2000 {
        let scene = random(&mut chance, ANY);
        let part = LinearPart::of(&scene).unwrap();
        let Some([_, most]) = part.stable_stiffness() else { continue };
        let radius = |share: f64| {
            let mut part = part;
            part.environment.stiffness = most * share;
            part.spectral_radius()
        };
        assert!(radius(1.0 - 1e-9) < 1.0 && radius(1.0 + 1e-9) > 1.0, "{scene:?}");
    }
}

#[test]
fn a_loop_without_damping_has_no_stable_stiffness() {
    for more in
        ["", "operator.stiffness = 50.0\n", "environment_rate = 100\neffects.delay.ticks = 3\n"]
    {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice.mass = 0.2\n\
             {more}environment.wall.stiffness = 100.0"
        );
        let limits = Limits::of(&scene(&text));
        assert_eq!((limits.exact, limits.passive, limits.gil), (Some(0.0), Some(0.0), Some(0.0)));
        assert!(limits.spectral_radius.unwrap() > 1.0);
    }
}

#[test]
fn a_body_without_a_spring_rests_anywhere() {
    let text = "duration = 1\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 1.0 }\n\
                environment.spring.stiffness = 0.0";
    let limits = Limits::of(&scene(text));
    assert_eq!(limits.spectral_radius, Some(1.0));
    assert!(limits.exact.unwrap() > 0.0);
}

/// A held spring on a mass alone: `z² − (2 − κ / 2) z + 1 + κ / 2 = 0` with `κ = K T² / m`, so that `z` tends to `−κ / 2`.
#[test]
fn the_radius_of_an_absurd_stiffness_is_right_or_none() {
    let radius = |stiffness: f64| {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice.mass = 1.0\n\
             environment.spring.stiffness = {stiffness:?}"
        );
        Limits::of(&scene(&text)).spectral_radius
    };
    for power in 10..=306 {
        let stiffness = 10_f64.powi(power);
        let is_right = |it: f64| (it / (0.5e-6 * stiffness) - 1.0).abs() < 1e-3;
        let found = radius(stiffness);
        assert!(found.map_or(power > 40, is_right), "{stiffness:?}: {found:?}");
    }
}
