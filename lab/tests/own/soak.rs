//! A soak and a sweep of faults find whoever makes a mistake.

use std::ops::ControlFlow;

use lyapunov::laws::Law;
use lyapunov::{Correction, Mask, ParameterError, PortSample, Scalar, Signal, Stabilizer};
use lyapunov_lab::hard::faults::{Broken, sweep};
use lyapunov_lab::hard::soak::{Breach, Soak, breach};
use lyapunov_lab::own::{Loop, OwnNumber, OwnStabilizer, Promise};

use super::{CAP, Hand, hand, name, parsed, shipped};

// Beyond its limit, wherever positions are counted.
own!(Hasty, "hasty", [CAP], Damps, |on| hand::<V::Scalar>(on, 1.0).map(|hand| {
    let counts = on.scene().is_some_and(|scene| scene.effects.encoder.is_some());
    let factor = V::Scalar::of(if counts { 1.5 } else { 1.0 });
    Hand { limit: hand.limit * factor, ..hand }
}));

/// A hand that makes a mistake.
struct Mistaken<T> {
    hand: Hand<T>,
    mistake: Mistake,
    tick: u64,
}

enum Mistake {
    /// Half of the damping that it tells.
    Halves,
    /// A tick now and then without the work of its sample.
    Dozes,
    /// Nothing that it accepts on the tick after one that it rejected.
    IsDazed { rejected: bool },
}

impl<V: Signal> Stabilizer<V> for Mistaken<V::Scalar> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.tick += 1;
        match self.mistake {
            Mistake::Halves => {
                let told = self.hand.stabilize(sample, effort);
                let half = (told.effort - effort).scale(V::Scalar::of(0.5));
                let corrected = V::choose(told.accepted, effort + half, told.effort);
                Correction { effort: corrected, ..told }
            }
            Mistake::Dozes if self.tick % 37 == 5 => {
                self.hand.stabilize(&PortSample { work: V::zero(), ..*sample }, effort)
            }
            Mistake::Dozes => self.hand.stabilize(sample, effort),
            Mistake::IsDazed { rejected } => {
                let told = self.hand.stabilize(sample, effort);
                self.mistake = Mistake::IsDazed { rejected: !told.accepted.all() };
                let refused = Correction {
                    effort: V::zero(),
                    alpha: V::Scalar::of(0.0),
                    accepted: Mask::of(false),
                    ..told
                };
                if rejected { refused } else { told }
            }
        }
    }
}

fn mistaken<T: Scalar>(on: &Loop<'_>, mistake: Mistake) -> Result<Mistaken<T>, ParameterError> {
    Ok(Mistaken { hand: hand(on, 1.0)?, mistake, tick: 0 })
}

own!(Halving, "halving", [CAP], Damps, |on| mistaken::<V::Scalar>(on, Mistake::Halves));
own!(Dazed, "dazed", [CAP], Damps, |on| mistaken::<V::Scalar>(
    on,
    Mistake::IsDazed { rejected: false }
));
// Damps in the scalar of more digits only.
own!(Exacting, "exacting", [CAP], Damps, |on| hand::<V::Scalar>(on, 1.0).map(|hand| {
    let share = if V::Scalar::epsilon().below(V::Scalar::of(1e-10)).all() { 1.0 } else { 0.0 };
    Hand { limit: hand.limit * V::Scalar::of(share), ..hand }
}));
own!(Dozing, "dozing", [CAP], Serves, |on| mistaken::<V::Scalar>(on, Mistake::Dozes));

#[test]
fn a_soak_finds_a_broken_promise_and_the_smallest_scene_that_breaks_it() {
    let soaked = |it: &str| {
        let soak = Soak { seed: 1, stabilizer: Some(name(it)) };
        soak.run(&mut |cases| match cases < 512 {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        })
    };
    assert_eq!(soaked("my-popc").found, None);
    for (mistaken, broken) in [("halving", Law::Injects), ("dozing", Law::Balances)] {
        let told = soaked(mistaken);
        let found = told.found.as_ref().expect("a broken promise");
        assert!(matches!(found.broken, Breach::Law { law, .. } if law == broken), "{told}");
        // Without the stabilizer there is no promise to be broken.
        assert!(found.scene.contains(&format!("[stabilizer.{mistaken}]")), "{told}");
    }
    let told = soaked("hasty");
    let found = told.found.clone().expect("a broken promise");
    assert!(matches!(found.broken, Breach::Law { law: Law::WithinLimit, .. }), "{told}");
    assert_eq!(soaked("hasty"), told);

    let text = found.file("lyapunov hard soak.toml");
    assert_eq!(breach(&parsed(&text)).unwrap(), Some(found.broken), "{text}");
    let table: toml::Table = text.parse().unwrap();
    let effects: Vec<_> = table["effects"].as_table().unwrap().keys().collect();
    assert_eq!(effects, ["encoder"], "{text}");
    let tables: Vec<_> = table.keys().filter(|key| table[*key].is_table()).collect();
    assert!(tables.len() <= 5 && !text.contains("link"), "{text}");
    // A run as long as it takes to break it.
    assert!(parsed(&text).ticks() < 50, "{text}");
}

/// A held wall of 5 kN/m on 0.3 kg at 100 Hz, `K T² / m = 1.7`, runs away alone and swings under POPC.
#[test]
fn a_loop_that_runs_away_in_one_scalar_only_breaks_a_promise() {
    let text = |stabilizer: &str| {
        format!(
            "duration = 10.0
            servo_rate = 100.0
            operator = {{ mass = 0.1, damping = 0.2, stiffness = 50.0 }}
            device = {{ mass = 0.2, damping = 0.1 }}
            initial.position = -0.004
            environment.wall.stiffness = 5000.0
            stabilizer.{stabilizer} = {{}}"
        )
    };
    name("exacting");
    let found = breach(&parsed(&text("exacting"))).unwrap();
    assert_eq!(found, Some(Breach::RunsAway { numbers: "f32" }));
    // In both, or in neither, is no fault of a scalar.
    for right in ["idle", "my-popc"] {
        assert_eq!(breach(&parsed(&text(right))).unwrap(), None, "{right}");
    }
}

// A loop that runs away until a damper of 2.5e-44 N s/m, less than the smallest normal number, is left to spread.
#[test]
fn a_damping_is_judged_to_the_digits_that_it_has() {
    let text = "
        duration = 0.4
        environment_rate = 173.67122400379452
        servo_rate = 694.6848960151781
        device.mass = 100.0
        effects.dropout = { policy = 'zero', probability = 0.743, seed = 2897454045 }
        environment.spring.stiffness = 5e7
        initial.velocity = 2.0
        operator.damping = 3.0
        stabilizer.popc-spread = {}";
    assert_eq!(breach(&parsed(text)).unwrap(), None);
}

// A loop whose displacements have squares beyond the range of `f32`, from ticks of 21 s, while its energies are far within.
#[test]
fn a_loop_whose_squares_leave_the_range_is_judged_by_its_forces_only() {
    let text = "
        duration = 2000.0
        integrator = 'semi-implicit-euler'
        servo_rate = 0.0479
        steps_per_tick = 3
        device.mass = 5e-5
        effects.filter.cutoff = 0.001
        environment.wall.stiffness = 3e-9
        initial.velocity = 0.002
        link = { damping = 1.57e-5, stiffness = 8e-9 }
        operator = { damping = 1e-9, mass = 9e-4 }
        stabilizer.force-bounding = {}";
    assert_eq!(breach(&parsed(text)).unwrap(), None);
}

// A wall that is met or missed by a nanometre: from this start the loop runs away in `f32` only, from others in both.
#[test]
fn a_grazed_wall_is_no_fault_of_a_scalar() {
    let text = "
        duration = 0.72
        servo_rate = 530.4450836766645
        device = { damping = 0.00417, mass = 0.1258501359279899 }
        environment.wall = { position = 7.950623620992296e-7, stiffness = 934459.8527631516 }
        initial = { position = -2.2336791840444655e-5, velocity = 5.513252508492022e-4 }
        stabilizer.iss = {}
        [operator]
        damping = 0.041696447766928046
        mass = 0.08208654073705744
        rest = -4.196661883324083e-6
        stiffness = 461.38642798905204";
    assert_eq!(breach(&parsed(text)).unwrap(), None);
}

#[test]
fn a_sweep_of_faults_finds_who_does_not_recover() {
    let scene = shipped("press-1khz");
    let swept = |it: &str| {
        let scene = name(it).written_in(&scene, &[]).unwrap();
        sweep(&scene, &[5], 200).unwrap()
    };
    let right = swept("my-popc");
    assert!(right.found.is_none() && right.recovery == 1, "{right:?}");
    let found = swept("dazed").found.expect("a breach");
    assert_eq!(found.broken, Broken::Law(Law::Recovers), "{found}");
    // What is told says the fault, where it begins, and the law with its remedy.
    let told = found.to_string();
    assert!(told.starts_with("in f") && told.contains("at tick 5 and so on, sample"), "{told}");
    assert!(told.ends_with(&Law::Recovers.to_string()) && told.contains(&found.fault.to_string()));
    let found = swept("halving").found.expect("a breach");
    assert_eq!(found.broken, Broken::Law(Law::Injects), "{found}");
}
