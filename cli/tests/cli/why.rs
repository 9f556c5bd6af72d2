//! Tests of `bound`, of `explain`, and of the two lines that `run` prints of them.

use approx::assert_abs_diff_eq;
use serde_json::Value;

use crate::cli::place::Place;

const LIMITS: [&str; 5] = [
    "passive_max_stiffness",
    "gil_max_stiffness",
    "friction_quantization_max_stiffness",
    "exact_max_stiffness",
    "spectral_radius",
];

const WALL: &str = "duration = 2\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 3.0 }\n\
    operator = { mass = 0.1, damping = 0.5, stiffness = 50, rest = 0.004 }\n\
    initial.position = -0.004\nenvironment.spring.stiffness = 40000\n";

fn place() -> Place {
    let place = Place::new();
    place.put("wall.toml", WALL);
    place
}

#[test]
fn the_limits_are_printed_in_words_and_as_json() {
    let place = place();
    let said = place.run(["bound", "wall.toml"]);
    said.ended(
        0,
        &["passive, any operator 6000", "6.667 times too stiff", "the linear loop is not stable"],
    );
    assert_eq!(said.err, "");
    let said = place.run(["bound", "wall.toml", "--json"]);
    said.ended(0, &[]);
    let told: Value = serde_json::from_str(&said.out).unwrap();
    assert_abs_diff_eq!(told["passive_max_stiffness"].as_f64().unwrap(), 6000.0, epsilon = 1e-6);
    assert_abs_diff_eq!(told["gil_max_stiffness"].as_f64().unwrap(), 7000.0, epsilon = 1e-6);
    assert!(told["spectral_radius"].as_f64().unwrap() > 1.0);
    assert_eq!(told["friction_quantization_max_stiffness"], Value::Null);
    for key in LIMITS {
        assert!(told.get(key).is_some(), "{key}");
    }
    let quiet = place.run(["bound", "wall.toml", "--quiet"]);
    quiet.ended(0, &[]);
    assert_eq!((quiet.out, quiet.err), (String::new(), String::new()));
}

#[test]
fn a_run_that_stays_in_balance_says_so_in_one_sentence() {
    let place = place();
    place.put("calm.toml", WALL.replace("rest = 0.004", "rest = 0.0").replace("= -0.004", "= 0.0"));
    let run = place.run(["run", "calm.toml", "--out", "calm"]);
    run.ended(0, &["verdict settles", "starts in balance", "start it elsewhere"]);
    let words = run.out.split_whitespace().collect::<Vec<_>>().join(" ");
    let sentence = words.split(" note ").nth(1).unwrap().split("elsewhere").next().unwrap();
    let page = place.text("calm/report.html");
    assert!(page.contains(&format!("<td>{sentence}elsewhere</td>")), "{sentence}");
}

#[test]
fn a_remedy_put_into_the_file_ends_what_grows() {
    let place = place();
    let run = place.run(["run", "wall.toml"]);
    run.ended(
        0,
        &["verdict grows", "times what the linear loop bears by itself", "`lyapunov explain`"],
    );
    place
        .run(["explain", "wall.toml"])
        .ended(0, &["verdict grows", "linear loop not stable", "through the hold", "what helps"]);
    let told: Value =
        serde_json::from_str(&place.run(["explain", "wall.toml", "--json"]).out).unwrap();
    assert_eq!((&told["verdict"], &told["verdict_by"]), (&"grows".into(), &"distance".into()));
    assert_abs_diff_eq!(
        told["groups"]["krt_over_b"].as_f64().unwrap(),
        40000.0 * 0.001 / 3.0,
        epsilon = 1e-9
    );
    for remedy in told["remedies"].as_array().unwrap() {
        assert!(["settles", "swinging"].contains(&remedy["verdict"].as_str().unwrap()), "{remedy}");
    }
    let set: Vec<_> = told["remedies"].as_array().unwrap().iter().map(|it| &it["set"]).collect();
    assert!(set.len() >= 2);
    let softer = set.iter().find_map(|set| set["environment.spring.stiffness"].as_f64()).unwrap();
    place.put("soft.toml", WALL.replace("40000", &softer.to_string()));
    let run = place.run(["run", "soft.toml"]);
    run.ended(0, &[]);
    assert!(!run.out.contains("grows"), "{}", run.out);
    let faster = set.iter().find_map(|set| set["servo_rate"].as_f64()).unwrap();
    place.put("fast.toml", WALL.replace("1000", &faster.to_string()));
    assert!(!place.run(["run", "fast.toml"]).out.contains("grows"));

    // A delay is so many ticks, which a faster servo makes shorter: the remedy says so.
    place.put("late.toml", format!("{WALL}effects.delay.ticks = 2\n"));
    let said = place.run(["explain", "late.toml", "--json"]).out;
    let told: Value = serde_json::from_str(&said).unwrap();
    let mut set = told["remedies"].as_array().unwrap().iter().map(|it| &it["set"]);
    let faster = set.find_map(|set| set["servo_rate"].as_f64()).unwrap();
    let lasts = format!("its delay is then {:.4}", 2e3 / faster);
    let explained = place.run(["explain", "late.toml"]);
    explained.ended(0, &[lasts.trim_end_matches('0')]);
    assert_eq!(explained.out.matches("its delay is then").count(), 1);
}

/// A run that a saturation keeps bounded has the reason of the loop that is not stable; not under a stabilizer.
#[test]
fn a_run_that_swings_in_an_unstable_loop_has_its_reason() {
    let place = place();
    let reason = "times what the linear loop bears by itself";
    place.put("limited.toml", format!("{WALL}effects.saturation.force = 8\n"));
    let run = place.run(["run", "limited.toml", "--out", "out"]);
    run.ended(
        0,
        &["verdict swinging", "why", reason, "the saturation bounds the run", "`lyapunov explain`"],
    );
    assert!(place.text("out/report.html").contains("the saturation bounds the run"));
    // A friction that holds it is not named.
    place.put(
        "rubbed.toml",
        format!("{WALL}effects.friction.coulomb = 5\n").replace("-0.004", "-1e-4"),
    );
    let rubbed = place.run(["run", "rubbed.toml"]);
    assert!(!rubbed.out.contains("saturation"), "{}", rubbed.out);
    assert_eq!(rubbed.out.contains("swinging"), rubbed.out.contains("why"), "{}", rubbed.out);
    place.put("held.toml", format!("{WALL}effects.saturation.force = 8\nstabilizer.popc = {{}}\n"));
    let held = place.run(["run", "held.toml"]);
    assert!(!held.out.contains("grows") && !held.out.contains("why"), "{}", held.out);
}

#[test]
fn the_rule_of_a_passive_spring_stands_where_it_holds() {
    let place = place();
    let rule = "K r T / b below 2 is passive";
    place.run(["explain", "wall.toml"]).ended(0, &[rule]);
    for (name, scene) in [
        ("late.toml", format!("{WALL}effects.delay.ticks = 1\n")),
        ("bare.toml", WALL.replace("damping = 3.0", "damping = 0.0")),
    ] {
        place.put(name, scene);
        let told = place.run(["explain", name]);
        told.ended(0, &["groups", "delay"]);
        assert!(!told.out.contains(rule), "{}", told.out);
    }
}

#[test]
fn bad_input_is_refused() {
    let place = place();
    place.put("flat.toml", include_str!("../../../scenes/plane.toml"));
    place.refuses(["bound", "none.toml"], &["none.toml", "there is no such file"]);
    place.refuses(["explain", "none.toml"], &["none.toml", "there is no such file"]);
    place.refuses(
        ["run", "plane"],
        &["there is no such file", "`lyapunov scenes plane > plane.toml`"],
    );
    place.run(["explain", "flat.toml"]).ended(0, &["through the hold", "as if it were flat"]);
    place.refuses(["explain", "wall.toml", "--json", "--quiet"], &["'--json'", "'--quiet'"]);
    place.run(["bound", "flat.toml"]).ended(0, &["along the normal"]);
}

/// A loop whose environment is not what drives it, or only pulls, is told so instead of a limit that it keeps.
#[test]
fn a_limit_says_nothing_of_what_is_not_touched_or_only_pulls() {
    let place = place();
    place.put("pulls.toml", WALL.replace("stiffness = 40000", "stiffness = -400"));
    let bound = place.run(["bound", "pulls.toml"]);
    bound.ended(0, &["the linear loop is not stable", "below 0: only the radius tells"]);
    assert!(!bound.out.contains("within it"), "{}", bound.out);
    let run = place.run(["run", "pulls.toml"]);
    run.ended(
        0,
        &[
            "verdict grows",
            "look at environment.spring pushes away by -400 N/m",
            "nothing holds it",
        ],
    );
    let away =
        WALL.replace("spring.stiffness = 40000", "wall = { stiffness = 40000, position = 1 }");
    place.put("away.toml", away + "effects.pulse = { start = 1.5, duration = 0.3, force = 5 }\n");
    let run = place.run(["run", "away.toml"]);
    run.ended(0, &["verdict grows", "look at f_env is 0 on all 2001 ticks", "why no force acts"]);
    assert!(!run.out.contains("times what the linear loop bears"), "{}", run.out);
    place
        .run(["explain", "away.toml"])
        .ended(0, &["look at f_env is 0", "no force acts in this run"]);
    let map = [
        "map",
        "away.toml",
        "--x",
        "environment.wall.stiffness=500..5000:2",
        "--y",
        "device.damping=3..4:2",
    ];
    let calm = place.text("away.toml").replace("force = 5", "force = 0");
    place.put("away.toml", calm);
    place.run(map).ended(0, &["look at: no force acts in any of the 4 cells"]);
    let json: Value =
        serde_json::from_str(&place.run(map.into_iter().chain(["--json"])).out).unwrap();
    assert_eq!(json["look_at"][0]["sign"], "untouched");
    place
        .run([
            "map",
            "wall.toml",
            "--x",
            "environment.spring.stiffness=500..5000:2",
            "--y",
            "device.damping=3..4:2",
        ])
        .ended(0, &["bounded"]);
}

const STIFF: &str = include_str!("../../../scenes/paper-50k-popc.toml");

#[test]
fn a_small_cap_is_told_and_not_the_stiffness_that_a_larger_one_holds() {
    let place = Place::new();
    place.put("half.toml", STIFF);
    place.put("tenth.toml", STIFF.replace("damping_cap = 0.5", "damping_cap = 0.1"));
    let tenth = place.run(["run", "tenth.toml"]);
    tenth.ended(0, &["verdict grows", "cap 0.1 m / T left a debt unpaid", "up to 0.5"]);
    assert!(!tenth.out.contains("times what the linear loop bears"), "{}", tenth.out);
    place.run(["run", "half.toml"]).ended(0, &["verdict settles"]);
}

/// The time is read from the rows, where ten times the start of 4 mm are 40 mm.
#[test]
fn a_run_that_went_away_tells_since_when() {
    let place = Place::new();
    place.put("wall.toml", STIFF.replace("damping_cap = 0.5", "damping_cap = 0.1"));
    let rows = place.run(["run", "wall.toml", "--csv", "-"]).out;
    let number =
        |row: &str, column: usize| -> f64 { row.split(',').nth(column).unwrap().parse().unwrap() };
    let head = rows.lines().next().unwrap();
    let x = head.split(',').position(|name| name == "x").unwrap();
    let first = rows.lines().skip(1).find(|row| number(row, x).abs() > 0.04).unwrap();
    let told = format!("at t = {} s", number(first, 0));
    place.run(["run", "wall.toml"]).ended(0, &[&told, "came out of the port"]);
}

#[test]
fn a_passive_limit_of_0_has_a_reason() {
    let place = Place::new();
    let wall = WALL.replace(
        "environment.spring.stiffness = 40000",
        "environment.wall = { stiffness = 9, damping = 4 }",
    );
    place.put("wall.toml", &wall);
    let reason = "the wall's damping of 4 N.s/m alone needs 4 N.s/m of the device, which has 3";
    place.run(["bound", "wall.toml"]).ended(0, &["passive, any operator 0", reason]);
    place.put("wall.toml", wall.replace("damping = 4", "damping = 2"));
    let within = place.run(["bound", "wall.toml"]);
    within.ended(0, &["passive, any operator"]);
    assert!(!within.out.contains("no stiffness is passive"), "{}", within.out);
    // An environment that answers every eighth tick needs more of the device than its own damping.
    place.put(
        "wall.toml",
        format!("environment_rate = 125\n{}", wall.replace("damping = 4", "damping = 2")),
    );
    let slow = place.run(["bound", "wall.toml"]);
    slow.ended(0, &["the wall's damping of 2 N.s/m alone needs", "of the device, which has 3"]);
}

/// A first force that no number holds is told as what it is, and not as no force at all.
#[test]
fn a_first_force_beyond_the_range_is_not_called_none() {
    let place = Place::new();
    let ball = "duration = 1\nservo_rate = 1000\nspace.dimensions = 3\ndevice.mass = 0.2\n\
        operator = { stiffness = 200, rest = [0, 0, 0.018] }\n\
        environment.sphere = { center = [0, 0, 0], radius = 1e306, stiffness = 3000 }\n";
    place.put("ball.toml", ball);
    let run = place.run(["run", "ball.toml"]);
    run.ended(0, &["verdict grows", "why the first force or way leaves the range"]);
    assert!(!run.out.contains("no force acts"), "{}", run.out);
    let explained = place.run(["explain", "ball.toml"]);
    explained.ended(0, &["the first force or way leaves the range", "no force could act"]);
    assert!(!explained.out.contains("never touched"), "{}", explained.out);
}

/// Two masses on a soft link, with a two-sided spring that is drawn at the start: energy goes to and fro between them.
const BEAT: &str = "duration = 4.024745706466804\nservo_rate = 5000\nvelocity = \"exact\"\ninitial.position = 0.004\n\
    operator = { mass = 1.2028498423197547, damping = 0.01, stiffness = 500 }\n\
    device = { mass = 0.5, damping = 0.08 }\nlink = { stiffness = 16.46871387640235, damping = 0.0 }\n\
    environment.spring.stiffness = 229.83017098847805\n";

#[test]
fn a_beat_that_grows_in_a_short_run_blames_nothing() {
    let place = Place::new();
    place.put("beat.toml", BEAT);
    place.run(["run", "beat.toml"]).ended(0, &["verdict grows", "linear and stable", "run longer"]);
    let told = place.run(["explain", "beat.toml"]);
    told.ended(0, &["where it was stored at the start", "linear and stable"]);
    assert!(!told.out.contains("what helps"), "{}", told.out);
    place.put("longer.toml", BEAT.replace("4.024745706466804", "600"));
    place.run(["run", "longer.toml"]).ended(0, &["verdict settles"]);
    // An encoder is beside the linear loop, and may drive it.
    place.put("coarse.toml", BEAT.to_owned() + "effects.encoder.resolution = 1e-9\n");
    place
        .run(["run", "coarse.toml"])
        .ended(0, &["verdict grows", "what drives the run is not in it"]);
}

#[test]
fn a_run_that_starts_in_balance_is_told_to_say_nothing_about_its_loop() {
    let at = |place: &str| {
        format!(
            "duration = 12\nservo_rate = 1000\ndevice = {{ mass = 0.2, damping = 0.1 }}\n\
             operator = {{ mass = 0.1, damping = 0.5, stiffness = 200, rest = 0.01 }}\n\
             initial.position = {place}\nenvironment.wall = {{ position = 0.002, stiffness = 3800 }}\n"
        )
    };
    let place = Place::new();
    place.put("balance.toml", at("0.0024"));
    let words = ["verdict settles", "starts in balance", "not stable: spectral radius 1.00216"];
    place.run(["run", "balance.toml"]).ended(0, &words);
    place.put("beside.toml", at("0.0025"));
    let beside = place.run(["run", "beside.toml"]);
    beside.ended(0, &["verdict"]);
    assert!(!beside.out.contains("balance") && !beside.out.contains("settles"), "{}", beside.out);
}

#[test]
fn studies_of_a_scene_in_balance_say_that_they_say_nothing() {
    let place = place();
    // 50 · 0.004 = 450 x.
    let calm =
        WALL.replace("40000", "400").replace("position = -0.004", "position = 4.44444444444444e-4");
    place.put("calm.toml", calm);
    let told = ["starts in balance", "start it elsewhere"];
    place
        .run(["compare", "calm.toml", "--stabilizers", "none,popc", "--out", "all"])
        .ended(0, &told);
    assert!(place.text("all/report.html").contains("starts in balance"));
    place.run(["tune", "calm.toml", "--trials", "2", "--runs", "2"]).ended(0, &told);
    let axes = ["--x", "device.damping=1..3:2", "--y", "device.mass=0.2..0.3:3"];
    let map = ["map", "calm.toml", "--stabilizers", "none,popc", "--out", "map"];
    place.run(map.into_iter().chain(axes)).ended(0, &["in 6 of 6 cells", told[0], told[1]]);
}
