//! Valid scenes and their values.

use super::{FULL, scene, smallest_and, with};
use crate::files::scene::keys::SMALLEST;
use crate::files::scene::*;

fn positive(value: f64) -> Positive {
    Positive::new(value).unwrap()
}

fn non_negative(value: f64) -> NonNegative {
    NonNegative::new(value).unwrap()
}

fn finite(value: f64) -> Finite {
    Finite::new(value).unwrap()
}

#[test]
fn the_full_example_gives_every_value() {
    let expected = Draft {
        duration: positive(10.0),
        servo_rate: positive(100.0),
        environment_rate: Some(positive(100.0)),
        velocity: Velocity::BackwardDifference,
        scalar: Scalar::F64,
        integrator: Integrator::Exact,
        operator: Operator {
            mass: non_negative(0.1),
            damping: non_negative(0.2),
            stiffness: non_negative(50.0),
            rest: finite(0.0).into(),
            motion: None,
            grip: None,
        },
        device: Device { mass: positive(0.2), damping: non_negative(0.001) },
        link: None,
        space: None,
        initial: Initial { position: finite(-0.004).into(), velocity: finite(0.0).into() },
        environment: Environment::Wall(Wall {
            position: finite(0.0),
            stiffness: non_negative(8000.0),
            damping: non_negative(2.0),
        }),
        stabilizer: Some(Stabilizer::Lolc(Lolc {
            work: Work::Held,
            candidate: Candidate::MassSpringDamper,
            ledger: Ledger::Plain,
            damping_cap: Some(Cap::new(0.5).unwrap()),
        })),
        effects: Effects {
            encoder: Some(Encoder { resolution: positive(1e-5) }),
            delay: Some(Delay { ticks: DelayTicks::new(2).unwrap() }),
            saturation: Some(Saturation { force: positive(8.0) }),
            ..Effects::default()
        },
    };
    assert_eq!(*scene(FULL), expected);
    assert_eq!(expected.ticks(), 1000);
    assert_eq!(expected.environment_ratio(), 1);
    assert_eq!(expected.period(), 0.01);
}

#[test]
fn the_smallest_scene_takes_every_default() {
    let scene = scene(SMALLEST);
    assert_eq!(scene.environment_rate, None);
    assert_eq!(scene.environment_rate(), scene.servo_rate.get());
    assert_eq!(scene.environment_ratio(), 1);
    assert_eq!(scene.velocity, Velocity::BackwardDifference);
    assert_eq!(scene.scalar, Scalar::F64);
    assert_eq!(scene.integrator, Integrator::Exact);
    assert_eq!(scene.device.damping.get(), 0.0);
    let operator = &scene.operator;
    assert_eq!(
        (
            operator.mass.get(),
            operator.damping.get(),
            operator.stiffness.get(),
            operator.rest.get()
        ),
        (0.0, 0.0, 0.0, 0.0)
    );
    assert_eq!((scene.initial.position.get(), scene.initial.velocity.get()), (0.0, 0.0));
    let Environment::Wall(wall) = scene.environment else { panic!("{:?}", scene.environment) };
    assert_eq!((wall.position.get(), wall.damping.get()), (0.0, 0.0));
    assert_eq!(scene.stabilizer, None);
    assert_eq!(scene.effects, Effects::default());
}

#[test]
fn an_empty_stabilizer_table_takes_its_defaults() {
    let lolc = Lolc {
        work: Work::Held,
        candidate: Candidate::MassSpringDamper,
        ledger: Ledger::Plain,
        damping_cap: None,
    };
    let popc = Popc { work: Work::Held, ledger: Ledger::Plain, damping_cap: None };
    let stabilizer = |more| scene(&smallest_and(more)).stabilizer;
    assert_eq!(stabilizer("[stabilizer.lolc]"), Some(Stabilizer::Lolc(lolc)));
    assert_eq!(stabilizer("[stabilizer.popc]"), Some(Stabilizer::Popc(popc)));
}

#[test]
fn every_word_is_known() {
    let lolc = |part, replacement| match scene(&with(part, replacement)).stabilizer {
        Some(Stabilizer::Lolc(lolc)) => lolc,
        other => panic!("{other:?}"),
    };
    assert_eq!(scene(&with("\"backward-difference\"", "\"exact\"")).velocity, Velocity::Exact);
    assert_eq!(scene(&with("\"f64\"", "\"f32\"")).scalar, Scalar::F32);
    assert_eq!(lolc("\"held\"", "\"sampled\"").work, Work::Sampled);
    let candidate = |word| lolc("\"mass-spring-damper\"", word).candidate;
    assert_eq!(candidate("\"device-damping\""), Candidate::DeviceDamping);
    assert_eq!(candidate("\"spring\""), Candidate::Spring);
    let ledger = |word| {
        let text = format!("[stabilizer.popc]\nledger = {word}");
        match scene(&smallest_and(&text)).stabilizer {
            Some(Stabilizer::Popc(popc)) => popc.ledger,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(ledger("\"plain\""), Ledger::Plain);
    assert_eq!(ledger("\"compensated\""), Ledger::Compensated);
    assert_eq!(ledger("\"wide\""), Ledger::Wide);
}

#[test]
fn an_integrator_has_the_keys_that_apply_to_it_and_their_defaults() {
    let integrator = |text: &str| scene(&with("integrator = \"exact\"", text)).integrator;
    let steps_per_tick = |steps| StepsPerTick::new(steps).unwrap();
    let one = steps_per_tick(1);
    #[rustfmt::skip]
    let cases = [
        ("", Integrator::Exact),
        ("integrator = \"semi-implicit-euler\"", Integrator::SemiImplicitEuler { steps_per_tick: one }),
        ("integrator = \"implicit-midpoint\"", Integrator::ImplicitMidpoint { steps_per_tick: one }),
        ("integrator = \"rk4\"", Integrator::Rk4 { steps_per_tick: one }),
        ("integrator = \"rk4\"\nsteps_per_tick = 4", Integrator::Rk4 { steps_per_tick: steps_per_tick(4) }),
        ("steps_per_tick = 1000000\nintegrator = \"rk4\"", Integrator::Rk4 { steps_per_tick: steps_per_tick(1_000_000) }),
        ("integrator = \"dopri5\"", Integrator::Dopri5 { tolerance: positive(1e-9) }),
        ("integrator = \"dop853\"", Integrator::Dop853 { tolerance: positive(1e-9) }),
        ("integrator = \"dop853\"\ntolerance = 1e-12", Integrator::Dop853 { tolerance: positive(1e-12) }),
    ];
    for (text, expected) in cases {
        assert_eq!(integrator(text), expected, "{text}");
        let scene = scene(&with("integrator = \"exact\"", text));
        let written = toml::to_string(&scene).unwrap();
        assert_eq!(super::scene(&written), scene, "{written}");
        let read: Draft = toml::from_str(&written).unwrap();
        assert_eq!(read, *scene);
    }
    let single = with("\"f64\"", "\"f32\"").replace("\"exact\"", "\"dopri5\"");
    assert_eq!(scene(&single).integrator, Integrator::Dopri5 { tolerance: positive(1e-6) });
}

#[test]
fn an_integrator_reports_its_word_and_its_numbers() {
    let told = |text: &str| {
        let it = scene(&with("integrator = \"exact\"", text)).integrator;
        (it.name(), it.steps_per_tick(), it.tolerance())
    };
    assert_eq!(told(""), ("exact", None, None));
    assert_eq!(told("integrator = \"rk4\"\nsteps_per_tick = 3"), ("rk4", Some(3), None));
    assert_eq!(told("integrator = \"dopri5\"\ntolerance = 1e-7"), ("dopri5", None, Some(1e-7)));
}

#[test]
fn whole_numbers_stand_for_reals() {
    assert_eq!(scene(&with("duration = 10.0", "duration = 10")).duration.get(), 10.0);
    assert_eq!(scene(&with("rest = 0.0", "rest = -3")).operator.rest.get(), -3.0);
    assert_eq!(scene(&with("rest = 0.0", "rest = 0x10")).operator.rest.get(), 16.0);
    assert_eq!(scene(&with("rest = 0.0", "rest = 1_000")).operator.rest.get(), 1000.0);
    let force = |number: &str| {
        let scene = scene(&with("force = 8.0", &format!("force = {number}")));
        scene.effects.saturation.unwrap().force.get()
    };
    assert_eq!(force("9007199254740993"), 9007199254740992.0);
    assert_eq!(force("9223372036854775807"), 9223372036854775808.0);
    assert_eq!(force("100000000000000000000000"), 1e23);
    assert_eq!(force("0xffffffffffffffffff"), 4722366482869645213695.0);
}

#[test]
fn values_that_may_be_zero_accept_zero() {
    for part in
        ["mass = 0.1", "damping = 0.2", "stiffness = 50.0", "damping = 0.001", "stiffness = 8000.0"]
    {
        let (key, _) = part.split_once(" = ").unwrap();
        scene(&with(part, &format!("{key} = 0")));
        scene(&with(part, &format!("{key} = -0.0")));
    }
    let delay = scene(&with("ticks = 2 ", "ticks = 0 ")).effects.delay;
    assert_eq!(delay.unwrap().ticks.get(), 0);
    let delay = scene(&with("ticks = 2 ", "ticks = 1024 ")).effects.delay;
    assert_eq!(delay.unwrap().ticks.get(), 1024);
}

#[test]
fn a_cap_may_be_zero_or_infinite() {
    let cap = |number: &str| {
        let text = format!("[stabilizer.popc]\ndamping_cap = {number}");
        match scene(&smallest_and(&text)).stabilizer {
            Some(Stabilizer::Popc(popc)) => popc.damping_cap.unwrap().get(),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(cap("0").to_bits(), 0.0_f64.to_bits());
    assert_eq!(cap("-0.0").to_bits(), 0.0_f64.to_bits());
    assert_eq!(cap("inf"), f64::INFINITY);
    assert_eq!(cap("+inf"), f64::INFINITY);
}

#[test]
fn any_toml_spelling_and_line_end_is_the_same_scene() {
    let expected = scene(SMALLEST);
    let dotted = "duration=1\nservo_rate=1e3\ndevice.mass=0.2\nenvironment.wall.stiffness=8e3";
    let inline = "environment = { wall = { stiffness = 8_000 } }\ndevice = { mass = 2e-1 }\n\
                  servo_rate = 1000\nduration = +1.0";
    assert_eq!(scene(dotted), expected);
    assert_eq!(scene(inline), expected);
    assert_eq!(scene(&SMALLEST.replace('\n', "\r\n")), expected);
    assert_eq!(scene(&format!("\u{feff}{SMALLEST}")), expected);
    assert_eq!(scene(&smallest_and("[operator]\n[initial]\n[effects]")), expected);
}

#[test]
fn ticks_are_rounded_and_may_be_zero() {
    let ticks = |duration: &str, rate: &str| {
        let text = SMALLEST.replace("duration = 1.0", &format!("duration = {duration}"));
        scene(&text.replace("1000.0", rate)).ticks()
    };
    assert_eq!(ticks("1e-6", "1000"), 0);
    assert_eq!(ticks("0.0005", "1000"), 1);
    assert_eq!(ticks("0.3", "10"), 3);
    assert_eq!(ticks("1e6", "1000"), 1_000_000_000);
    assert_eq!(ticks("1e-100", "1e-100"), 0);
}

#[test]
fn rates_divide_within_the_tolerance() {
    let ratio = |rate: &str| {
        let text = format!("environment_rate = {rate}\n{SMALLEST}");
        scene(&text).environment_ratio()
    };
    assert_eq!(ratio("1000"), 1);
    assert_eq!(ratio("100"), 10);
    assert_eq!(ratio("333.3333333333333"), 3);
    assert_eq!(ratio("1000.0000000001"), 1);
    assert_eq!(ratio("1e-300"), u64::MAX);
}

#[test]
fn a_scene_survives_being_written() {
    for text in [FULL, SMALLEST, &with("damping_cap = 0.5", "damping_cap = inf")] {
        let scene = scene(text);
        let written = toml::to_string(&scene).unwrap();
        assert_eq!(super::scene(&written), scene, "{written}");
    }
}

/// A cap that nobody wrote is none of the copy either: it would stay where a delay is added.
#[test]
fn a_cap_that_is_left_out_stays_left_out() {
    let bare = format!("{SMALLEST}\n[stabilizer.popc]\n");
    let delayed = format!("{bare}\n[effects.delay]\nticks = 3\n");
    for text in [FULL, SMALLEST, &bare, &delayed] {
        let scene = scene(text);
        let written = toml::to_string(&scene.as_written()).unwrap();
        assert_eq!(super::scene(&written), scene, "{written}");
    }
    let written = toml::to_string(&scene(&bare).as_written()).unwrap();
    let later = super::scene(&format!("{written}\n[effects.delay]\nticks = 3\n"));
    assert_eq!(later.damping_cap(), scene(&delayed).damping_cap());
    // What is told of a run has every number.
    assert!(toml::to_string(&scene(&bare)).unwrap().contains("damping_cap = 0.5"));
}

#[test]
fn a_changed_draft_is_a_scene_once_it_is_checked() {
    let mut draft = scene(FULL).to_draft();
    draft.servo_rate = positive(150.0);
    let conflict = draft.clone().check().unwrap_err();
    assert_eq!(conflict.key(), "environment_rate");
    draft.environment_rate = Some(positive(50.0));
    let scene = draft.clone().check().unwrap();
    assert_eq!((&*scene, scene.environment_ratio()), (&draft, 3));
    draft.duration = positive(f64::MAX);
    assert_eq!(draft.clone().check().unwrap_err().key(), "duration");
    // No derived value may panic, checked or not.
    assert_eq!(draft.ticks(), u64::MAX);
}

#[test]
fn quantities_accept_exactly_their_range() {
    let accepted: Vec<[bool; 4]> = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0, 5e-324]
        .iter()
        .map(|value| {
            let value = *value;
            [
                Positive::new(value).is_ok(),
                NonNegative::new(value).is_ok(),
                Finite::new(value).is_ok(),
                Cap::new(value).is_ok(),
            ]
        })
        .collect();
    let expected = [
        [false, false, false, false],
        [false, false, false, true],
        [false, false, false, false],
        [false, false, true, false],
        [false, true, true, true],
        [true, true, true, true],
    ];
    assert_eq!(accepted, expected);
}
