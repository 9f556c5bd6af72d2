//! The damping cap of a scene whose force acts late.

use std::f64::consts::FRAC_PI_4;

use approx::assert_relative_eq;
use lyapunov_lab::compare::{Comparison, Entrants};
use lyapunov_lab::explain::Explanation;
use lyapunov_lab::family::{Settings, StabilizerName};
use lyapunov_lab::map::{Axis, Grid};
use lyapunov_lab::scenes::text_of;
use lyapunov_lab::{Rollout, Row, Scene, Summary};

/// The shipped press at 230 N/m, `ticks` late, with `more`.
fn press(ticks: u32, more: &str) -> Scene {
    let text = text_of("press-1khz").unwrap();
    let text = text.replace("stiffness = 2000.0", "stiffness = 230.0");
    let text = text.replace("ticks = 1", &format!("ticks = {ticks}"));
    Scene::parse(&format!("{text}\n{more}\n"), "press").unwrap_or_else(|fault| panic!("{fault}"))
}

fn summary(scene: &Scene) -> Summary {
    Summary::of(scene, Rollout::<f64>::of(scene).unwrap())
}

fn alpha(scene: &Scene) -> f64 {
    Rollout::<f64>::of(scene).unwrap().rows().fold(0.0, |most, row| row.alpha.max(most))
}

/// A loop that is stable by itself stays so: POPC at half of m / T drives it away, at the cap of the rule it settles.
#[test]
fn a_loop_that_is_stable_alone_settles_under_popc_8_ticks_late() {
    let half = summary(&press(8, "[stabilizer.popc]\ndamping_cap = 0.5"));
    assert!(half.settled.is_none() && half.acting_peak > 1e100, "{}", half.acting_peak);
    let late = summary(&press(8, "[stabilizer.popc]"));
    let settled = late.settled.unwrap();
    assert!((1.5..2.1).contains(&settled), "{settled}");
    // A comparison takes the same, and says that the loop alone is stable.
    let comparison = Comparison::of("press", &press(8, ""), &Entrants::<f64>::standard()).unwrap();
    for score in comparison.scores() {
        assert!(score.verdict.is_bounded(), "{}", score.stabilizer);
    }
}

/// `0.5 tan(π / (4 (d + 1)))` of m / T, m = 0.3 kg and T = 1 ms: reached and not passed.
#[test]
fn the_default_cap_follows_the_delay() {
    for ticks in [0, 1, 2, 8, 1024] {
        let scene = press(ticks, "[stabilizer.popc]");
        let cap = 0.5 * (FRAC_PI_4 / (1.0 + f64::from(ticks))).tan();
        assert_relative_eq!(scene.damping_cap(), cap, max_relative = 1e-12);
        assert_eq!(scene.written_cap(), None);
        for name in StabilizerName::ALL {
            let caps = name.parameters(&scene).into_iter().filter(|it| it.name() == "damping_cap");
            for given in caps {
                assert_eq!(given.default, Some(scene.damping_cap()), "{name}");
            }
        }
        assert!(alpha(&scene) <= cap * 0.3 / 1e-3 * (1.0 + 1e-12));
    }
    // Where it bites: the shipped press, at 2 kN/m.
    let stiff =
        Scene::parse(&format!("{}\n[stabilizer.popc]\n", text_of("press-1khz").unwrap()), "press");
    assert_relative_eq!(
        alpha(&stiff.unwrap()),
        0.5 * (FRAC_PI_4 / 2.0).tan() * 300.0,
        max_relative = 1e-12
    );
}

/// Written caps and scenes without a delay are what they were.
#[test]
fn a_written_cap_stays() {
    let rows = |scene: &Scene| -> Vec<Row> { Rollout::<f64>::of(scene).unwrap().rows().collect() };
    let prompt = text_of("press-1khz").unwrap().replace("ticks = 1", "ticks = 0");
    let of = |more: &str| Scene::parse(&format!("{prompt}\n{more}\n"), "press").unwrap();
    assert_eq!(rows(&of("[stabilizer.lolc]")), rows(&of("[stabilizer.lolc]\ndamping_cap = 0.5")));
    let written = press(8, "[stabilizer.popc]\ndamping_cap = 0.25");
    assert_eq!((written.damping_cap(), Settings::of(&written).damping_cap), (0.25, 0.25));
    let rule = press(8, "[stabilizer.popc]").damping_cap();
    let same = press(8, &format!("[stabilizer.popc]\ndamping_cap = {rule:?}"));
    assert_eq!(rows(&same), rows(&press(8, "[stabilizer.popc]")));
}

/// `run`, `explain` and `compare` say when a written cap is too high for the delay, in words and as JSON.
#[test]
fn a_cap_above_the_limit_of_the_delay_is_told() {
    let told = |scene: &Scene| -> [String; 6] {
        let (run, explained) = (summary(scene), Explanation::of::<f64>(scene).unwrap());
        let entrants = Entrants::<f64>::standard();
        let compared = Comparison::of("press", scene, &entrants).unwrap();
        [
            run.to_string(),
            explained.to_string(),
            compared.to_string(),
            run.to_json("press"),
            explained.to_json("press"),
            lyapunov_lab::compare::document(&[compared], &[]),
        ]
    };
    let short = |text: &str| text.replace("duration = 4.0", "duration = 0.4");
    let of = |ticks: u32, more: &str| {
        let text =
            short(text_of("press-1khz").unwrap()).replace("ticks = 1", &format!("ticks = {ticks}"));
        Scene::parse(&format!("{text}\n{more}\n"), "press").unwrap()
    };
    let high = told(&of(8, "[stabilizer.popc-bounded]\ndamping_cap = 0.5"));
    for text in &high[..3] {
        let sentence = "above 0.0437443318 m / T, the limit for a delay of 8 ticks";
        assert!(text.contains(sentence), "{text}");
    }
    high[3..]
        .iter()
        .for_each(|json| assert!(json.contains("\"damping_cap_limit\": 0.043"), "{json}"));
    for quiet in [
        of(8, "[stabilizer.popc]"),
        of(8, "[stabilizer.popc]\ndamping_cap = 0.04"),
        of(0, "[stabilizer.popc]\ndamping_cap = 2.0"),
        of(8, "[stabilizer.tank]"),
    ] {
        for text in told(&quiet) {
            assert!(
                !text.contains("the limit for a delay") && !text.contains("damping_cap_limit"),
                "{text}"
            );
        }
    }
}

/// Each cell of a map takes the cap for its own delay, and a written one as it is.
#[test]
fn cells_of_a_map_take_the_cap_for_their_own_delay() {
    let cells = |more: &str| {
        let [x, y] = ["effects.delay.ticks=0..8:9", "environment.wall.stiffness=230..460:2"]
            .map(|axis| axis.parse::<Axis>().unwrap());
        let popc: StabilizerName = "popc".parse().unwrap();
        Grid::new(press(1, more), x, y, [popc]).unwrap()
    };
    for cell in [0_u32, 3, 8, 17] {
        let rule = 0.5 * (FRAC_PI_4 / (1.0 + f64::from(cell % 9))).tan();
        for more in ["", "[stabilizer.popc]"] {
            let cell = cells(more).scene_of(cell.into()).unwrap();
            assert_relative_eq!(cell.damping_cap(), rule, max_relative = 1e-12);
        }
        let written = cells("[stabilizer.popc]\ndamping_cap = 0.3").scene_of(cell.into()).unwrap();
        assert_eq!(written.damping_cap(), 0.3);
    }
}
