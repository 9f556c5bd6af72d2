//! Tuning, against runs that are summed up by other code.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, Ordering};

use approx::assert_relative_eq;
use lyapunov::{DampingLimit, Popc, PortEnergy};
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::tune::{Change, Objective, TuneError, Tuned, Tuning, document, table};
use lyapunov_lab::{AnyStabilizer, Ensemble, Rollout, Scene, Summary, Verdict};

const SCENE: &str = "duration = 2.0\nservo_rate = 500.0\n\
    operator = { mass = 0.1, damping = 1.0, stiffness = 200.0, rest = 0.01 }\n\
    device = { mass = 0.2, damping = 0.1 }\nenvironment_rate = 100.0\n";
const WALL: &str = "environment.wall = { position = 0.002, stiffness = 1500.0, damping = 1.0 }\n";

fn scene(more: &str) -> Scene {
    let text = format!("{SCENE}{}{more}", if more.contains("environment") { "" } else { WALL });
    Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"))
}

fn name(name: &str) -> StabilizerName {
    name.parse().unwrap()
}

fn tuning() -> Tuning {
    Tuning { trials: 12, runs: 4, ..Tuning::default() }
}

fn tuned(tuning: &Tuning, scene: &Scene, of: &str) -> Result<Tuned, TuneError> {
    tuning.of(scene, name(of), &|_| ControlFlow::Continue(()))
}

/// Members that tuning saw, and members that it never saw, of an ensemble with its own seed.
const SEEN: Range<u64> = 0..4;
const UNSEEN: Range<u64> = 1 << 32..(1 << 32) + 8;

/// Mean settling of POPC with a cap over some members of the ensemble, and how many of these are bounded.
fn settling(scene: &Scene, cap: f64, members: Range<u64>) -> (usize, f64) {
    let Tuning { seed, moves, .. } = Tuning::default();
    let ensemble = Ensemble { seed, moves };
    let runs = members.map(|member| {
        let moved = ensemble.member(scene, member).unwrap();
        // The stabilizer knows the mass of the scene as it is written, and the plant has another.
        let limit = DampingLimit::of_mass(cap, 0.1 + 0.2, 1.0 / 500.0);
        let popc = AnyStabilizer::new(Popc::new(PortEnergy, limit.unwrap()));
        let summary = Summary::of(&moved, Rollout::<f64>::stabilized_by(&moved, popc).unwrap());
        let settles = summary.verdict() == Verdict::Settles;
        (summary.verdict() != Verdict::Grows)
            .then(|| summary.settled.filter(|_| settles).unwrap_or(moved.duration.get()))
    });
    let costs: Vec<f64> = runs.flatten().collect();
    (costs.len(), costs.iter().sum::<f64>() / costs.len() as f64)
}

#[test]
fn costs_are_those_of_the_runs_and_tuning_beats_a_grid_of_caps_on_what_it_saw() {
    let (scene, tuning) = (scene(""), tuning());
    let tuned = tuned(&tuning, &scene, "popc").unwrap();
    let [default, best] = tuned.settings.each_ref().map(|it| it.numbers()[0].value);
    assert_eq!(default, 0.5);
    for (cap, judged) in [default, best].into_iter().zip(&tuned.judged) {
        let (bounded, mean) = settling(&scene, cap, UNSEEN);
        assert_eq!((judged.runs(), judged.bounded()), (8, bounded));
        assert_relative_eq!(judged.cost().unwrap(), mean, max_relative = 1e-12);
    }
    let (bounded, seen) = settling(&scene, best, SEEN);
    assert_eq!((tuned.seen.runs(), tuned.seen.bounded()), (4, bounded));
    assert_relative_eq!(tuned.seen.cost().unwrap(), seen, max_relative = 1e-12);
    assert!(settling(&scene, default, SEEN).1 >= seen);
    for cap in [0.05, 0.1, 0.2, 0.4, 0.8] {
        let (bounded, mean) = settling(&scene, cap, SEEN);
        assert!(bounded < 4 || mean > 0.9 * seen, "cap {cap}: {mean} s, tuned {best}: {seen} s");
    }
    // The scene that is printed is the one that was judged.
    let ready = Scene::parse(&tuned.text().unwrap(), "tuned.toml").unwrap();
    assert_eq!(ready, tuned.scene);
    assert_eq!(ready, name("popc").written_in(&scene, &[("damping_cap", best)]).unwrap());
}

#[test]
fn each_stabilizer_gets_as_many_runs_and_the_result_is_the_same_on_any_threads() {
    let (scene, tuning) = (scene(""), Tuning { trials: 3, runs: 2, ..tuning() });
    let on = |threads: usize, of: &str| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let runs = AtomicU64::new(0);
        let watch = |more| {
            runs.fetch_add(more, Ordering::Relaxed);
            ControlFlow::Continue(())
        };
        let tuned = pool.install(|| tuning.of(&scene, name(of), &watch)).unwrap();
        (document("test", &tuning, &[tuned]), runs.into_inner())
    };
    for of in ["popc", "tank", "popc-spread", "virtual-coupling"] {
        let (text, runs) = on(1, of);
        assert_eq!(runs, tuning.rollouts(), "{of}");
        assert_eq!(on(3, of), (text, runs), "{of}");
    }
}

#[test]
fn every_member_of_the_family_can_be_tuned() {
    let short = Scene::parse(&format!("{SCENE}{WALL}").replace("2.0\nservo", "0.5\nservo"), "test");
    let (scene, tuning) = (short.unwrap(), Tuning { trials: 2, runs: 2, ..tuning() });
    for member in StabilizerName::ALL {
        let tuned = tuned(&tuning, &scene, member.name()).unwrap();
        for number in tuned.settings[1].numbers() {
            assert!(number.value.is_finite(), "{member}: {number:?}");
        }
        if tuned.settings[1].numbers().is_empty() {
            assert_eq!(tuned.change(), Change::Undecided, "{member}");
            assert_eq!(tuned.judged[0], tuned.judged[1], "{member}");
        }
    }
}

/// 0.8 of `m / T`, 0.3 kg at 500 Hz, are 120 N·s/m; two ticks late the limit is `0.5 tan(π / 12)`.
#[test]
fn a_cap_above_the_limit_of_the_delay_is_told_and_each_cap_as_a_limit() {
    let tuning = Tuning { trials: 1, runs: 2, ..tuning() };
    let told = |more: &str| {
        let scene = scene(&format!("[stabilizer.popc]\ndamping_cap = 0.8\n{more}"));
        let tuned = tuned(&tuning, &scene, "popc").unwrap();
        let text = table("test", &tuning, &[tuned]);
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let (late, prompt) = (told("[effects.delay]\nticks = 2\n"), told(""));
    for text in [&late, &prompt] {
        assert!(text.contains("note: a tuned damping_cap may stand close to the floor"), "{text}");
        assert!(!text.contains("a saturation may bound"), "{text}");
    }
    let limited = told("[effects.saturation]\nforce = 30\n");
    assert!(limited.contains("note: a saturation may bound a run"), "{limited}");
    assert!(late.contains("note: popc default"), "{late}");
    let sentence = "the damping cap is above 0.133974596 m / T, the limit for a delay of 2 ticks";
    assert!(late.contains(sentence), "{late}");
    assert!(!prompt.contains("the limit for a delay"), "{prompt}");
    for text in [late, prompt] {
        assert!(text.contains("damping_cap 0.8 ") && text.contains("damping limit 120 "), "{text}");
    }
}

#[test]
fn an_objective_that_the_scene_says_nothing_about_is_refused() {
    let told = |scene: &Scene, objective: &str| {
        let objective: Objective = objective.parse().unwrap();
        tuned(&Tuning { objective, ..tuning() }, scene, "popc").unwrap_err().to_string()
    };
    let spring = scene("environment.spring.stiffness = 100.0\n");
    let error = told(&spring, "settling,stiffness");
    assert!(error.contains("`stiffness` needs a wall"), "{error}");
    assert!(error.ends_with("another objective: settling"), "{error}");
    let moving =
        "environment.moving-wall = { stiffness = 100, amplitude = 0.001, frequency = 2 }\n";
    let error = told(&scene(moving), "force-error");
    assert!(error.ends_with("there is no objective for it: compare its stabilizers"), "{error}");
    let loose = scene("").to_draft();
    let sine = lyapunov_lab::scene::Motion::Sine {
        amplitude: 0.01.try_into().unwrap(),
        frequency: 1.0.try_into().unwrap(),
    };
    let operator = lyapunov_lab::scene::Operator { motion: Some(sine), ..loose.operator.clone() };
    let led = lyapunov_lab::scene::Draft { operator, ..loose }.check().unwrap();
    assert!(
        told(&led, "settling").contains("`settling` needs a place"),
        "{}",
        told(&led, "settling")
    );
    let stopped = tuning().of(&scene(""), name("popc"), &|_| ControlFlow::Break(()));
    assert_eq!(stopped.unwrap_err(), TuneError::Stopped);
}
