//! Logs that are not what the fit takes them for: each is told so, and a sound one beside it is not.

use lyapunov_lab::identify::{Identified, Settings, identify};

use super::loops::{Chance, PLAIN, Truth};

/// A hand that presses through an encoder.
const PRESS: Truth = Truth { rest: 0.012, wall: [0.005, 800.0, 3.0], encoder: 1e-5, ..PLAIN };

fn fitted(log: &str) -> Identified {
    identify(log.as_bytes(), "log.csv", &Settings::default()).unwrap()
}

fn of(truth: Truth, rows: usize) -> Identified {
    fitted(&truth.log(rows, &mut Chance::new(11)))
}

fn says(found: &Identified, words: &str) -> bool {
    found.report.notes.iter().any(|note| note.contains(words))
}

/// The text of `label` in the terminal's lines, unfolded.
fn line(found: &Identified, label: &str) -> String {
    let text = found.to_string();
    let begins = format!("  {label} ");
    let lines = text.lines().skip_while(|line| !line.starts_with(&begins));
    let goes_on = |(at, line): &(usize, &str)| *at == 0 || line.starts_with("     ");
    let lines = lines.enumerate().take_while(goes_on).map(|(_, line)| line.trim());
    lines.collect::<Vec<_>>().join(" ")
}

/// Names and rows, with the numbers of each row changed; none where it is dropped.
fn changed(log: &str, change: impl Fn(usize, [f64; 3]) -> Option<[f64; 3]>) -> String {
    let row = |(at, line): (usize, &str)| {
        let mut fields = line.split(',').map(|it| it.parse().unwrap());
        let [t, x, f] = change(at, std::array::from_fn(|_| fields.next().unwrap()))?;
        Some(format!("{t:?},{x:?},{f:?}\n"))
    };
    let rows = log.lines().skip(1).enumerate().filter_map(row);
    format!("t,x,f\n{}", rows.collect::<String>())
}

#[test]
fn fewer_rows_than_the_loop_has_ticks_are_told() {
    for (seed, every) in [(1, 10), (3, 5)] {
        let log = PRESS.log(2000, &mut Chance::new(seed));
        let few = fitted(&changed(&log, |row, it| (row % every == 0).then_some(it)));
        assert!(says(&few, "fewer rows than the loop has ticks"), "{seed}: {:?}", few.report.notes);
        let all = fitted(&log);
        assert_eq!(all.report.notes.len(), 1, "{:?}", all.report.notes);
    }
}

/// The steps of the encoder are as alike where the device rests, and are no error of the model.
#[test]
fn a_long_rest_is_no_error_of_the_model() {
    let found = of(Truth { damping: 60.0, ..PRESS }, 3000);
    assert!(!says(&found, "row after row"), "{:?}", found.report.notes);
}

#[test]
fn a_scene_that_does_not_reproduce_its_log_is_told_with_how_far_it_is_off() {
    let log = PLAIN.log(1500, &mut Chance::new(11));
    let offset = fitted(&changed(&log, |_, [t, x, f]| Some([t, x, f + 0.1])));
    let told = line(&offset, "run");
    assert!(told.contains("m off the log (root mean square): a loop at the edge"), "{told}");
    assert!(told.contains("an offset or a clipping of f"), "{told}");
    // Exact logs, and one whose scene lacks the noise, are within rounding and noise of their runs.
    for truth in [PLAIN, PRESS, Truth { noise: 5e-6, ..PLAIN }] {
        let told = line(&of(truth, 1500), "run");
        assert!(told.ends_with("m off the log (root mean square)"), "{told}");
    }
}

#[test]
fn a_wall_that_filters_the_velocity_is_told() {
    for seed in 0..6 {
        let truth = Truth { filter: 0.8, encoder: 1e-5, late: seed % 3, ..PLAIN };
        let found = fitted(&truth.log(1000, &mut Chance::new(20 + seed as u64)));
        assert!(says(&found, "a filtered v (give it as a column)"), "{:?}", found.report.notes);
    }
    for late in 0..5 {
        for sound in [
            Truth { late, encoder: 1e-5, ..PLAIN },
            Truth { late, blur: 2e-6, ..PLAIN },
            Truth { late, blur: 2e-5, ..PLAIN },
            Truth { late, noise: 5e-6, ..PLAIN },
        ] {
            let found = of(sound, 1000);
            assert!(!says(&found, "is not a spring"), "{sound:?}: {:?}", found.report.notes);
        }
    }
}

#[test]
fn a_clipped_force_is_told_and_goes_into_the_scene() {
    for late in [0, 2] {
        let found = of(Truth { limit: 2.0, late, encoder: 1e-5, ..PLAIN }, 1000);
        assert!(says(&found, "f stands at 2 N in "), "{:?}", found.report.notes);
        assert!(found.scene.contains("\n[effects.saturation]\nforce = 2.0\n"), "{}", found.scene);
        let wall = found.report.wall.unwrap();
        for (number, truth) in [wall.position, wall.stiffness, wall.damping].iter().zip(PLAIN.wall)
        {
            assert!((number.low..=number.high).contains(&truth), "{number:?}, {truth}");
        }
        assert!(found.report.replayed.unwrap() < 1e-4, "{:?}", found.report.replayed);
    }
    // A press that ends at rest holds its largest force in most rows.
    let rest = of(Truth { damping: 60.0, ..PRESS }, 3000);
    assert!(!says(&rest, "f stands") && !rest.scene.contains("saturation"), "{}", rest.scene);
    let stiffness = rest.report.wall.unwrap().stiffness;
    assert!((stiffness.value / 800.0 - 1.0).abs() < 1e-6, "{stiffness:?}");
}

#[test]
fn a_clipped_force_with_few_rows_below_is_told() {
    let damped = Truth { limit: 0.5, wall: [0.002, 1000.0, 40.0], rest: 0.001, ..PLAIN };
    let found = of(Truth { encoder: 1e-5, ..damped }, 1000);
    assert!(says(&found, "f stands at 500 mN in"), "{:?}", found.report.notes);
    assert!(!found.scene.contains("saturation"), "{}", found.scene);
}

#[test]
fn a_force_where_the_wall_gives_none_is_told() {
    let sound = PLAIN.log(800, &mut Chance::new(7));
    let words = "where this wall gives none";
    assert!(!says(&fitted(&sound), words));
    let pulls = |row: usize, f: f64| f == 0.0 && row % 4 == 1;
    let force = |line: &str| line.rsplit(',').next().unwrap().parse::<f64>().unwrap();
    let rows = sound.lines().skip(1).enumerate();
    let pulled = rows.filter(|(row, line)| pulls(*row, force(line))).count();
    let log = |row, [t, x, f]: [f64; 3]| Some([t, x, if pulls(row, f) { -3.0 } else { f }]);
    let found = fitted(&changed(&sound, log));
    let told = format!("f is up to 3 N in {pulled} rows {words}");
    assert!(says(&found, &told), "{told}: {:?}", found.report.notes);
}

#[test]
fn a_short_log_is_refused() {
    let error = |rows: usize| {
        let log = PLAIN.log(rows, &mut Chance::new(11));
        identify(log.as_bytes(), "log.csv", &Settings::default()).err()
    };
    assert!(error(49).unwrap().message().contains("too few rows"));
    assert!(error(50).is_none_or(|it| !it.message().contains("too few rows")));
}

#[test]
fn gaps_that_leave_too_little_are_counted() {
    let log = PLAIN.log(1000, &mut Chance::new(11));
    let cut = changed(&log, |row, it| (row % 6 != 5).then_some(it));
    let error = identify(cut.as_bytes(), "log.csv", &Settings::default()).unwrap_err();
    assert!(error.help().unwrap().starts_with("166 gaps cut the log: record every row"), "{error}");
    let short = PLAIN.log(49, &mut Chance::new(11));
    let error = identify(short.as_bytes(), "log.csv", &Settings::default()).unwrap_err();
    assert!(!error.help().unwrap().contains("gap"), "{error}");
}

#[test]
fn equal_stamps_have_a_remedy_of_their_own() {
    let log = PLAIN.log(200, &mut Chance::new(11));
    let help = |time: f64| {
        let log = changed(&log, |row, [t, x, f]| Some([if row == 90 { time } else { t }, x, f]));
        let error = identify(log.as_bytes(), "log.csv", &Settings::default()).unwrap_err();
        error.help().unwrap().to_owned()
    };
    assert!(help(1e-3 * 89.0).starts_with("equal stamps: write t with more digits"));
    assert!(help(1e-3 * 85.0).contains("sort the log"));
}

#[test]
fn columns_and_bad_rows_are_told_as_observe_tells_them() {
    let log = PLAIN.log(600, &mut Chance::new(11));
    let in_units = changed(&log, |_, [t, x, f]| Some([1e3 * t, 1e3 * x, f]));
    let mut lines: Vec<&str> = in_units.lines().collect();
    lines[0] = "t [ms],x [mm],force";
    lines[300] = "1,NaN,0";
    let found = fitted(&lines.join("\n"));
    let told = "columns     t is `t [ms]` in ms, x is `x [mm]` in mm, f is `force`";
    assert_eq!(line(&found, "columns"), told);
    let text = found.to_string();
    assert!(
        text.contains(
            "  bad rows    1, left out\n              line 301: x is `NaN`, out of range\n"
        ),
        "{text}"
    );
    let json: serde_json::Value = serde_json::from_str(&found.to_json()).unwrap();
    assert_eq!(json["columns"][1]["unit"], "mm");
    assert_eq!(json["decimal_commas"], false);
    assert!(!of(PLAIN, 600).to_string().contains("  columns"));
}

#[test]
fn an_exact_wall_leaves_nothing_but_rounding() {
    assert!(line(&of(PLAIN, 800), "wall").ends_with("it leaves nothing but rounding"));
    let blurred = line(&of(Truth { blur: 2e-5, ..PLAIN }, 800), "wall");
    assert!(blurred.ends_with("N of their force"), "{blurred}");
}

#[test]
fn lengths_have_the_prefix_that_suits_them() {
    let told = line(&of(PRESS, 1500), "residual");
    assert!(
        told.contains("x has steps of 10 \u{b5}m, which alone leave about 2.887 \u{b5}m"),
        "{told}"
    );
    let told = line(&of(Truth { encoder: 1e-3, ..PRESS }, 1500), "residual");
    assert!(told.contains("x has steps of 1 mm"), "{told}");
}
