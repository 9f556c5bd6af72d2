//! Random scenes from fixed seeds.

use proptest::prelude::*;

use crate::effects::scene::{
    Dropout, Environment, Filter, Friction, Kind, Motion, Operator, Pulse, Scene, Stabilizer,
};

type Ports = (Option<f64>, usize, Option<f64>, Option<Filter>, Option<(f64, u64)>, Option<Dropout>);
type Bodies =
    (Option<Motion>, Option<Vec<[f64; 3]>>, Option<[f64; 2]>, Option<f64>, Option<Pulse>, bool);

fn line() -> impl Strategy<Value = Environment> {
    let (position, damping) = (-0.003..0.003, prop_oneof![1 => Just(0.0), 3 => 0.0..8.0]);
    let stiffness = || (1.5..3.8).prop_map(|decades| 10_f64.powf(decades));
    let swing = (1e-4..2e-3, 0.0..20.0);
    let one = (position, stiffness(), damping, stiffness(), swing);
    (0..7_usize, one, 0.0..0.004, 0.6..2.5, -2.0..0.02).prop_map(
        |(
            kind,
            (position, stiffness, damping, other, (amplitude, frequency)),
            depth,
            exponent,
            mass,
        )| {
            match kind {
                0 => Environment::Wall { position, stiffness, damping },
                1 => Environment::Spring { position, stiffness: stiffness - 50.0 },
                2 => Environment::MassSpringDamper {
                    position,
                    mass: f64::max(0.0, mass),
                    damping: damping - 0.2,
                    stiffness,
                },
                3 => Environment::LayeredWall {
                    position,
                    depth,
                    stiffness: [stiffness, other],
                    damping,
                },
                4 => Environment::HuntCrossley {
                    position,
                    stiffness: stiffness * 100_f64.powf(exponent - 1.0),
                    exponent,
                    damping: damping * 4.0,
                },
                5 => Environment::MovingWall { position, stiffness, damping, amplitude, frequency },
                _ => Environment::VaryingSpring {
                    position,
                    stiffness,
                    amplitude: stiffness * 0.4,
                    frequency,
                },
            }
        },
    )
}

fn solid(dimensions: usize) -> impl Strategy<Value = Environment> {
    let beyond = if dimensions == 2 { 0.0 } else { 1.0 };
    let axes = |size: f64| [-size..size, -size..size, -size..size];
    let material = ((1.5..3.8).prop_map(|decades| 10_f64.powf(decades)), 0.0..8.0);
    (0..3_usize, axes(0.004), axes(1.0), axes(0.006), material).prop_map(
        move |(kind, place, normal, half, (stiffness, damping))| {
            let flat = |[x, y, z]: [f64; 3]| [x, y, z * beyond];
            match kind {
                0 => Environment::Plane {
                    point: flat(place),
                    normal: flat(normal),
                    stiffness,
                    damping,
                },
                1 => Environment::Sphere {
                    center: flat(place),
                    radius: 0.002 + half[0].abs(),
                    stiffness,
                    damping,
                },
                _ => {
                    let mut half = half.map(|axis| 0.002 + axis.abs());
                    if dimensions == 2 {
                        half[2] = f64::INFINITY;
                    }
                    Environment::Cuboid { center: flat(place), half, stiffness, damping }
                }
            }
        },
    )
}

fn stabilizer() -> impl Strategy<Value = Option<Stabilizer>> {
    let kind = prop::sample::select(vec![
        Kind::Popc,
        Kind::MassSpringDamper,
        Kind::MassSpringDamper,
        Kind::DeviceDamping,
        Kind::Spring,
    ]);
    let cap = prop::sample::select(vec![0.0, 0.25, 0.5, 0.5, 1.0]);
    let some = (kind, prop::bool::weighted(0.3), cap);
    let some = some.prop_map(|(kind, sampled, cap)| Stabilizer { kind, sampled, cap });
    prop::option::weighted(0.8, some)
}

fn ports() -> impl Strategy<Value = Ports> {
    let filter =
        prop_oneof![(1.0..200.0).prop_map(Filter::Cutoff), (1..20_usize).prop_map(Filter::Window),];
    let dropout = (0.0..0.6, any::<u32>(), any::<bool>());
    let dropout = dropout.prop_map(|(probability, seed, zero)| Dropout {
        probability,
        seed: u64::from(seed) << 20,
        zero,
    });
    (
        prop::option::weighted(0.3, 1e-6..1e-4),
        prop_oneof![2 => Just(0_usize), 1 => 1_usize..=3],
        prop::option::weighted(0.2, 0.2..5.0),
        prop::option::weighted(0.4, filter),
        prop::option::weighted(0.3, (0.0..1e-5, any::<u32>().prop_map(u64::from))),
        prop::option::weighted(0.3, dropout),
    )
}

fn motion() -> impl Strategy<Value = Motion> {
    let place = || -0.01..0.01;
    prop_oneof![
        (0.0..0.5, place()).prop_map(|(at, to)| Motion::Step { at, to }),
        (0.0..0.5, place(), 0.0..0.1).prop_map(|(at, to, rate)| Motion::Ramp { at, to, rate }),
        (place(), 0.0..8.0)
            .prop_map(|(amplitude, frequency)| Motion::Sine { amplitude, frequency }),
        prop::collection::vec((0.01..0.3, place()), 1..6).prop_map(|rows| {
            let mut t = -0.05;
            let row = |(step, rest)| {
                t += step;
                (t, rest)
            };
            Motion::File { rows: rows.into_iter().map(row).collect() }
        }),
    ]
}

fn bodies() -> impl Strategy<Value = Bodies> {
    let row = (0.0..0.3, 0.0..400.0, 0.0..6.0);
    let grip = prop::collection::vec(row, 0..4).prop_map(|rows| {
        let mut t = 0.0;
        let row = |(step, stiffness, damping)| {
            t += step + 1e-3;
            [t, stiffness, damping]
        };
        rows.into_iter().map(row).collect()
    });
    let pulse = (0.0..0.3, 0.0..0.3, -3.0..3.0);
    let pulse = pulse.prop_map(|(start, duration, force)| Pulse { start, duration, force });
    (
        prop::option::weighted(0.4, motion()),
        prop::option::weighted(0.3, grip),
        prop::option::weighted(
            0.3,
            ((2.0..5.0).prop_map(|d| 10_f64.powf(d)), 0.0..5.0).prop_map(|(k, b)| [k, b]),
        ),
        prop::option::weighted(0.3, -1.5..1.5),
        prop::option::weighted(0.3, pulse),
        prop::bool::weighted(0.25),
    )
}

fn friction() -> impl Strategy<Value = Option<Friction>> {
    let some = (0.0..0.4, 0.0..0.4, 0.005..0.1).prop_map(|(coulomb, more, stribeck_velocity)| {
        Friction { coulomb, breakaway: coulomb + more, stribeck_velocity }
    });
    prop::option::weighted(0.35, some)
}

pub(crate) fn scenes(single: bool) -> impl Strategy<Value = Scene> {
    let dimensions = prop::sample::select(vec![1, 1, 1, 1, 2, 3_usize]);
    dimensions.prop_flat_map(move |dimensions| {
        let environment = if dimensions == 1 { line().boxed() } else { solid(dimensions).boxed() };
        let rates = (prop::sample::select(vec![100.0, 250.0, 500.0, 1e3, 873.1]), 1_usize..=6);
        let hand = (0.02..0.3, 0.0..4.0, 0.0..300.0, 0.05..0.5, 0.0..2.0);
        let axes = |size: f64| [-size..size, -size..size, -size..size];
        let starts = (axes(0.006), axes(0.15), axes(0.004));
        let jitter = prop::option::weighted(0.3, (0.0..2e-4, any::<u32>().prop_map(u64::from)));
        (environment, rates, hand, starts, stabilizer(), ports(), bodies(), friction(), jitter)
            .prop_map(
                move |(
                    environment,
                    rates,
                    hand,
                    starts,
                    stabilizer,
                    ports,
                    bodies,
                    friction,
                    jitter,
                )| {
                    let flat = |mut axes: [f64; 3]| {
                        axes[dimensions..].fill(0.0);
                        axes
                    };
                    let (encoder, delay, saturation, filter, noise, dropout) = ports;
                    let (motion, grip, link, load, pulse, exact) = bodies;
                    let (mass, damping, stiffness) = (hand.0, hand.1, hand.2);
                    Scene {
                        duration: 0.4,
                        servo_rate: rates.0,
                        hold: rates.1,
                        exact,
                        single,
                        dimensions,
                        operator: Operator { mass, damping, stiffness, rest: flat(starts.2) },
                        motion,
                        grip,
                        device: [hand.3, hand.4],
                        link,
                        position: flat(starts.0),
                        velocity: flat(starts.1),
                        environment,
                        stabilizer,
                        encoder,
                        delay,
                        saturation,
                        filter: filter.filter(|_| !exact),
                        noise,
                        jitter,
                        dropout,
                        friction: friction.filter(|_| dimensions == 1),
                        load,
                        pulse,
                    }
                },
            )
    })
}
