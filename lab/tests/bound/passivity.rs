//! Colgate and Schenkel's condition against the energy at the port.

use std::f64::consts::PI;

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::{HeldTick, OnePort, PortSample};
use lyapunov_lab::bound::{Limits, LinearPart};
use lyapunov_lab::{Assembly, Scene};
use nalgebra::DMatrix;

use crate::bound::systems::{Chance, Kind, random, scene, stiffened};

const ONE_RATE: Kind = Kind { slowest: 1, delay: 6, link: true, exact: false, damping: true };
const TWO_RATES: Kind = Kind { slowest: 6, ..ONE_RATE };

/// The least energy, J, that port and device's damper have taken at any time of a motion by `displacements`, straight
/// between the ticks, and the sum of the magnitudes of the work at the port.
fn least(scene: &Scene, displacements: &[f64]) -> (f64, f64) {
    let mut port = Assembly::<f64>::of(scene).unwrap().port;
    let (period, damping) = (scene.period(), scene.device.damping.get());
    let (mut position, mut applied) = (0.0, port.respond(&PortSample::starting(period, 0.0, 0.0)));
    let (mut energy, mut least, mut size) = (0.0_f64, 0.0_f64, 0.0_f64);
    for moved in displacements {
        let taken = applied * moved + damping * moved * moved / period;
        energy += taken;
        size += (applied * moved).abs();
        least = least.min(energy);
        position += moved;
        applied = port.respond(
            &HeldTick { period, position, velocity: moved / period, displacement: *moved, applied }
                .sample(),
        );
    }
    (least, size)
}

/// Random motion: swings, noise and mixtures of both.
fn motion(chance: &mut Chance, count: usize) -> Vec<f64> {
    let waves: Vec<[f64; 3]> = (0..3)
        .map(|_| [chance.decades(1e-2, PI), chance.within(0.0, 2.0 * PI), chance.share()])
        .collect();
    let noise = chance.share() * chance.share();
    let wave = |n: usize| -> f64 {
        waves.iter().map(|[angle, phase, size]| size * (angle * n as f64 + phase).sin()).sum()
    };
    (0..count).map(|n| 1e-3 * (wave(n) + noise * chance.within(-1.0, 1.0))).collect()
}

fn within(scene: &Scene, share: f64) -> Option<Scene> {
    let most = Limits::of(scene).passive.unwrap();
    (most > 0.0).then(|| stiffened(scene, share * most))
}

#[test]
fn inside_the_limit_no_motion_extracts_energy() {
    let mut chance = Chance::new(11);
    let mut shown = 0;
    for index in 0..3000 {
        let kind = if index % 2 == 0 { ONE_RATE } else { TWO_RATES };
        let scene = random(&mut chance, kind);
        let Some(scene) = within(&scene, 0.99) else { continue };
        let (least, size) = least(&scene, &motion(&mut chance, 400));
        assert!(least >= -1e-12 * size, "{least} of {size}: {scene:?}");
        shown += 1;
    }
    assert!(shown > 1500, "{shown}");
}

/// Whether a hundredth of the stiffness matters beside the damper, so that a motion of limited length shows it.
fn matters(scene: &Scene) -> bool {
    let part = LinearPart::of(scene).unwrap();
    let held = 0.5 * part.environment.stiffness * part.environment_period();
    held > 0.2 * part.device.damping
}

/// Forces of the port after one displacement of 1 m, tick by tick, until the force is constant.
fn answer(scene: &Scene) -> Vec<f64> {
    let mut port = Assembly::<f64>::of(scene).unwrap().port;
    let period = scene.period();
    let mut applied = port.respond(&PortSample::starting(period, 0.0, 0.0));
    let mut displacements = vec![1.0];
    displacements.resize(600, 0.0);
    let answer = displacements.into_iter().map(|moved| {
        applied = port.respond(
            &HeldTick {
                period,
                position: 1.0,
                velocity: moved / period,
                displacement: moved,
                applied,
            }
            .sample(),
        );
        applied
    });
    answer.collect()
}

/// Angle per tick of the swing that extracts the most energy.
fn worst(scene: &Scene) -> f64 {
    let answer = answer(scene);
    let stands = answer[answer.len() - 1];
    let angles = (1..=600).map(|index| PI * f64::from(index) / 600.0);
    // f(n) works over the next displacement: the answer is one tick old. Its constant part gives −K / 2 at every angle.
    let taken = |angle: f64| -> f64 {
        let moving = answer.iter().enumerate();
        moving.map(|(n, force)| (force - stands) * (angle * (n as f64 + 1.0)).cos()).sum()
    };
    angles.min_by(|one, other| taken(*one).total_cmp(&taken(*other))).unwrap()
}

#[test]
fn outside_the_limit_a_swing_extracts_energy() {
    let mut chance = Chance::new(12);
    let mut shown = 0;
    for _ in 0..1200 {
        let scene = random(&mut chance, ONE_RATE);
        let Some(scene) = within(&scene, 1.01).filter(matters) else { continue };
        let angle = worst(&scene);
        // The start may take more energy than a period of the swing gives back.
        let swing: Vec<f64> =
            (0..60_000).map(|n| 1e-3 * (angle * (f64::from(n) + 0.5)).sin()).collect();
        let early = least(&scene, &swing[..30_000]).0;
        let late = least(&scene, &swing).0;
        assert!(late < 0.0 && late < 1.5 * early, "{early} {late}: {scene:?}");
        shown += 1;
    }
    assert!(shown > 300, "{shown}");
}

/// The energy that port and damper have taken after `count` ticks, as a quadratic form in the displacements.
fn form(scene: &Scene, count: usize) -> DMatrix<f64> {
    let (period, damping) = (scene.period(), scene.device.damping.get());
    let mut form = DMatrix::zeros(count, count);
    for pushed in 0..count {
        let mut port = Assembly::<f64>::of(scene).unwrap().port;
        let mut applied = port.respond(&PortSample::starting(period, 0.0, 0.0));
        let mut position = 0.0;
        for tick in 0..count {
            form[(tick, pushed)] += 0.5 * applied;
            form[(pushed, tick)] += 0.5 * applied;
            let moved = if tick == pushed { 1.0 } else { 0.0 };
            position += moved;
            applied = port.respond(
                &HeldTick {
                    period,
                    position,
                    velocity: moved / period,
                    displacement: moved,
                    applied,
                }
                .sample(),
            );
        }
        form[(pushed, pushed)] += damping / period;
    }
    form
}

#[test]
fn with_two_rates_the_worst_motion_extracts_energy_only_outside_the_limit() {
    let mut chance = Chance::new(13);
    let mut shown = 0;
    for _ in 0..120 {
        let kind = Kind { slowest: 5, delay: 4, ..TWO_RATES };
        let scene = random(&mut chance, kind);
        let (Some(inside), Some(outside)) = (within(&scene, 0.99), within(&scene, 1.02)) else {
            continue;
        };
        if !matters(&outside) {
            continue;
        }
        assert!(form(&inside, 60).cholesky().is_some(), "{inside:?}");
        let generates =
            [120, 240, 420].into_iter().any(|count| form(&outside, count).cholesky().is_none());
        assert!(generates, "{outside:?}");
        shown += 1;
    }
    assert!(shown > 30, "{shown}");
}

#[test]
fn closed_forms() {
    let with = |more: &str| {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice = {{ mass = 0.2, damping = 3.0 }}\n{more}\n"
        );
        let limits = Limits::of(&scene(&text));
        limits.passive.unwrap()
    };
    let near = |found: f64, expected: f64| {
        assert!(abs_diff_eq!(found / expected, 1.0, epsilon = 1e-13), "{found} {expected}");
    };
    // b > K T / 2 + B, the sum of the damper's magnitude and the spring's hold (Colgate and Schenkel).
    near(with("environment.wall.stiffness = 1"), 6000.0);
    near(with("environment.wall = { stiffness = 1, damping = 1 }"), 4000.0);
    // b > K (T / 2 + t_d) without a damper.
    near(with("effects.delay.ticks = 7\nenvironment.wall.stiffness = 1"), 3.0 / 0.0075);
    // The period of the environment for T, without a damper.
    near(with("environment_rate = 100\nenvironment.wall.stiffness = 1"), 600.0);
    let late = "environment_rate = 100\neffects.delay.ticks = 4\nenvironment.wall.stiffness = 1";
    assert_abs_diff_eq!(with(late) * with_delay(10, 4, 1e-3) / 3.0, 1.0, epsilon = 1e-7);
    assert_eq!(with("environment.wall = { stiffness = 1, damping = 3.1 }"), 0.0);
    assert_eq!(
        with("velocity = \"exact\"\nenvironment.wall = { stiffness = 1, damping = 0.1 }"),
        0.0
    );
    near(with("velocity = \"exact\"\nenvironment.wall = { stiffness = 1 }"), 6000.0);
}

/// Damping that a unit of stiffness needs at a hold of `ratio` ticks that comes `ticks` late: the largest eigenvalue of
/// `−(e 1ᵀ / (z − 1) + its conjugate transpose) / 2` over the phases, by nalgebra.
fn with_delay(ratio: usize, ticks: usize, period: f64) -> f64 {
    use nalgebra::Complex;
    let mut most = 0.0_f64;
    for index in 1..=200 {
        // The largest eigenvalue is at angle 0.
        let angle = if index == 1 { 1e-4 } else { PI * f64::from(index) / 200.0 };
        let back = Complex::from_polar(1.0, -angle);
        let gain = (back.inv() - Complex::from(1.0)).inv();
        let form = DMatrix::from_fn(ratio, ratio, |row, column| {
            let entry = |row: usize| gain * if row < ticks { back } else { Complex::from(1.0) };
            -(entry(row) + entry(column).conj()) * Complex::from(0.5)
        });
        most = most.max(form.symmetric_eigenvalues().max());
    }
    most * period
}

#[test]
fn at_the_limit_the_needed_damping_is_that_of_the_device() {
    let mut chance = Chance::new(14);
    for _ in 0..300 {
        let Some(scene) = within(&random(&mut chance, TWO_RATES), 1.0) else { continue };
        let part = LinearPart::of(&scene).unwrap();
        assert!(
            abs_diff_eq!(part.passive_damping() / part.device.damping, 1.0, epsilon = 1e-9),
            "{scene:?}"
        );
    }
}
