//! Comparisons of whole scenes, against straight calculations over their rows.

use approx::assert_relative_eq;
use lyapunov::{Correction, PortSample, Stabilizer};

use super::*;
use crate::files::Scene;
use crate::measure::Verdict;
use crate::measure::samples::scene;
use crate::simulate::{Rollout, Row};
use crate::studies::paper::Case;

/// Constant damper, N·s/m.
#[derive(Clone, Copy)]
pub(super) struct Damper(pub(super) f64);

impl Stabilizer<f64> for Damper {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }
    }
}

fn standard(scene: &Scene) -> Vec<Score> {
    let comparison = Comparison::of("test", scene, &Entrants::<f64>::standard()).unwrap();
    comparison.scores().cloned().collect()
}

/// 2 kN/m at 2 mm, pressed on from 10 mm at 1 kHz over 100 Hz; the plant's own velocity is in the rows.
pub(super) fn press(more: &str) -> Scene {
    let text = "duration = 3.0\nservo_rate = 1000.0\nenvironment_rate = 100.0\nvelocity = \"exact\"\n\
        device.mass = 0.3\ndevice.damping = 0.1\noperator.damping = 2.0\n\
        operator.stiffness = 200.0\noperator.rest = 0.01\nenvironment.wall.position = 0.002\n\
        environment.wall.stiffness = 2000.0\nenvironment.wall.damping = 1.0\n";
    Scene::parse(&format!("{text}{more}"), "press").unwrap()
}

#[test]
fn the_paper_s_scenes_come_out_as_known() {
    for (case, settled) in [(Case::Plain8k, [None; 2]), (Case::Plain50k, [Some(1.36), Some(2.35)])]
    {
        let scores = standard(&case.scene().unwrap());
        let names: Vec<&str> = scores.iter().map(|score| score.stabilizer.as_str()).collect();
        let [none, popc, spring, device, paper] = &scores[..] else { panic!("{names:?}") };
        assert_eq!(none.verdict, Verdict::Grows);
        assert_eq!((none.settling_time, none.force_error), (None, None));
        for score in [popc, spring, device, paper] {
            assert!(score.verdict.is_bounded(), "{}", score.stabilizer);
            assert!(score.step_time.unwrap().min > 0.0 && score.step_time.unwrap().rounds >= 15);
        }
        if settled[0].is_some() {
            assert_eq!([popc.settling_time, paper.settling_time], settled);
        }
        let sizes: Vec<usize> = scores.iter().map(|score| score.state_bytes).collect();
        assert_eq!(sizes, [0, 16, 16, 24, 32]);
        // By construction these two are equal.
        let named =
            |score: &Score| Score { stabilizer: String::new(), step_time: None, ..score.clone() };
        assert_eq!(named(popc), named(spring));
    }
}

/// Checks every column that comes from rows against all rows at once.
fn check_against_rows(scene: &Scene, damper: Damper) {
    let entrants = Entrants::<f64>::empty().with("damper", move |_| Ok(damper));
    let comparison = Comparison::of("press", scene, &entrants).unwrap();
    let score = comparison.scores().next().unwrap();
    let rows: Vec<Row> = Rollout::stabilized_by(scene, damper).unwrap().rows().collect();
    let delay = scene.effects.delay.map_or(0, |delay| delay.ticks.get() as usize);
    let most = scene.effects.saturation.map_or(f64::MAX, |limit| limit.force.get());
    let wall: Vec<f64> = (0..rows.len())
        .map(|n| if n < delay { 0.0 } else { rows[n - delay].f_env.clamp(-most, most) })
        .collect();

    let moved = |n: usize| rows[n + 1].x - rows[n].x;
    let work = |n: usize| -> f64 { (0..n).map(|n| wall[n] * moved(n)).sum() };
    let least = (0..rows.len()).step_by(7).chain([rows.len() - 1]).map(work).fold(0.0, f64::min);
    let injected = score.energy_injected.unwrap();
    assert!(injected >= -1e3 * least - 1e-9 && injected > 0.0, "{injected} {least}");
    let taken: f64 = (0..rows.len() - 1).map(|n| (rows[n].f_act - wall[n]) * moved(n)).sum();
    assert_relative_eq!(
        score.energy_taken.unwrap(),
        1e3 * taken,
        epsilon = 1e-18,
        max_relative = 1e-9
    );

    check_energy_given(scene, &rows, score);
    check_contacts(&rows, &wall, score);
    check_errors(&rows, &wall, score);
    assert_relative_eq!(score.active.unwrap(), 100.0, epsilon = 1e-18, max_relative = 1e-9);
    // It tells neither an observed energy nor a shortfall.
    assert_eq!(score.shortfall, None);
    assert!(score.verdict.is_bounded());
    assert_eq!(score.state_bytes, 8);
}

/// Checks peaks and felt stiffness against the ticks on which the force of the `wall` is not 0.
fn check_contacts(rows: &[Row], wall: &[f64], score: &Score) {
    let mut contacts: Vec<Vec<usize>> = vec![Vec::new()];
    for (n, force) in wall.iter().enumerate() {
        match contacts.last_mut() {
            Some(contact) if *force != 0.0 => contact.push(n),
            _ => contacts.push(Vec::new()),
        }
    }
    let peak = |is_long: bool| {
        let these = contacts.iter().filter(|contact| !contact.is_empty());
        let these = these.filter(|contact| (contact.len() >= 500) == is_long).flatten();
        these.map(|n| rows[*n].f_act.abs()).reduce(f64::max)
    };
    assert_eq!((score.short_peak, score.long_peak), (peak(false), peak(true)));
    let long = || contacts.iter().filter(|contact| contact.len() >= 500).flatten();
    let sum = |f: &dyn Fn(&Row) -> f64| -> f64 { long().map(|n| f(&rows[*n])).sum() };
    let felt = sum(&|row| row.f_act * (row.x - 0.002)) / sum(&|row| (row.x - 0.002).powi(2));
    assert_relative_eq!(score.stiffness_felt.unwrap(), felt, epsilon = 1e-18, max_relative = 1e-9);
    assert_relative_eq!(
        score.stiffness_percent.unwrap(),
        felt / 20.0,
        epsilon = 1e-18,
        max_relative = 1e-9
    );
}

/// Checks the forces against those of the ideal wall at the rows' motion.
fn check_errors(rows: &[Row], wall: &[f64], score: &Score) {
    let law = |row: &Row| {
        let depth = row.x - 0.002;
        if depth > 0.0 { (2000.0 * depth + row.v).max(0.0) } else { 0.0 }
    };
    let touching = |n: &usize| wall[*n] != 0.0 || rows[*n].x > 0.002;
    let error = |n: usize| (rows[n].f_act - law(&rows[n])).powi(2);
    let errors: Vec<f64> = (0..rows.len()).filter(touching).map(error).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    assert_relative_eq!(
        score.force_error.unwrap(),
        mean.sqrt(),
        epsilon = 1e-18,
        max_relative = 1e-9
    );
    let felt: f64 = rows.iter().map(|row| row.f_act * law(row)).sum();
    let felt = 100.0 * felt / rows.iter().map(|row| law(row).powi(2)).sum::<f64>();
    assert_relative_eq!(score.force_felt.unwrap(), felt, epsilon = 0.0, max_relative = 1e-9);
}

/// Checks what the port gave against the work of the rows' forces on a motion integrated in steps of a thousandth of a
/// tick.
fn check_energy_given(scene: &Scene, rows: &[Row], score: &Score) {
    const STEPS: u32 = 1000;
    let (mass, period) = (scene.operator.mass.get() + scene.device.mass.get(), scene.period());
    let device = scene.device.damping.get();
    let (damping, pull) = (scene.operator.damping.get() + device, scene.operator.stiffness.get());
    let rest = scene.operator.rest.get();
    let h = period / f64::from(STEPS);
    let (mut x, mut v) = (scene.initial.position.get(), scene.initial.velocity.get());
    // Work at the port, what the device's damper took, and the least of the first and of both.
    let (mut work, mut burnt, mut least, mut least_of_both) = (0.0, 0.0, 0.0_f64, 0.0_f64);
    for row in &rows[..rows.len() - 1] {
        let pushed = |x: f64, v: f64| (-pull * (x - rest) - damping * v - row.f_act) / mass;
        for _ in 0..STEPS {
            // The midpoint rule; its error falls with h².
            let (half_x, half_v) = (x + 0.5 * h * v, v + 0.5 * h * pushed(x, v));
            x += h * half_v;
            v += h * pushed(half_x, half_v);
            work += row.f_act * half_v * h;
            burnt += device * half_v * half_v * h;
        }
        least = least.min(work);
        least_of_both = least_of_both.min(work + burnt);
    }
    let told = score.energy_given.unwrap();
    assert_relative_eq!(told, -1e3 * least, epsilon = 1e-9, max_relative = 1e-6);
    // What the damper took is known from below only.
    let told = score.energy_given_beyond_damper.unwrap();
    assert!(told >= -1e3 * least_of_both * (1.0 - 1e-6) - 1e-9, "{told} {least_of_both}");
    assert_relative_eq!(told, -1e3 * least_of_both, epsilon = 1e-9, max_relative = 1e-2);
}

#[test]
fn the_columns_follow_from_the_rows() {
    check_against_rows(&press(""), Damper(12.0));
    check_against_rows(&press("[effects]\ndelay.ticks = 1\n"), Damper(20.0));
    let clipped = press("[effects]\ndelay.ticks = 2\nsaturation.force = 4.0\n");
    check_against_rows(&clipped, Damper(20.0));
}

#[test]
fn a_law_that_adds_no_damping_has_no_share_of_active_ticks() {
    let names = ["popc", "tank", "force-bound", "memory-based", "least-norm"];
    let entrants = Entrants::<f64>::of(names.map(|name| name.parse().unwrap()));
    let comparison = Comparison::of("press", &press(""), &entrants).unwrap();
    for score in comparison.scores() {
        let damps = ["popc", "least-norm"].contains(&score.stabilizer.as_str());
        assert_eq!(score.active.is_some(), damps, "{}", score.stabilizer);
    }
    let acted = |score: &&Score| score.active.is_none() && score.energy_taken != Some(0.0);
    assert!(comparison.scores().any(|score| acted(&score)));
}

#[test]
fn settings_are_the_scene_s_or_the_defaults() {
    let named = scene("stabilizer.lolc.work = \"sampled\"\nstabilizer.lolc.damping_cap = 0.25\n");
    let text = |scene: &Scene| {
        Comparison::of("s", scene, &Entrants::<f64>::empty()).unwrap().settings.to_string()
    };
    assert_eq!(text(&named), "sampled work, cap 0.25 (as the scene says)");
    assert_eq!(text(&scene("")), "held work, cap 0.5 (the defaults)");
    // The settings reach the stabilizers: POPC of the comparison is POPC of the scene.
    let own = scene("stabilizer.popc.damping_cap = 0.1\ninitial.velocity = 0.3\n");
    let active =
        Rollout::<f64>::of(&own).unwrap().filter(|tick| tick.correction.alpha > 0.0).count();
    assert!(active > 0);
    assert_relative_eq!(
        standard(&own)[1].active.unwrap(),
        100.0 * active as f64 / 101.0,
        epsilon = 1e-18,
        max_relative = 1e-9
    );
}

#[test]
fn everything_but_time_is_the_same_again_and_f32_works() {
    let timeless = |scores: Vec<Score>| -> Vec<Score> {
        scores.into_iter().map(|score| Score { step_time: None, ..score }).collect()
    };
    let scene = press("[effects]\ndelay.ticks = 1\nencoder.resolution = 1e-5\n");
    assert_eq!(timeless(standard(&scene)), timeless(standard(&scene)));

    let single = Comparison::of("f32", &scene, &Entrants::<f32>::standard()).unwrap();
    let sizes: Vec<usize> = single.scores().map(|score| score.state_bytes).collect();
    assert_eq!(sizes, [0, 8, 8, 12, 16]);
    assert_eq!(single.scores().nth(1).unwrap().verdict, Verdict::Settles);
}

#[test]
fn the_table_fits_whatever_is_in_it() {
    let long = "a stabilizer\nwith a name\tthat goes on and on and on and on and on and on and on";
    let entrants = Entrants::<f64>::standard().with(long, |_| Ok(Damper(-40.0)));
    for scene in [press(""), scene(""), Case::Plain50k.scene().unwrap()] {
        let comparison = Comparison::of("some scene", &scene, &entrants).unwrap();
        let table = comparison.to_string();
        assert!(table.lines().all(|line| line.chars().count() <= 100), "{table}");
        assert_eq!(table.matches("a stabilizer with a").count(), 3, "{table}");
    }
}

#[test]
fn sorting_puts_missing_values_last_and_keeps_ties() {
    let entrants = Entrants::<f64>::standard().with("damper", |_| Ok(Damper(-5.0)));
    let scene = Case::Plain50k.scene().unwrap();
    let mut comparison = Comparison::of("50 kN/m", &scene, &entrants).unwrap();
    let mut order = |column: Column| -> Vec<String> {
        comparison.sort_by(column);
        comparison.scores().map(|score| score.stabilizer.clone()).collect()
    };
    let times = order(Column::SettlingTime);
    assert_eq!(times[..2], ["popc", "lolc-spring"]);
    assert_eq!(times[times.len() - 2..], ["none", "damper"]);
    assert_eq!(order(Column::Stabilizer)[..2], ["damper", "lolc-device-damping"]);
    assert_eq!(order(Column::Verdict).last().unwrap(), "damper");
    assert_eq!(order(Column::StateBytes)[..2], ["none", "damper"]);
}

#[test]
fn a_column_s_name_is_its_key() {
    let entrants = Entrants::<f64>::standard();
    let comparison = Comparison::of("s", &scene(""), &entrants).unwrap();
    let text = document(&[comparison], &[]);
    let read: serde_json::Value = serde_json::from_str(&text).unwrap();
    let row = read["rows"][0].as_object().unwrap();
    assert_eq!(row.len(), Column::ALL.len() + 1);
    for column in Column::ALL {
        assert!(row.contains_key(column.key()), "{column}");
        assert_eq!(column.key().parse(), Ok(column));
    }
    let fault = "setling_time".parse::<Column>().unwrap_err().to_string();
    assert!(fault.contains("did you mean `settling_time_s`?"), "{fault}");
    assert!("".parse::<Column>().unwrap_err().to_string().contains("ns_per_step"));
}

#[test]
fn errors_name_entrant_and_scene() {
    let tiny = scene("").period();
    let entrants = Entrants::<f64>::standard()
        .with("odd", move |_| lyapunov::DampingLimit::at(-tiny).map(|_| Damper(1.0)));
    let error = Comparison::of("here", &scene(""), &entrants).unwrap_err().to_string();
    assert!(error.starts_with("here: odd cannot run here: damping limit is -0.01"), "{error}");

    let stop = |_| std::ops::ControlFlow::Break(());
    let stopped = Comparison::watched("s", &scene(""), &Entrants::<f64>::standard(), &stop);
    assert_eq!(stopped.unwrap_err(), CompareError::Stopped);
}

#[test]
fn a_stable_loop_that_becomes_unstable_is_broken() {
    let pump = || Entrants::<f64>::standard().with("pump", |_| Ok(Damper(-40.0)));
    let over = |scenes: &[Scene], entrants: &dyn Fn() -> Entrants<f64>| -> Vec<Comparison> {
        scenes.iter().map(|scene| Comparison::of("s", scene, &entrants()).unwrap()).collect()
    };
    let soft = scene("device.damping = 1.0\n");
    let scenes = [soft, Case::Plain50k.scene().unwrap()];
    let comparisons = over(&scenes, &pump);
    let marks = |comparison: &Comparison| -> Vec<Option<bool>> {
        comparison.scores().map(|score| score.broke_it).collect()
    };
    let verdicts = |comparison: &Comparison, name: &str| {
        comparison.scores().find(|score| score.stabilizer == name).unwrap().verdict.judged()
    };
    assert_eq!(verdicts(&comparisons[0], "none"), Some(true));
    assert_eq!(verdicts(&comparisons[1], "none"), Some(false));
    let only_the_pump = [false, false, false, false, false, true].map(Some);
    assert_eq!(marks(&comparisons[0]), only_the_pump);
    // What grows alone cannot be broken.
    assert_eq!(verdicts(&comparisons[1], "pump"), Some(false));
    assert_eq!(marks(&comparisons[1]), [Some(false); 6]);
    let told = serde_json::to_value(Broken::of(&comparisons)).unwrap();
    let row = |name: &str| {
        let rows = told.as_array().unwrap();
        rows.iter().find(|row| row["stabilizer"] == name).unwrap().clone()
    };
    assert_eq!((&row("pump")["bounded_alone"], &row("pump")["broke"]), (&1.into(), &1.into()));
    assert_eq!((&row("popc")["bounded_alone"], &row("popc")["broke"]), (&1.into(), &0.into()));

    // Without the loop alone nothing is known.
    let alone = || Entrants::<f64>::empty().with("pump", |_| Ok(Damper(-40.0)));
    let unknown = over(&scenes, &alone);
    assert_eq!(marks(&unknown[0]), [None]);
    assert!(Broken::of(&unknown).is_empty());
}

#[test]
fn a_law_that_adds_no_damping_is_judged_by_energy_and_force() {
    use crate::simulate::family::StabilizerName;
    // A law adds damping if it is ever active; this scene makes all of those act.
    let entrants = Entrants::<f64>::of(StabilizerName::ALL).with("own", |_| Ok(Damper(1.0)));
    let scene = press("");
    let comparison = Comparison::of("press", &scene, &entrants).unwrap();
    for score in comparison.scores() {
        let judged = match score.stabilizer.as_str() {
            "own" => None,
            // A port around the environment damps by its own motion, and tells of no damping.
            "none" | "iss" | "virtual-coupling" => Some(Judgement::Settling),
            _ if score.active.is_some_and(|share| share > 0.0) => Some(Judgement::Settling),
            _ => Some(Judgement::EnergyAndForce),
        };
        assert_eq!(score.judged_by, judged, "{}", score.stabilizer);
    }
}
