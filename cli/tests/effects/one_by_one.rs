//! Each effect alone, on a loop that settles, compared to the end of the run.

use crate::effects::compare::agrees;
use crate::effects::scene::{Dropout, Environment, Filter, Friction, Kind, Motion, Pulse, Scene};

#[track_caller]
fn to_the_end(scene: &Scene) {
    for hold in [1, 5] {
        for stabilizer in [None, Some(Kind::MassSpringDamper), Some(Kind::Popc)] {
            let mut scene = Scene { hold, ..scene.clone() };
            if let Some(kind) = stabilizer {
                scene = scene.with(kind, false, 0.25);
            }
            let compared = agrees(&scene).unwrap_or_else(|error| panic!("{error}"));
            // At rest the last bit switches a stabilizer.
            let least = if stabilizer.is_none() { scene.ticks() } else { scene.ticks() / 10 };
            assert!(compared >= least, "{compared} ticks of\n{}", scene.toml());
        }
    }
}

#[test]
fn filters() {
    for filter in
        [Filter::Cutoff(12.5), Filter::Cutoff(300.0), Filter::Window(1), Filter::Window(24)]
    {
        for encoder in [None, Some(2e-5)] {
            to_the_end(&Scene { filter: Some(filter), encoder, ..Scene::calm() });
        }
    }
}

#[test]
fn noise() {
    for encoder in [None, Some(2e-6)] {
        to_the_end(&Scene { noise: Some((3e-6, 1 << 40)), encoder, ..Scene::calm() });
    }
}

#[test]
fn jitter() {
    // With the larger deviation some intervals would be negative, and are 0.
    for deviation in [1e-4, 1e-3] {
        to_the_end(&Scene { jitter: Some((deviation, 5)), ..Scene::calm() });
        to_the_end(&Scene {
            jitter: Some((deviation, 5)),
            link: Some([900.0, 0.5]),
            ..Scene::calm()
        });
    }
}

#[test]
fn dropout() {
    for zero in [false, true] {
        for probability in [0.1, 1.0] {
            let dropout = Some(Dropout { probability, seed: 9, zero });
            to_the_end(&Scene { dropout, ..Scene::calm() });
        }
    }
}

#[test]
fn friction() {
    for (coulomb, breakaway, stribeck_velocity) in
        [(0.05, 0.05, 0.01), (0.05, 0.15, 0.02), (0.0, 0.1, 0.05)]
    {
        for link in [None, Some([2e3, 0.5])] {
            let friction = Some(Friction { coulomb, breakaway, stribeck_velocity });
            let motion = Some(Motion::Sine { amplitude: 0.004, frequency: 1.5 });
            to_the_end(&Scene { friction, link, motion, exact: true, ..Scene::calm() });
            to_the_end(&Scene { friction, link, jitter: Some((2e-4, 3)), ..Scene::calm() });
        }
    }
}

#[test]
fn load_and_pulse() {
    to_the_end(&Scene { load: Some(-0.4), ..Scene::calm() });
    for (start, duration) in [(0.0, 0.1), (0.1, 0.2), (0.3, 0.0), (0.0999, 0.0002), (0.7, 9.0)] {
        let pulse = Some(Pulse { start, duration, force: 0.7 });
        to_the_end(&Scene { pulse, load: Some(0.1), ..Scene::calm() });
    }
}

#[test]
fn link() {
    for link in [[100.0, 0.0], [2e4, 3.0], [1e6, 0.0]] {
        to_the_end(&Scene { link: Some(link), load: Some(0.2), ..Scene::calm() });
        to_the_end(&Scene { link: Some(link), exact: true, ..Scene::calm() });
    }
}

#[test]
fn motion() {
    let rows = vec![(-1.0, 0.3), (0.1, -0.001), (0.1004, 0.006), (0.4, 0.004)];
    for motion in [
        Motion::Step { at: 0.3, to: 0.004 },
        Motion::Step { at: 0.3001, to: -0.004 },
        Motion::Ramp { at: 0.1005, to: 0.005, rate: 0.02 },
        Motion::Ramp { at: 0.2, to: -0.006, rate: 0.03 },
        Motion::Sine { amplitude: -0.003, frequency: 3.0 },
        Motion::File { rows },
        Motion::File { rows: vec![(0.5, 0.004)] },
    ] {
        to_the_end(&Scene { motion: Some(motion), ..Scene::calm() });
    }
}

#[test]
fn grip() {
    let rows = vec![[0.1, 200.0, 0.0], [0.3001, 0.0, 4.0], [0.6, 80.0, 2.0]];
    for link in [None, Some([3e3, 1.0])] {
        let grip = Some(rows.clone());
        to_the_end(&Scene { grip: grip.clone(), link, ..Scene::calm() });
        to_the_end(&Scene { grip, link, jitter: Some((3e-4, 8)), ..Scene::calm() });
    }
}

#[test]
fn environments() {
    let (position, stiffness, damping) = (0.0005, 250.0, 0.8);
    for environment in [
        Environment::Spring { position, stiffness },
        Environment::Spring { position, stiffness: -40.0 },
        Environment::MassSpringDamper { position, mass: 0.005, damping, stiffness },
        Environment::MassSpringDamper { position, mass: 0.0, damping: -0.2, stiffness },
        Environment::LayeredWall {
            position,
            depth: 0.0004,
            stiffness: [stiffness, 900.0],
            damping,
        },
        Environment::HuntCrossley { position, stiffness: 9e3, exponent: 1.5, damping: 3.0 },
        Environment::MovingWall { position, stiffness, damping, amplitude: 0.001, frequency: 7.0 },
        Environment::VaryingSpring { position, stiffness, amplitude: 90.0, frequency: 7.0 },
        Environment::CubicSpring { position, stiffness, cubic: 4e6 },
    ] {
        to_the_end(&Scene::calm().touching(environment));
    }
}

#[test]
fn solids() {
    for dimensions in [2, 3] {
        let last = if dimensions == 2 { 0.0 } else { 1.0 };
        let half = [0.004, 0.003, if dimensions == 2 { f64::INFINITY } else { 0.005 }];
        let (stiffness, damping) = (250.0, 0.8);
        for environment in [
            Environment::Plane {
                point: [0.001, 0.0, 0.0],
                normal: [-2.0, 0.3, last],
                stiffness,
                damping,
            },
            Environment::Sphere {
                center: [0.005, 0.001, 0.001 * last],
                radius: 0.004,
                stiffness,
                damping,
            },
            Environment::Cuboid { center: [0.005, 0.001, 0.0], half, stiffness, damping },
        ] {
            let mut scene = Scene::calm().touching(environment);
            scene.dimensions = dimensions;
            scene.position = [-0.004, 0.001, -0.002 * last];
            scene.velocity = [0.05, -0.02, 0.01 * last];
            scene.operator.rest = [0.003, 0.0005, 0.001 * last];
            for link in [None, Some([3e3, 1.0])] {
                to_the_end(&Scene { link, load: Some(0.1), ..scene.clone() });
                let motion = Some(Motion::Sine { amplitude: 0.002, frequency: 2.0 });
                to_the_end(&Scene { link, motion, ..scene.clone() });
            }
        }
    }
}
