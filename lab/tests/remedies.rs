//! Remedies: each was run, holds, and is needed.

use approx::assert_abs_diff_eq;
use lyapunov_lab::explain::{Change, Explanation};
use lyapunov_lab::scene::{Positive, Scene};
use lyapunov_lab::{Rollout, SVector, Summary, Verdict, scenes};

use crate::bound::systems::{self, Chance, scene};

/// Random scene whose wall is too stiff for the loop; two swings of its softest hand fit into the run.
fn growing(chance: &mut Chance) -> Scene {
    let rate = chance.decades(100.0, 2000.0).round();
    let mass = chance.within(0.05, 0.5);
    let hand = chance.within(0.0, 0.3);
    let both = mass + hand;
    let share = |chance: &mut Chance| both * rate * chance.decades(1e-3, 3e-2);
    let (device, grip) = (share(chance), share(chance));
    let wall = if chance.happens(0.5) { share(chance) } else { 0.0 };
    let stiffness = both * rate * rate * chance.decades(0.05, 2.0);
    let mut text = format!(
        "duration = 2\nservo_rate = {rate}\ndevice = {{ mass = {mass}, damping = {device} }}\n\
         operator = {{ mass = {hand}, damping = {grip}, stiffness = {}, rest = 0.004 }}\n\
         initial.position = -0.004\nenvironment.wall = {{ stiffness = {stiffness}, damping = {wall} }}\n",
        chance.within(35.0, 200.0)
    );
    if chance.happens(0.3) {
        text += &format!("effects.delay.ticks = {}\n", chance.whole(1, 2));
    }
    if chance.happens(0.3) {
        text += &format!("environment_rate = {}\n", rate / 2.0);
    }
    if chance.happens(0.2) {
        text += "effects.encoder.resolution = 1e-6\n";
    }
    if chance.happens(0.2) {
        text += &format!("effects.filter.cutoff = {}\n", 0.2 * rate);
    }
    scene(&text)
}

/// Whether the swing towards the end of a run does not grow, from its rows alone.
fn stays(scene: &Scene) -> bool {
    let rows: Vec<f64> = Rollout::<f64>::of(scene).unwrap().rows().map(|row| row.x).collect();
    if rows.len() as u64 != scene.ticks() + 1 {
        return false;
    }
    let quarter = |index: usize| &rows[index * rows.len() / 4..(index + 1) * rows.len() / 4];
    let width = |part: &[f64]| {
        let most = part.iter().copied().fold(f64::MIN, f64::max);
        most - part.iter().copied().fold(f64::MAX, f64::min)
    };
    let [second, last] = [1, 3].map(|index| width(quarter(index)));
    last <= (1.1 * second).max(0.1 * 0.008) && width(&rows) < 0.16
}

#[test]
fn every_remedy_holds() {
    let mut chance = Chance::new(41);
    let (mut scenes, mut remedies) = (0, 0);
    while scenes < 250 {
        let scene = growing(&mut chance);
        let explained = Explanation::of::<f64>(&scene).unwrap();
        if explained.verdict != Verdict::Grows {
            continue;
        }
        scenes += 1;
        assert!(explained.remedies.len() >= 2, "{}: {scene:?}", explained.remedies.len());
        for remedy in &explained.remedies {
            remedies += 1;
            assert!(stays(&remedy.scene), "{:?}: {scene:?}", remedy.changes);
            assert_ne!(remedy.verdict, Verdict::Grows);
            assert!(remedy.peak_force.is_finite() && remedy.force_error.is_none_or(f64::is_finite));
            if remedy.scene.stabilizer.is_none() {
                let mut longer = remedy.scene.to_draft();
                longer.duration = Positive::new(6.0).unwrap();
                assert!(stays(&longer.check().unwrap()), "{:?}: {scene:?}", remedy.changes);
            }
        }
    }
    assert!(remedies > 3 * scenes, "{remedies}");
}

/// A handle of 0.3 kg, late by a tick, against a wall without a damper.
#[test]
fn a_wall_gets_the_damper_with_which_its_run_settles() {
    let with = |damping: f64| {
        scene(&format!(
            "duration = 4\nservo_rate = 1000\ndevice.mass = 0.3\neffects.delay.ticks = 1\n\
             operator = {{ mass = 0.1, damping = 2, stiffness = 200, rest = 0.01 }}\n\
             environment.wall = {{ stiffness = 2000, damping = {damping} }}\n"
        ))
    };
    let explained = Explanation::of::<f64>(&with(0.0)).unwrap();
    let key = "environment.wall.damping";
    let found = explained.remedies.iter().find_map(|it| match it.changes[..] {
        [(ref changed, Change::Number(damping))] if changed == key => Some(damping),
        _ => None,
    });
    let damping = found.unwrap();
    let last = Rollout::<f64>::of(&with(damping)).unwrap().rows().last().unwrap();
    let rest = 200.0 * 0.01 / (200.0 + 2000.0);
    assert_abs_diff_eq!(last.x, rest, epsilon = 0.05 * rest);
}

/// A force limit of 20 N bounds a loop that is ten ticks late: it swings for good, and changes are tried as if it grew.
#[test]
fn a_run_that_only_a_force_limit_holds_gets_remedies_with_which_it_settles() {
    let late = |ticks: u32| {
        scene(&format!(
            "duration = 3\nservo_rate = 1000\ndevice = {{ mass = 0.12, damping = 0.3 }}\n\
             operator = {{ mass = 0.15, damping = 4, stiffness = 400, rest = 0.02 }}\nstabilizer.popc = {{}}\n\
             environment.wall = {{ position = 0.005, stiffness = 2500, damping = 1 }}\n\
             effects = {{ delay.ticks = {ticks}, encoder.resolution = 5e-6, saturation.force = 20 }}\n"
        ))
    };
    let explained = Explanation::of::<f64>(&late(10)).unwrap();
    assert_eq!(explained.verdict, Verdict::Swinging);
    assert!(explained.remedies.len() >= 2, "{explained}");
    for remedy in &explained.remedies {
        let run = Rollout::<f64>::of(&remedy.scene).unwrap();
        let verdict = Summary::of(&remedy.scene, run).verdict();
        assert_eq!([remedy.verdict, verdict], [Verdict::Settles; 2], "{:?}", remedy.changes);
    }
    assert!(explained.to_string().contains("all were run, and all settle"), "{explained}");
    let sound = Explanation::of::<f64>(&late(0)).unwrap();
    assert!(sound.remedies.is_empty(), "{sound}");
    let page = sound.to_html("test", "");
    assert!(page.contains("The run does not grow, so no change of the loop was tried."), "{page}");
}

/// A saturation makes every peak the same, and a spring has no force error: what helps there counts all the same.
#[test]
fn a_remedy_counts_where_it_changes_neither_peak_nor_force_error() {
    let explained = |force: f64| {
        Explanation::of::<f64>(&scene(&format!(
            "duration = 4\nservo_rate = 1000\noperator = {{ mass = 0.1, damping = 2, stiffness = 200 }}\n\
             device = {{ mass = 0.2, damping = 0.1 }}\ninitial.position = 0.02\n\
             environment.spring.stiffness = 3000\neffects = {{ delay.ticks = 2, saturation.force = {force} }}\n"
        )))
        .unwrap()
    };
    let keys = |it: &Explanation| -> Vec<String> {
        it.remedies.iter().map(|remedy| remedy.changes[0].0.clone()).collect()
    };
    let (low, high) = (explained(8.0), explained(80.0));
    assert_eq!(keys(&low), keys(&high));
    assert!(keys(&low).contains(&"stabilizer.popc.damping_cap".to_owned()), "{low}");
    assert!(
        low.remedies.iter().all(|it| it.peak_force == low.peak_force && it.force_error.is_none())
    );
}

/// Of a run that is lost before it could be judged: with a change the same length is too short.
#[test]
fn a_run_that_is_too_short_is_no_remedy() {
    let scene = scene(
        "duration = 0.3\nservo_rate = 1000\nenvironment_rate = 100\n\
         operator = { mass = 0.1, damping = 2, stiffness = 100 }\ndevice = { mass = 0.2, damping = 0.1 }\n\
         initial.position = -0.01\nenvironment.wall.stiffness = 2e5\n",
    );
    let explained = Explanation::of::<f64>(&scene).unwrap();
    assert_eq!((explained.verdict, explained.remedies.len()), (Verdict::Grows, 0));
    assert!(explained.to_string().contains("give it a longer duration"), "{explained}");
}

#[test]
fn a_little_beyond_its_remedy_the_loop_fails() {
    let scene = scene(
        "duration = 4\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 0.2 }\n\
         operator = { mass = 0.1, damping = 0.2, stiffness = 50, rest = 0.004 }\n\
         initial.position = -0.004\nenvironment.spring = { stiffness = 8000 }\n",
    );
    let explained = Explanation::of::<f64>(&scene).unwrap();
    assert_eq!(explained.verdict, Verdict::Grows);
    let most = explained.limits.exact.unwrap();
    let number = |key: &str| {
        let changes = explained.remedies.iter().flat_map(|remedy| &remedy.changes);
        let found = changes.filter(|(name, _)| name == key).find_map(|(_, change)| match change {
            Change::Number(number) => Some(*number),
            Change::Word(_) => None,
        });
        found.unwrap()
    };
    let stiffness = number("environment.spring.stiffness");
    assert!(stiffness < most && stiffness > 0.9 * most, "{stiffness} {most}");
    let with = |text: &str| {
        let limits = lyapunov_lab::bound::Limits::of(&systems::scene(text));
        limits.spectral_radius.unwrap()
    };
    let at = |rate: f64, damping: f64| {
        with(&format!(
            "duration = 4\nservo_rate = {rate}\ndevice = {{ mass = 0.2, damping = {damping} }}\n\
             operator = {{ mass = 0.1, damping = 0.2, stiffness = 50 }}\n\
             environment.spring.stiffness = 8000\n"
        ))
    };
    let (rate, damping) = (number("servo_rate"), number("device.damping"));
    assert!(at(rate, 0.2) < 1.0 && at(0.9 * rate, 0.2) > 1.0, "{rate}");
    assert!(at(1000.0, damping) < 1.0 && at(1000.0, 0.9 * damping) > 1.0, "{damping}");
}

/// The stiffness that is told is that of the scene that was run.
#[test]
fn a_softer_shape_is_a_softer_shape() {
    for name in ["box", "plane", "sphere"] {
        let text = scenes::text_of(name).unwrap();
        let stiff = scene(&text.replace("stiffness = 3000.0", "stiffness = 90000.0"));
        let explained = match stiff.dimensions() {
            2 => Explanation::of::<SVector<f64, 2>>(&stiff),
            _ => Explanation::of::<SVector<f64, 3>>(&stiff),
        };
        let key = format!("environment.{name}.stiffness");
        let softer = explained.unwrap().remedies.into_iter().find_map(|remedy| {
            let number = remedy.changes.iter().find_map(|(changed, to)| match to {
                Change::Number(number) if *changed == key => Some(*number),
                _ => None,
            });
            number.map(|number| (number, remedy.scene))
        });
        let (told, scene) = softer.expect("a softer one");
        let run = toml::Table::try_from(&scene).unwrap()["environment"][name]["stiffness"].clone();
        assert!(run.as_float() == Some(told) && told < 90e3, "{name}: {told}, {run}");
    }
}

/// A held wall of 420 N/m on a damper of 1 N·s/m is passive from `K / (2 b) = 210 Hz` on; of the rates that divide 1 kHz the first
/// is 250 Hz.
#[test]
fn the_lowest_rate_that_holds_is_told() {
    let held = "duration = 4\nservo_rate = 1000\nenvironment_rate = 100\n\
                device = { mass = 0.2, damping = 1.0 }\n\
                operator = { mass = 0.1, stiffness = 50, rest = 0.01 }\ninitial.position = 0.002\n\
                environment.wall.stiffness = 420\n";
    let explained = Explanation::of::<f64>(&scene(held)).unwrap();
    let mut remedies = explained.remedies.into_iter();
    let faster = remedies.find(|it| it.changes[0].0 == "environment_rate").expect("a rate");
    assert_eq!(faster.changes, [("environment_rate".to_owned(), Change::Number(250.0))]);
    assert_eq!(
        faster.scene,
        scene(&held.replace("environment_rate = 100", "environment_rate = 250"))
    );
}

#[test]
fn a_loop_that_settles_needs_no_remedy() {
    let calm = "duration = 5\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 0.5 }\n\
                  operator = { damping = 0.5, stiffness = 50 }\ninitial.position = -0.004\n\
                  environment.wall.stiffness = 500\n";
    let explained = Explanation::of::<f64>(&scene(calm)).unwrap();
    assert_eq!((explained.verdict, explained.remedies.len()), (Verdict::Settles, 0));
}
