//! Scenes under each integrator, against the exact motion.

use lyapunov_lab::scene::{Draft, Integrator, Positive, Scalar, StepsPerTick};
use lyapunov_lab::scenes::{SCENES, text_of};
use lyapunov_lab::{F64x8, Rollout, Scene, Space, Tick, in_space};

/// Rows that are compared: too few for errors to grow.
const ROWS: usize = 60;

fn shipped(name: &str) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
    Scene::load(format!("{folder}/{name}.toml").as_ref()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn moved_by(scene: &Scene, integrator: Integrator) -> Scene {
    let draft = Draft { integrator, ..scene.to_draft() };
    draft.check().unwrap_or_else(|conflict| panic!("{conflict}"))
}

/// The motion in the rows: each axis, and the operator's position where a link separates it from the device.
fn places(scene: &Scene) -> Vec<Vec<f64>> {
    in_space!(scene, Axes => {
        let place = |tick: Tick<Axes>| {
            let operator = tick.operator.map(|operator| operator.position);
            let positions = std::iter::once(tick.truth.position).chain(operator);
            positions.flat_map(|it| (0..Axes::DIMENSIONS).map(move |axis| it.axis(axis))).collect()
        };
        Rollout::<Axes>::of(scene).expect("a loop").take(ROWS).map(place).collect()
    })
}

/// Largest error as a share of the largest position, or of a millimetre if that is more.
fn error(scene: &Scene, integrator: Integrator) -> f64 {
    let (exact, other) = (places(scene), places(&moved_by(scene, integrator)));
    assert_eq!(exact.len(), other.len());
    assert!(exact.len() > 20);
    let of = |(one, other): (&Vec<f64>, &Vec<f64>)| (one[0] - other[0]).abs();
    let span = exact.iter().map(|place| place[0].abs()).fold(1e-3, f64::max);
    exact.iter().zip(&other).map(of).fold(0.0, f64::max) / span
}

fn steps(steps: i64) -> StepsPerTick {
    StepsPerTick::new(steps).expect("steps")
}

fn tolerance(tolerance: f64) -> Positive {
    Positive::new(tolerance).expect("a tolerance")
}

#[test]
fn every_shipped_scene_follows_the_exact_motion() {
    for shown in SCENES {
        let scene = shipped(shown.name);
        if scene.effects.friction.is_some() && scene.link.is_some() {
            continue;
        }
        let most = |integrator, most: f64| {
            let error = error(&scene, integrator);
            assert!(error < most, "{}, {integrator:?}: {error:e}", shown.name);
        };
        most(Integrator::SemiImplicitEuler { steps_per_tick: steps(8192) }, 1e-2);
        most(Integrator::ImplicitMidpoint { steps_per_tick: steps(256) }, 1e-3);
        most(Integrator::Rk4 { steps_per_tick: steps(32) }, 1e-6);
        most(Integrator::Dopri5 { tolerance: tolerance(1e-10) }, 1e-6);
        most(Integrator::Dop853 { tolerance: tolerance(1e-10) }, 1e-6);
    }
}

#[test]
fn steps_and_tolerance_reach_the_plant() {
    let scene = shipped("paper-8k-none");
    let rk4 = |count| error(&scene, Integrator::Rk4 { steps_per_tick: steps(count) });
    assert!(rk4(1) > 100.0 * rk4(4) && rk4(4) > 100.0 * rk4(16), "{} {}", rk4(1), rk4(4));
    let scene = shipped("link");
    let dopri5 = |most| error(&scene, Integrator::Dopri5 { tolerance: tolerance(most) });
    assert!(dopri5(1e-4) > 100.0 * dopri5(1e-9), "{} {}", dopri5(1e-4), dopri5(1e-9));
}

#[test]
fn single_precision_and_lanes_move_alike() {
    let double = shipped("hold");
    let exact = places(&double);
    let span = exact.iter().map(|place| place[0].abs()).fold(0.0, f64::max);
    for integrator in [
        Integrator::Rk4 { steps_per_tick: steps(4) },
        Integrator::ImplicitMidpoint { steps_per_tick: steps(64) },
        Integrator::Dopri5 { tolerance: tolerance(1e-6) },
        Integrator::Dop853 { tolerance: tolerance(1e-6) },
    ] {
        let single = Draft { scalar: Scalar::F32, ..double.to_draft() }.check().expect("in f32");
        let single = moved_by(&single, integrator);
        for (exact, single) in exact.iter().zip(places(&single)) {
            let error = (exact[0] - single[0]).abs();
            assert!(error < 1e-3 * span, "{integrator:?}: {error:e} m of {span:e} m");
        }
        let lanes = moved_by(&double, integrator);
        let wide = Rollout::<F64x8>::of(&lanes).expect("a loop").rows().take(ROWS);
        let narrow = Rollout::<f64>::of(&lanes).expect("a loop").rows();
        for (wide, narrow) in wide.zip(narrow) {
            assert_eq!(wide, narrow, "{integrator:?}");
        }
    }
}

#[test]
fn friction_behind_a_link_is_refused_by_name() {
    let text = text_of("friction").expect("a scene");
    let text = text.replacen("[device]", "[link]\nstiffness = 5000.0\n[device]", 1);
    let text = format!("integrator = \"rk4\"\n{text}");
    let fault = Scene::parse(&text, "both.toml").expect_err("both");
    assert_eq!(fault.key(), Some("effects.friction"), "{fault}");
    assert!(fault.to_string().contains("integrator = \"exact\""), "{fault}");
    assert!(Scene::parse(&text.replace("\"rk4\"", "\"exact\""), "both.toml").is_ok());
}

#[test]
fn too_stiff_a_scene_is_refused_with_the_integrator_to_take() {
    let text = text_of("hold").expect("a scene");
    let stiff = text
        .replace("duration = 2.0", "duration = 2.0\nintegrator = \"dopri5\"")
        .replace("stiffness = 200.0", "stiffness = 1e20");
    let fault = Scene::parse(&stiff, "stiff.toml").expect_err("too stiff");
    assert!(fault.to_string().contains("100000 steps"), "{fault}");
    assert!(fault.to_string().contains("integrator = \"exact\""), "{fault}");
}
