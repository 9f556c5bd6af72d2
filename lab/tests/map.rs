//! Maps from outside: lanes against single runs, and both against the comparison of stabilizers.

use lyapunov_lab::bound::Limits;
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::map::{
    BasicName, Bounds, Grid, Instructions, Kernel, Lanes, Measures, Outcome, OverExact, Rendered,
    Run, Survey, areas,
};
use lyapunov_lab::{Scene, Verdict, Yardstick};
use proptest::prelude::*;

/// Scene of a hand before a wall, in which `more` replaces the lines of the same keys.
pub(crate) fn scene(more: &str) -> Scene {
    let usual = [
        ("duration", "1.0"),
        ("servo_rate", "1000.0"),
        ("environment_rate", "100.0"),
        ("operator", "{ mass = 0.1, damping = 0.2, stiffness = 50.0 }"),
        ("device", "{ mass = 0.2, damping = 0.001 }"),
        ("initial", "{ position = -0.004 }"),
        ("environment.wall", "{ stiffness = 8000.0, damping = 2.0 }"),
        ("stabilizer.lolc", "{ damping_cap = 0.5 }"),
    ];
    let given = |key: &str| more.lines().any(|line| line.starts_with(key));
    let usual = usual.iter().filter(|(key, _)| !given(key));
    let text: String = usual.map(|(key, value)| format!("{key} = {value}\n")).collect();
    Scene::parse(&format!("{text}{more}"), "test").unwrap_or_else(|fault| panic!("{fault}"))
}

pub(crate) fn grid(
    more: &str,
    x: &str,
    y: &str,
    members: &[impl Copy + Into<StabilizerName>],
) -> Grid {
    let axis = |text: &str| text.parse().unwrap();
    Grid::new(scene(more), axis(x), axis(y), members.iter().copied()).unwrap()
}

/// Outcomes of all cells, by the method that the scene calls for or one by one.
pub(crate) fn outcomes(grid: &Grid, alone: bool, threads: usize) -> Vec<Vec<Outcome>> {
    let run =
        if alone { Run::one_by_one(grid, Some(threads)) } else { Run::of(grid, Some(threads)) };
    let mut all = Vec::new();
    let put = &mut |first: u64, outcomes: &[Vec<Outcome>]| {
        assert_eq!(first, all.len() as u64);
        all.extend_from_slice(outcomes);
        Ok(())
    };
    run.unwrap().cells(0..grid.cells(), &|| true, put).unwrap();
    all
}

pub(crate) const STIFFNESS: &str = "environment.wall.stiffness";

#[test]
fn lanes_have_the_bits_of_single_runs() {
    let x = format!("{STIFFNESS}=100..50000:13");
    let grid = grid("", &x, "environment.wall.damping=0..100:7", &BasicName::ALL);
    let (lanes, alone) = (outcomes(&grid, false, 2), outcomes(&grid, true, 1));
    assert_eq!(lanes, alone);
    for verdict in [Verdict::Settles, Verdict::Swinging, Verdict::Grows] {
        let found = lanes.iter().flatten().filter(|outcome| outcome.verdict == verdict).count();
        assert!((10..500).contains(&found), "{found} {verdict}");
    }
}

#[test]
fn lanes_have_them_with_sampled_work_and_other_caps_too() {
    for more in [
        "stabilizer.lolc = { work = \"sampled\", damping_cap = 0.2 }\n",
        "environment_rate = 1000.0\n",
    ] {
        let x = format!("{STIFFNESS}=100..20000:9:log");
        let grid = grid(more, &x, "device.mass=0.01..0.4:5", &BasicName::ALL);
        assert_eq!(outcomes(&grid, false, 2), outcomes(&grid, true, 1), "{more}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Lanes of every kind, on every set of instructions, against one rollout at a time of the same source; and their
    /// verdicts against those of the loops that scenes are built of.
    #[test]
    fn any_grid_is_the_same_on_all_lanes(
        pair in 0_usize..4,
        scalar in prop_oneof![Just("f32"), Just("f64")],
        rate in prop_oneof![Just(100.0), Just(500.0), Just(1000.0)],
        basic_name in 0_usize..6,
        damping in 0.0..30.0_f64,
        width in 1.5..20.0_f64,
    ) {
        let axes = [
            (format!("{STIFFNESS}=50..{}:11", 2000.0 * width), format!("environment.wall.damping=0..{}:5", width)),
            (format!("device.mass=0.05..{}:9", 0.05 + 0.1 * width), format!("operator.stiffness=0..{}:7", 100.0 * width)),
            (format!("initial.velocity=-0.5..{width}:10"), "stabilizer.lolc.damping_cap=0..2:6".to_owned()),
            ("servo_rate=1000..3000:3".to_owned(), format!("{STIFFNESS}=50..{}:20", 2000.0 * width)),
        ];
        let (x, y) = &axes[pair];
        let more = format!(
            "environment_rate = {rate:?}\nscalar = \"{scalar}\"\n\
             environment.wall = {{ stiffness = 3000.0, damping = {damping:?} }}\n"
        );
        let basic_name = BasicName::ALL[basic_name];
        let grid = grid(&more, x, y, &[basic_name]);
        let cells: Vec<u64> = (0..grid.cells()).collect();
        let of = |set, lanes| {
            let kernel = Kernel::of(&grid, set, lanes).unwrap().unwrap();
            let verdicts = kernel.verdicts(basic_name, &cells, &|| true).unwrap().unwrap();
            (verdicts, kernel.measures(basic_name, &cells, &|| true).unwrap().unwrap())
        };
        let alone = of(Instructions::Base, Lanes::One);
        for set in Instructions::all() {
            prop_assert_eq!(&of(set, Lanes::Many), &alone, "{}", set.name());
        }
        let single = outcomes(&grid, true, 1);
        let single: Vec<_> = single.iter().map(|it| (it[0].verdict, it[0].verdict_by)).collect();
        prop_assert_eq!(&single, &alone.0);
    }
}

#[test]
fn any_number_of_a_scene_makes_an_axis() {
    let more = "effects = { delay.ticks = 1, encoder.resolution = 1e-5 }\n";
    let grid = grid(more, "effects.delay.ticks=0..4:5", "duration=0.9..1.1:3", &[BasicName::Popc]);
    let all = outcomes(&grid, false, 2);
    assert_eq!(all.len(), 15);
    // Two swings of the hand's spring take 0.973 s.
    let (short, long) = all.split_at(5);
    assert!(short.iter().flatten().all(|outcome| !outcome.verdict.is_bounded()));
    assert!(short.iter().flatten().any(|outcome| outcome.verdict == Verdict::TooShort));
    assert!(long.iter().flatten().all(|outcome| outcome.verdict != Verdict::TooShort));
    for outcome in all.iter().flatten() {
        let grows = outcome.verdict == Verdict::Grows;
        assert_eq!(outcome.measures.peak_force.is_none(), grows, "{outcome:?}");
    }
    assert_eq!(all, outcomes(&grid, false, 1));
}

#[test]
fn a_scene_without_a_spring_is_judged_by_its_speed() {
    let more = "operator = { mass = 0.1 }\ninitial = { position = -0.004, velocity = 0.1 }\nduration = 1.1\n";
    let x = format!("{STIFFNESS}=100..1000:3");
    let grid = grid(more, &x, "environment.wall.damping=0..5:2", &[BasicName::NoStabilizer]);
    let all = outcomes(&grid, false, 1);
    assert_eq!(all, outcomes(&grid, true, 1));
    let mut survey = Survey::of(&grid);
    for (cell, outcomes) in (0..).zip(&all) {
        // It meets the wall once, and flies on.
        assert_eq!(outcomes[0].verdict, Verdict::Swinging);
        assert_eq!(outcomes[0].verdict_by, Yardstick::Speed);
        assert!(outcomes[0].measures.peak_force.unwrap() > 0.0);
        assert_eq!(outcomes[0].measures.settling_time, None);
        survey.add(cell, outcomes);
    }
    assert_eq!((survey.by_speed(), survey.judged(0)), (6, 6));
    assert_eq!((survey.settling(0).share, survey.bounded(0).share), (Some(0.0), Some(1.0)));
}

/// A hand that stops without a place to rest at has settled, and the table says so.
#[test]
fn a_share_that_settles_by_speed_is_told() {
    let told = |more: &str| {
        let x = format!("{STIFFNESS}=100..1000:3");
        let grid = grid(more, &x, "environment.wall.damping=0..5:2", &[BasicName::NoStabilizer]);
        let survey = surveyed(&grid);
        assert_eq!(survey.by_speed(), 6);
        let settling = survey.settling(0).share;
        (settling, areas(&survey).lines().find(|it| it.starts_with("none")).unwrap().to_owned())
    };
    let start = "initial = { position = -0.004, velocity = 0.1 }\n";
    let (share, row) = told(&format!("operator = {{ mass = 0.1, damping = 5.0 }}\n{start}"));
    assert!(share == Some(1.0) && row.split_whitespace().nth(1) == Some("100.00"), "{row}");
    let (share, row) = told(&format!("operator = {{ mass = 0.1 }}\n{start}"));
    assert!(share == Some(0.0) && row.split_whitespace().nth(1) == Some("-"), "{row}");
}

/// A hand that is moved rests elsewhere in each lane, or is pushed by another force.
#[test]
fn lanes_have_rests_and_loads_of_their_own() {
    let more = "duration = 2.0\neffects.encoder.resolution = 1e-5\neffects.load.force = 0.5\noperator = { mass = 0.1, damping = 2.0, stiffness = 50.0, \
                motion = { kind = \"sine\", amplitude = 0.004, frequency = 2.0 } }\n";
    for x in ["operator.rest=-0.01..0.01:9", "effects.load.force=0..1:9"] {
        let grid = grid(more, x, &format!("{STIFFNESS}=100..900:2"), &[BasicName::Popc]);
        assert_eq!(outcomes(&grid, false, 2), outcomes(&grid, true, 1), "{x}");
    }
}

/// A lane whose operator has no spring runs beside lanes with one, and each is judged by its own yardstick.
#[test]
fn lanes_of_both_yardsticks_have_the_bits_of_single_runs() {
    for scalar in ["f64", "f32"] {
        let more = format!(
            "scalar = \"{scalar}\"\nduration = 2.0\ninitial = {{ position = -0.004, velocity = 0.1 }}\n\
             operator = {{ mass = 0.1, damping = 2.0, stiffness = 50.0 }}\n"
        );
        let x = "operator.stiffness=0..100:5";
        let grid = grid(&more, x, &format!("{STIFFNESS}=100..40000:9"), &BasicName::ALL);
        let (lanes, alone) = (outcomes(&grid, false, 2), outcomes(&grid, true, 1));
        for (cell, (lanes, alone)) in lanes.iter().zip(&alone).enumerate() {
            for (one, other) in lanes.iter().zip(alone) {
                let by = if cell % 5 == 0 { Yardstick::Speed } else { Yardstick::Distance };
                assert_eq!((one.verdict, one.verdict_by), (other.verdict, by), "{scalar} {cell}");
            }
        }
        let found = |verdict| lanes.iter().flatten().filter(|it| it.verdict == verdict).count();
        let counts = [Verdict::Settles, Verdict::Swinging, Verdict::Grows].map(found);
        assert!(counts.iter().all(|count| *count > 5), "{scalar}: {counts:?}");
    }
}

/// A lane with a spring too soft for the run is not judged, however its neighbours go.
#[test]
fn cells_that_are_too_short_are_counted_apart() {
    // Two swings take 4 pi sqrt(0.3 / k), one second from 47.4 N/m on.
    let x = "operator.stiffness=30..70:5";
    let grid = grid("", x, &format!("{STIFFNESS}=10..2000:9"), &[BasicName::NoStabilizer]);
    let all = outcomes(&grid, false, 2);
    assert_eq!(all, outcomes(&grid, true, 1));
    let mut survey = Survey::of(&grid);
    (0..).zip(&all).for_each(|(cell, outcomes)| survey.add(cell, outcomes));
    let short = survey.cells(0, Verdict::TooShort);
    assert!(short > 5 && survey.judged(0) == 45 - short, "{short}");
    for (cell, outcome) in all.iter().flatten().enumerate() {
        let soft = cell % 5 < 2;
        // A soft cell is judged only if it is lost.
        assert!(if soft {
            !outcome.verdict.is_bounded()
        } else {
            outcome.verdict != Verdict::TooShort
        });
    }
}

/// Reported ratio of a map of three rows, each of which holds this many of its ten stiffnesses.
fn told(x: &str, held: [u64; 3]) -> Option<OverExact> {
    told_of(x, &|row, column| match column < held[row as usize] {
        true if column % 2 == 0 => Verdict::Settles,
        true => Verdict::Swinging,
        false => Verdict::Grows,
    })
}

/// Reported ratio of a map of ten stiffnesses in three rows with these verdicts.
fn told_of(x: &str, verdict: &dyn Fn(u64, u64) -> Verdict) -> Option<OverExact> {
    let more = "environment.wall = { stiffness = 8000.0, damping = 20.0 }\n";
    let grid = grid(more, x, "initial.position=-0.005..-0.003:3", &[BasicName::Popc]);
    let mut survey = Survey::of(&grid);
    for cell in 0..grid.cells() {
        let verdict = verdict(cell / 10, cell % 10);
        let (verdict_by, measures) = (Yardstick::Distance, Measures::default());
        survey.add(cell, &[Outcome { verdict, verdict_by, measures }]);
    }
    Bounds::of(&grid).unwrap().over_exact(&survey, 0)
}

/// A stabilizer that holds up to the edge is reported as at least that, and one that holds nothing as zero.
#[test]
fn stiffnesses_beyond_the_edge_count_as_the_edge() {
    let more = "environment.wall = { stiffness = 8000.0, damping = 20.0 }\n";
    let exact = Limits::of(&scene(more)).exact.unwrap();
    assert!((2000.0..5500.0).contains(&exact), "{exact}");
    let x = format!("{STIFFNESS}=1000..10000:10");
    let over = |stiffness: f64, is_least| Some(OverExact { ratio: stiffness / exact, is_least });
    assert_eq!(told(&x, [10, 10, 10]), over(10_000.0, true));
    assert_eq!(told(&x, [6, 6, 10]), over(6000.0, false));
    assert_eq!(told(&x, [6, 10, 10]), over(10_000.0, true));
    assert_eq!(told(&x, [0, 0, 6]), over(0.0, false));
    // What holds up to an edge below the limit holds at least that; where it grows from the edge on, nothing is known.
    let [soft, hard] = ["10..100:10", "20000..50000:10"].map(|it| format!("{STIFFNESS}={it}"));
    assert_eq!(told(&soft, [10, 10, 10]), over(100.0, true));
    assert_eq!(told(&soft, [4, 4, 10]), over(40.0, false));
    assert_eq!(told(&soft, [4, 10, 10]), over(100.0, true));
    assert_eq!(told(&hard, [0, 0, 0]), None);
    assert_eq!(told(&hard, [10, 10, 10]), over(50_000.0, true));
    // Cells that are not judged say nothing: neither a whole row of them nor those before and behind the judged ones.
    let none = Verdict::TooShort;
    assert_eq!(told_of(&x, &|_, _| none), None);
    let held = |column| if column < 6 { Verdict::Swinging } else { Verdict::Grows };
    let some = |row, column| if row == 1 { held(column) } else { none };
    assert_eq!(told_of(&x, &some), over(6000.0, false));
    let within = |_, column| if (2..8).contains(&column) { Verdict::Settles } else { none };
    assert_eq!(told_of(&x, &within), over(8000.0, true));
    // Of two rows the median is the mean, and the least where the larger may be larger still.
    let two = |held: [u64; 2]| {
        let verdict = |row: u64, column| match held.get(row as usize) {
            Some(held) if column < *held => Verdict::Settles,
            Some(_) => Verdict::Grows,
            None => none,
        };
        told_of(&x, &verdict).map(|it| ((it.ratio * exact).round(), it.is_least))
    };
    assert_eq!(two([4, 8]), Some((6000.0, false)));
    assert_eq!(two([10, 4]), Some((7000.0, true)));
    // A map that begins beyond the bound shows what holds there.
    assert_eq!(told(&hard, [1, 1, 1]), over(20_000.0, false));
}

/// The survey of a map of `grid`.
fn surveyed(grid: &Grid) -> Survey {
    let mut survey = Survey::of(grid);
    for (cell, outcomes) in (0..).zip(outcomes(grid, false, 2)) {
        survey.add(cell, &outcomes);
    }
    survey
}

fn named(name: &str) -> StabilizerName {
    name.parse().unwrap()
}

/// A law whose device can pay for next to nothing keeps every cell calm by rendering no wall.
#[test]
fn what_renders_no_wall_does_not_head_the_map() {
    let names = [named("energy-bounding"), BasicName::NoStabilizer.into(), BasicName::Popc.into()];
    let x = format!("{STIFFNESS}=500..9000:5");
    let survey =
        surveyed(&grid("duration = 2.0\n", &x, "environment.wall.damping=0..20:3", &names));
    let share = |index: usize| survey.bounded(index).share.unwrap();
    let rendered = |index: usize| survey.rendered(index).percent.unwrap();
    assert!(share(0) == 1.0 && share(1) < 0.7 && share(2) == 1.0);
    assert!(rendered(0) < 1.0 && rendered(1) > 10.0 && rendered(2) > 70.0);
    assert_eq!(survey.ranking(), [2, 1, 0]);
    // It is what it claims to be: nothing is given beyond the device's damper.
    let bounding = survey.rendered(0);
    assert!(bounding.energy_given_beyond_damper.unwrap() < 1e-12, "{bounding:?}");
    assert!(survey.rendered(2).energy_given_beyond_damper.unwrap() > 0.1);
}

#[test]
fn a_map_counts_what_is_rendered_and_what_is_broken() {
    let names = [named("tank"), BasicName::NoStabilizer.into()];
    let grid_of = |names: &[StabilizerName]| {
        grid("", &format!("{STIFFNESS}=500..9000:4"), "environment.wall.damping=0..20:2", names)
    };
    let told = |verdict| Outcome {
        verdict,
        verdict_by: Yardstick::Distance,
        measures: Measures::default(),
    };
    let cell = |verdict, force, stiffness, given| Outcome {
        measures: Measures {
            force_felt: force,
            stiffness_felt: stiffness,
            energy_given: Some(given),
            energy_given_beyond_damper: Some(0.5 * given),
            ..Measures::default()
        },
        ..told(verdict)
    };
    let lost = told(Verdict::Grows);
    let bare = cell(Verdict::Swinging, Some(98.0), None, 0.0);
    let rows = [
        (cell(Verdict::Swinging, Some(90.0), Some(80.0), 1.0), lost),
        (cell(Verdict::Swinging, Some(350.0), None, 3.0), bare),
        (cell(Verdict::Swinging, Some(-5.0), Some(60.0), 2.0), bare),
        (cell(Verdict::Swinging, None, None, 0.0), bare),
        (lost, bare),
        (lost, lost),
        // A cell that is too short to judge is measured all the same.
        (
            cell(Verdict::TooShort, Some(10.0), None, 9.0),
            cell(Verdict::TooShort, Some(90.0), None, 1.0),
        ),
        (lost, bare),
    ];
    let grid = grid_of(&names);
    let mut survey = Survey::of(&grid);
    for (number, (tank, none)) in (0..).zip(rows) {
        survey.add(number, &[tank, none]);
    }
    let tank = Rendered {
        percent: Some((90.0 + 100.0) / 7.0),
        force_felt: Some((90.0 + 100.0 + 0.0 + 10.0) / 4.0),
        stiffness_felt: Some(70.0),
        energy_given: Some(9.0),
        energy_given_beyond_damper: Some(4.5),
        broke: Some(2),
    };
    assert_eq!(survey.rendered(0), tank);
    assert_eq!(survey.rendered(1).percent, Some(5.0 * 98.0 / 7.0));
    assert_eq!(survey.rendered(1).broke, Some(0));
    assert_eq!(survey.ranking(), [1, 0]);

    // Without `none` nobody knows what is bounded alone; without a force the bounded share ranks.
    let mut survey = Survey::of(&grid_of(&[BasicName::Popc.into(), named("tank")]));
    let calm = told(Verdict::Settles);
    survey.add(0, &[lost, calm]);
    assert_eq!(survey.rendered(0), Rendered::default());
    assert_eq!(survey.ranking(), [1, 0]);
}
