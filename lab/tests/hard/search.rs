//! Random scenes, in search of new hard cases: broken laws, and verdicts that differ between `f64` and `f32`.
//!
//! `HARD_SCENES=100000 cargo test --release -p lyapunov-lab --test hard search -- --nocapture` searches longer.

use std::cell::Cell;
use std::fmt::Write;

use lyapunov_lab::hard::{Tally, watch};
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{F64x8, Space};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};

/// Scenes of a run of the tests.
const SCENES: u32 = 400;

const SEED: u64 = 20_026;

/// Ticks of a scene.
const TICKS: f64 = 400.0;

fn decades(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|decades| 10_f64.powf(decades))
}

fn rarely<S: Strategy>(some: S) -> impl Strategy<Value = Option<S::Value>> {
    prop::option::weighted(0.25, some)
}

/// The period, s, and the scene. Wall and hand are drawn relative to the tick, so that most scenes are neither trivial
/// nor hopeless.
fn loops() -> impl Strategy<Value = (f64, String)> {
    let sizes = (decades(-2.0, 4.5), decades(-4.0, 4.0), decades(-7.0, 1.0));
    let wall = (decades(-4.0, 1.5), prop::option::weighted(0.5, decades(-4.0, 0.3)), -1.0..1.0);
    let hand = (decades(-9.0, -2.0), decades(-7.0, -1.0), 0.0..1.0);
    let motion = (-3.0..1.0, -1.0..1.0, -2.0..2.0);
    let cap = prop_oneof![
        Just("0".to_owned()),
        Just("0.5".to_owned()),
        Just("inf".to_owned()),
        (0.0..2.0).prop_map(|cap: f64| cap.to_string()),
    ];
    let stabilizer = (0..4_usize, cap, any::<bool>());
    (sizes, wall, hand, motion, stabilizer).prop_map(
        |((rate, mass, length), wall, hand, motion, stabilizer)| {
            let (stiffness, damping) = (mass * rate * rate, mass * rate);
            let mut text = format!("duration = {:e}\nservo_rate = {rate:e}\n", TICKS / rate);
            let operator = hand.2 * mass;
            let _ = write!(
                text,
                "operator = {{ mass = {operator:e}, damping = {:e}, stiffness = {:e}, rest = {:e} }}\n\
                 device = {{ mass = {:e}, damping = {:e} }}\n",
                hand.1 * damping,
                hand.0 * stiffness,
                motion.1 * length,
                mass - 0.999 * operator,
                0.1 * hand.1 * damping
            );
            let _ = write!(
                text,
                "initial = {{ position = {:e}, velocity = {:e} }}\n\
                 environment.wall = {{ position = {:e}, stiffness = {:e}, damping = {:e} }}\n",
                motion.0 * length,
                motion.2 * 0.1 * length * rate,
                0.1 * wall.2 * length,
                wall.0 * stiffness,
                wall.1.unwrap_or(0.0) * damping
            );
            let (kind, cap, exact) = stabilizer;
            let name = ["popc", "lolc", "lolc", "popc"][kind];
            let _ = writeln!(text, "[stabilizer.{name}]\ndamping_cap = {cap}");
            if name == "lolc" {
                let candidate = ["device-damping", "mass-spring-damper"][kind - 1];
                let _ = writeln!(text, "candidate = \"{candidate}\"");
            }
            // The velocity is a key of the scene and not of a table, so it comes first.
            let text = if exact { format!("velocity = \"exact\"\n{text}") } else { text };
            (1.0 / rate, text)
        },
    )
}

fn scenes() -> impl Strategy<Value = String> {
    let lengths = decades(-7.0, -3.0);
    let effects = (
        rarely(lengths),
        rarely(0..6_u32),
        rarely(decades(-3.0, 4.0)),
        rarely((0.0..0.9, any::<u32>(), any::<bool>())),
        rarely((decades(-4.0, -0.5), any::<u32>())),
        rarely((decades(-9.0, -4.0), any::<u32>())),
    );
    (loops(), effects).prop_map(|((period, mut text), effects)| {
        let (encoder, delay, saturation, dropout, jitter, noise) = effects;
        let mut put = |key: &str, value: String| {
            let _ = writeln!(text, "[effects.{key}]\n{value}");
        };
        if let Some(it) = encoder {
            put("encoder", format!("resolution = {it:e}"));
        }
        if let Some(it) = delay {
            put("delay", format!("ticks = {it}"));
        }
        if let Some(it) = saturation {
            put("saturation", format!("force = {it:e}"));
        }
        if let Some((probability, seed, holds)) = dropout {
            let policy = if holds { "hold" } else { "zero" };
            put(
                "dropout",
                format!("probability = {probability:e}\npolicy = \"{policy}\"\nseed = {seed}"),
            );
        }
        if let Some((deviation, seed)) = jitter {
            put("jitter", format!("deviation = {:e}\nseed = {seed}", deviation * period));
        }
        if let Some((deviation, seed)) = noise {
            put("noise", format!("deviation = {deviation:e}\nseed = {seed}"));
        }
        text
    })
}

fn first<V: Space>(scene: &Scene) -> Option<Tally> {
    watch::<V>(scene).ok()?.first().copied()
}

/// Whether the swing of the last quarter is far beyond the start (true) or within it (false); none in between.
fn grows(scene: &Scene, tally: &Tally) -> Option<bool> {
    let (start, speed) = (scene.initial.position.get().abs(), scene.initial.velocity.get().abs());
    let rest = scene.operator.rest.get().abs();
    let size = start + rest + speed * scene.duration.get();
    match tally.late_swing / size {
        share if share > 1e4 || !share.is_finite() => Some(true),
        share if share < 10.0 => Some(false),
        _ => None,
    }
}

/// Whether nothing limits the damping.
fn uncapped(scene: &Scene) -> bool {
    scene.written_cap().is_some_and(f64::is_infinite)
}

fn check(text: &str) -> Result<(), String> {
    let scene = Scene::parse(text, "random").map_err(|error| format!("{error}\n{text}"))?;
    let double = first::<f64>(&scene).ok_or("no f64")?;
    let lanes = first::<F64x8>(&scene).ok_or("no lanes")?;
    let found = |what: String| Err(format!("{what}\n{text}"));
    if double != lanes {
        return found(format!("lanes differ: {double:?} and {lanes:?}"));
    }
    // A scene whose numbers do not fit f32 is not run in f32.
    let single = first::<f32>(&scene);
    for tally in [Some(double), single].into_iter().flatten() {
        // An uncapped run can leave the range of the scalar within one tick.
        if uncapped(&scene) && tally.out_of_range.is_some() {
            continue;
        }
        if let Some((law, tick)) = tally.broken {
            return found(format!("tick {tick}: {law}: {tally:?}"));
        }
    }
    let verdicts = [Some(double), single].map(|tally| tally.and_then(|it| grows(&scene, &it)));
    match verdicts {
        // The effect of an uncapped damper depends on rounding.
        [Some(one), Some(other)] if one != other && !uncapped(&scene) => {
            found(format!("f64 {double:?}\nf32 {single:?}"))
        }
        _ => Ok(()),
    }
}

#[test]
fn random_scenes_break_no_law() {
    let cases = std::env::var("HARD_SCENES").ok().and_then(|number| number.parse().ok());
    let cases = cases.unwrap_or(SCENES);
    let config = Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(SEED),
        max_shrink_iters: 200,
        ..Config::default()
    };
    let tried = Cell::new(0_u32);
    let checked = |text: String| {
        tried.set(tried.get() + 1);
        check(&text).map_err(TestCaseError::fail)
    };
    if let Err(error) = TestRunner::new(config).run(&scenes(), checked) {
        panic!("after {} scenes: {error}", tried.get());
    }
    println!("{} scenes", tried.get());
}
