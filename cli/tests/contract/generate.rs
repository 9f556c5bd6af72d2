//! Scenes of the tests: a list by hand, and random ones from fixed seeds.

use proptest::prelude::*;

use crate::contract::scene::{
    Device, Initial, Kind, Operator, SOFT, STIFF, Scalar, Scene, Stabilizer, Velocity, Wall, Work,
};

const STABILIZERS: [Option<(Kind, Work, f64)>; 12] = [
    None,
    Some((Kind::Popc, Work::Held, 0.5)),
    Some((Kind::Popc, Work::Held, 0.0)),
    Some((Kind::Popc, Work::Held, f64::INFINITY)),
    Some((Kind::Popc, Work::Sampled, 1.0)),
    Some((Kind::MassSpringDamper, Work::Held, 0.5)),
    Some((Kind::MassSpringDamper, Work::Held, f64::INFINITY)),
    Some((Kind::MassSpringDamper, Work::Sampled, 0.5)),
    Some((Kind::DeviceDamping, Work::Held, 0.25)),
    Some((Kind::DeviceDamping, Work::Sampled, 1.0)),
    Some((Kind::Spring, Work::Held, 1.0)),
    Some((Kind::Spring, Work::Sampled, 0.25)),
];

/// Both walls at one and two rates under each stabilizer, and corner cases that random numbers do not hit.
pub(crate) fn known() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for wall in [SOFT, STIFF] {
        for (rate, hold) in [(100.0, 1), (1e3, 10), (1e3, 1)] {
            for stabilizer in STABILIZERS {
                let mut scene = Scene::paper(wall).at(rate, hold).lasting(3.0);
                scene.stabilizer =
                    stabilizer.map(|(kind, work, cap)| Stabilizer { kind, work, cap });
                scene.terse = scenes.len() % 2 == 0;
                // Strides without a common factor: every effect meets every stabilizer, alone and together.
                if scenes.len() % 5 == 3 {
                    scene.velocity = Velocity::Exact;
                }
                scene.delay = [0, 0, 1, 0, 2, 0, 3][scenes.len() % 7];
                scene.encoder = [None, None, Some(1e-5), None, None][scenes.len() % 5];
                scene.saturation = [None, Some(1.0), None, None][(scenes.len() / 3) % 4];
                scenes.push(scene);
            }
        }
    }
    scenes.extend(corners());
    scenes
}

fn corners() -> Vec<Scene> {
    let stabilized =
        |kind| Scene::paper(SOFT).at(500.0, 5).lasting(2.0).with(kind, Work::Held, 0.5);
    let operator = |damping, stiffness, rest| Operator { mass: 0.05, damping, stiffness, rest };
    let mut scenes = Vec::new();
    for (damping, stiffness, rest) in [
        (4.0, 16.0, 0.003),
        (40.0, 200.0, -0.002),
        (0.0, 80.0, 0.004),
        (0.7, 0.0, 0.1),
        (0.0, 0.0, 0.0),
    ] {
        let mut scene = stabilized(Kind::Spring);
        scene.operator = operator(damping, stiffness, rest);
        scene.device.damping = 0.0;
        scene.initial.velocity = 0.1;
        scene.wall.position = 0.001;
        scenes.push(scene);
    }

    // Work and credit at n = 0 differ from zero only if the velocity is known at once.
    for kind in [Kind::MassSpringDamper, Kind::DeviceDamping] {
        for work in [Work::Held, Work::Sampled] {
            let mut scene = stabilized(kind).with(kind, work, 1.0);
            scene.velocity = Velocity::Exact;
            scene.initial = Initial { position: 0.002, velocity: -0.2 };
            scene.device.damping = 0.3;
            scenes.push(scene);
        }
    }

    let mut resting = stabilized(Kind::MassSpringDamper);
    resting.initial.position = 0.0;
    resting.operator = operator(0.2, 50.0, 0.0);
    scenes.push(resting);
    scenes
}

/// Starts on a half count that both scalars hold exactly. One bit decides their traces, but not their rows.
pub(crate) fn ties() -> Vec<Scene> {
    let tie = |counts| {
        let mut scene = Scene::paper(SOFT).lasting(2.0).with(Kind::Popc, Work::Held, 0.5);
        scene.encoder = Some(1.0 / 1024.0);
        scene.initial.position = counts / 1024.0;
        scene
    };
    [1.5, -2.5, 0.5, -0.5].map(tie).to_vec()
}

/// The scene without its encoder: near a half count one bit decides the measured position, which no tolerance of a
/// trace in f32 covers. Its rows can be checked.
pub(crate) fn without_encoder(mut scene: Scene) -> Scene {
    scene.encoder = None;
    scene
}

fn rates() -> impl Strategy<Value = (f64, usize)> {
    let servo = prop_oneof![
        3 => prop::sample::select(vec![50.0, 100.0, 250.0, 500.0, 1e3, 2e3]),
        1 => 37.3..3000.0,
    ];
    (servo, prop_oneof![2 => Just(1_usize), 3 => 2_usize..=20])
}

fn stabilizer() -> impl Strategy<Value = Option<Stabilizer>> {
    let kind = prop::sample::select(vec![
        Kind::Popc,
        Kind::MassSpringDamper,
        Kind::DeviceDamping,
        Kind::Spring,
    ]);
    let work = prop::sample::select(vec![Work::Held, Work::Held, Work::Sampled]);
    let cap = prop_oneof![
        4 => prop::sample::select(vec![0.0, 0.25, 0.5, 0.5, 1.0, f64::INFINITY]),
        1 => 0.0..2.0,
    ];
    let some = (kind, work, cap).prop_map(|(kind, work, cap)| Stabilizer { kind, work, cap });
    prop::option::weighted(0.85, some)
}

fn plant() -> impl Strategy<Value = (Operator, Device, Initial, Wall)> {
    let operator = (
        prop_oneof![1 => Just(0.0), 4 => 0.0..0.4],
        prop_oneof![1 => Just(0.0), 4 => 0.0..2.0, 1 => 2.0..30.0],
        prop_oneof![1 => Just(0.0), 4 => 0.0..500.0],
        prop_oneof![Just(0.0), -0.01..0.02],
    );
    let device = (0.05..0.8, prop_oneof![Just(0.001), Just(0.0), 0.0..1.0]);
    let initial = (-0.02..0.01, prop_oneof![Just(0.0), -0.3..0.3]);
    let wall = (
        prop_oneof![Just(0.0), -0.005..0.005],
        (2.0..4.9).prop_map(|decades| 10_f64.powf(decades)),
        prop_oneof![1 => Just(0.0), 4 => 0.0..30.0],
    );
    (operator, device, initial, wall).prop_map(|(o, d, i, w)| {
        let operator = Operator { mass: o.0, damping: o.1, stiffness: o.2, rest: o.3 };
        let device = Device { mass: d.0, damping: d.1 };
        let initial = Initial { position: i.0, velocity: i.1 };
        let wall = Wall { position: w.0, stiffness: w.1, damping: w.2 };
        (operator, device, initial, wall)
    })
}

pub(crate) fn scenes(scalar: Scalar, longest: f64) -> impl Strategy<Value = Scene> {
    let effects = (
        prop::option::weighted(0.3, prop_oneof![Just(1e-5), 1e-6..1e-3]),
        prop_oneof![2 => Just(0_usize), 3 => 1_usize..=3],
        prop::option::weighted(0.3, 0.2..20.0),
        prop::sample::select(vec![
            Velocity::BackwardDifference,
            Velocity::BackwardDifference,
            Velocity::Exact,
        ]),
        any::<bool>(),
    );
    let numbers = (0.1..longest, rates(), plant(), stabilizer(), effects);
    numbers.prop_map(move |(duration, rates, plant, stabilizer, effects)| {
        let (operator, device, initial, wall) = plant;
        let (encoder, delay, saturation, velocity, terse) = effects;
        let mut scene = Scene {
            duration,
            servo_rate: rates.0,
            hold: rates.1,
            velocity,
            scalar,
            operator,
            device,
            initial,
            wall,
            stabilizer,
            encoder,
            delay,
            saturation,
            terse,
        };
        // A cap of half is the default, whichever that is: a terse file leaves it out.
        let default = scene.default_cap();
        if let Some(stabilizer) = scene.stabilizer.as_mut().filter(|it| terse && it.cap == 0.5) {
            stabilizer.cap = default;
        }
        scene
    })
}
