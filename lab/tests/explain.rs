//! Causes of loops that grow: the energy balance closes, and what adds the energy is named.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov_lab::compare::{Comparison, Entrants};
use lyapunov_lab::explain::{Balance, Explanation};
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{Rollout, Row, Verdict, scenes};

use crate::bound::systems::scene;

/// Sum of the magnitudes of all terms of a balance.
fn size(it: &Balance) -> f64 {
    let ins = [it.hold, it.delay, it.filter, it.encoder, it.saturation, it.hand, it.push];
    let outs = [it.device, it.operator, it.link, it.wall, it.controller, it.friction, it.gained];
    ins.into_iter().chain(outs).map(f64::abs).sum()
}

fn shipped_scenes() -> Vec<Scene> {
    let texts = scenes::SCENES.iter().filter(|it| it.name != "motion-file").map(|it| it.text);
    texts.map(scene).filter(|scene| scene.dimensions() == 1).collect()
}

#[test]
fn every_shipped_scene_closes_to_rounding() {
    for scene in shipped_scenes() {
        let explained = Explanation::of::<f64>(&scene).unwrap();
        let balances = explained.first_contact.into_iter().chain([explained.whole_run]);
        for balance in balances {
            let (closing, size) = (balance.closing.abs(), size(&balance));
            let is_closed = size.is_finite() && closing <= 1e-12 * size;
            assert!(is_closed, "{closing:e} of {size:e}: {scene:?}");
        }
    }
}

#[test]
fn absent_effects_leak_nothing() {
    let loop_with = |more: &str| {
        let text = format!(
            "duration = 1\nservo_rate = 500\ndevice = {{ mass = 0.2, damping = 0.3 }}\n\
             operator = {{ mass = 0.1, damping = 0.2, stiffness = 50.0, rest = 0.004 }}\n\
             environment.wall = {{ stiffness = 900, damping = 1 }}\ninitial.position = -0.004\n{more}"
        );
        scene(&text)
    };
    let of = |more: &str| Explanation::of::<f64>(&loop_with(more)).unwrap().whole_run;
    let bare = of("");
    let zero =
        |it: Balance| [it.delay, it.filter, it.encoder, it.saturation, it.controller, it.link];
    assert_eq!(zero(bare), [0.0; 6]);
    assert_eq!(zero(Explanation::of::<f32>(&loop_with("")).unwrap().whole_run), [0.0; 6]);
    assert!(bare.hold > 0.0 && bare.hand == 0.0 && bare.push == 0.0);
    assert!(of("effects.delay.ticks = 2").delay > 0.0);
    assert!(of("effects.filter.cutoff = 30").filter != 0.0);
    assert!(of("effects.encoder.resolution = 1e-4").encoder != 0.0);
    assert!(of("effects.saturation.force = 0.5").saturation != 0.0);
    assert!(of("effects.load.force = 0.5").push != 0.0);
    assert!(of("effects.delay.ticks = 4\nstabilizer.popc.work = \"held\"").controller != 0.0);
}

/// Without a stabilizer the whole force is the environment's, also where `f32` cannot hold the force limit exactly.
#[test]
fn an_absent_controller_gets_no_energy() {
    let text = scenes::text_of("saturation").unwrap().replace("force = 4.0", "force = 4.1");
    let scene = scene(&text);
    assert!(scene.stabilizer.is_none());
    let told = Explanation::of::<f32>(&scene).unwrap().whole_run;
    assert!(told.saturation != 0.0 && told.controller == 0.0, "{}", told.controller);
}

/// A free mass under held forces moves on parabolas: the work of the spring along them is known in closed form.
#[test]
fn the_hold_leaks_the_held_work_less_the_work_of_the_spring() {
    let scene = scene(
        "duration = 0.2\nservo_rate = 100\ndevice.mass = 0.5\n\
         environment.spring.stiffness = 300.0\ninitial.position = 0.01",
    );
    let rows: Vec<Row> = Rollout::<f64>::of(&scene).unwrap().rows().collect();
    let stored = |row: &Row| 0.5 * 300.0 * row.x * row.x;
    let held: f64 = rows.windows(2).map(|pair| pair[0].f_act * (pair[1].x - pair[0].x)).sum();
    let leak = stored(&rows[rows.len() - 1]) - stored(&rows[0]) - held;
    let told = Explanation::of::<f64>(&scene).unwrap().whole_run;
    assert!(abs_diff_eq!(told.hold / leak, 1.0, epsilon = 1e-9), "{} {leak}", told.hold);
    assert_abs_diff_eq!(told.gained / -held, 1.0, epsilon = 1e-9);
}

/// Late and clipped: the definitions could differ in what counts as contact.
#[test]
fn the_force_error_is_that_of_a_comparison() {
    let pressed = |environment: &str| {
        scene(&format!(
            "duration = 2\nservo_rate = 1000\ndevice = {{ mass = 0.12, damping = 0.3 }}\n\
             operator = {{ mass = 0.15, damping = 4, stiffness = 400, rest = 0.02 }}\nstabilizer.popc = {{}}\n\
             effects = {{ delay.ticks = 2, encoder.resolution = 5e-6, saturation.force = 20 }}\n\
             environment.{environment}\n"
        ))
    };
    let both = |scene: &Scene| {
        let explained = Explanation::of::<f64>(scene).unwrap();
        let entrants = Entrants::<f64>::of(["popc".parse().unwrap()]);
        let compared = Comparison::of("test", scene, &entrants).unwrap();
        [explained.force_error, compared.scores().next().unwrap().force_error]
    };
    let [explained, compared] =
        both(&pressed("wall = { position = 0.005, stiffness = 12000, damping = 1 }"));
    assert!(explained.is_some_and(|error| error > 0.1));
    assert_eq!(explained, compared);
    assert_eq!(both(&pressed("spring = { stiffness = 500 }")), [None, None]);
}

/// One step of a Runge-Kutta method is unstable on a link as stiff as this: the loop is stable, and its run is not.
#[test]
fn a_run_that_its_integrator_blows_up_is_no_transient() {
    let scene = scene(
        "duration = 0.5\nservo_rate = 1000\nintegrator = \"rk4\"\nsteps_per_tick = 1\n\
         device = { mass = 0.1, damping = 0.1 }\noperator = { mass = 0.1, damping = 0.5, stiffness = 50, rest = 0.004 }\n\
         link = { stiffness = 5e5, damping = 1 }\ninitial.position = -0.004\nenvironment.spring.stiffness = 200\n",
    );
    let explained = Explanation::of::<f64>(&scene).unwrap();
    assert_eq!(explained.verdict, Verdict::Grows);
    assert!(explained.limits.spectral_radius.unwrap() < 1.0);
    assert!(!explained.remedies.is_empty() && !explained.to_string().contains("transient"));
}

/// A mass near the end of the range is explained too, and soon.
#[test]
fn a_mass_near_the_end_of_the_range_is_explained() {
    for mass in ["1e-160", "1e-300", "1e160"] {
        let scene = scene(&format!(
            "duration = 0.1\nservo_rate = 1000\ndevice.mass = {mass}\ninitial.position = -0.004\n\
             environment.wall.stiffness = 1000\n"
        ));
        let explained = Explanation::of::<f64>(&scene).unwrap();
        assert_eq!(explained.left_range, explained.verdict == Verdict::Grows, "{mass}");
    }
}

/// A link on which `ω T` is 3.46, beyond the 2.83 that RK4 bears: the growth is the integrator's, and the hold gives little.
#[test]
fn what_an_integrator_adds_is_called_its_own() {
    let scene = scene(
        "duration = 2\nservo_rate = 500\nintegrator = \"rk4\"\nlink.stiffness = 2e5\n\
         operator = { mass = 0.2, damping = 1, stiffness = 100 }\ndevice = { mass = 0.1, damping = 0.5 }\n\
         initial.position = -0.01\nenvironment.wall = { stiffness = 1000, damping = 1 }\n",
    );
    let explained = Explanation::of::<f64>(&scene).unwrap();
    let told = explained.to_string();
    assert!(told.contains("left  to integrator") && !told.contains("largest leak"), "{told}");
    let exact = explained.remedies.first().unwrap();
    assert_eq!((exact.changes[0].0.as_str(), exact.verdict), ("integrator", Verdict::Settles));
}

/// A run in balance would do the same in any loop: nothing is tried, and the page says why.
#[test]
fn a_run_in_balance_tries_nothing_and_says_so() {
    let scene = scene(
        "duration = 2\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 3 }\n\
         operator = { mass = 0.1, stiffness = 50, rest = 0.004 }\ninitial.position = 3.2e-5\n\
         environment.wall.stiffness = 6200\n",
    );
    let explained = Explanation::of::<f64>(&scene).unwrap();
    assert!(explained.is_undisturbed && explained.remedies.is_empty(), "{explained}");
    let page = explained.to_html("test", "");
    let json: serde_json::Value = serde_json::from_str(&explained.to_json("test")).unwrap();
    for told in [explained.to_string(), page, json["no_remedies"].to_string()] {
        assert!(told.contains("starts in balance"), "{told}");
    }
}
