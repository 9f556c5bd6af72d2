//! Scenes that break a rule, and the contents of their messages.

use super::{FULL, SMALLEST, fault, line_of, scene, smallest_and, with};

/// A part of the full example, its replacement, the key at fault, and words that the message must contain.
type Case = (&'static str, &'static str, &'static str, &'static [&'static str]);

#[rustfmt::skip]
const CASES: &[Case] = &[
    ("duration = 10.0 ", "duration = 0 ", "duration", &["greater than 0", "not 0.0", "unit is s"]),
    ("duration = 10.0 ", "duration = -1 ", "duration", &["greater than 0", "-1.0"]),
    ("duration = 10.0 ", "duration = nan ", "duration", &["finite", "NaN"]),
    ("duration = 10.0 ", "duration = inf ", "duration", &["finite", "not inf"]),
    ("duration = 10.0 ", "duration = 1e400 ", "duration", &["1e400", "64 bits"]),
    ("duration = 10.0 ", "duration = 10000000.1 ", "duration", &["10000000.1 s", "1e9 ticks", "10000000.0 s"]),
    ("duration = 10.0 ", "duration = 1e308 ", "duration", &["1e308 s", "inf ticks"]),
    ("duration = 10.0 ", "duration = \"10\" ", "duration", &["must be a number, not the text \"10\"", "duration = 10.0"]),
    ("duration = 10.0 ", "duration = true ", "duration", &["must be a number", "true"]),
    ("duration = 10.0 ", "duration = [10.0] ", "duration", &["must be a number, not a list"]),
    ("duration = 10.0 ", "duration = { s = 10.0 } ", "duration", &["must be a number, not a table"]),
    ("duration = 10.0 ", "duration = 00:00:10 ", "duration", &["must be a number", "date or time 00:00:10"]),
    ("servo_rate = 100.0 ", "servo_rate = 0.0 ", "servo_rate", &["greater than 0", "Hz"]),
    ("servo_rate = 100.0 ", "servo_rate = -100 ", "servo_rate", &["greater than 0", "-100.0"]),
    ("servo_rate = 100.0 ", "servo_rate = 1e-310 ", "servo_rate", &["too small", "period"]),
    ("environment_rate = 100.0 ", "environment_rate = 0 ", "environment_rate", &["greater than 0", "Hz"]),
    ("environment_rate = 100.0 ", "environment_rate = 30.0 ", "environment_rate",
        &["30.0 Hz does not divide", "whole number of 1 or more", "33.333333333333336 Hz (ratio 3)", "25.0 Hz (ratio 4)"]),
    ("environment_rate = 100.0 ", "environment_rate = 200 ", "environment_rate", &["200.0 Hz", "at most the servo rate, 100.0 Hz"]),
    ("environment_rate = 100.0 ", "environment_rate = 99.999999 ", "environment_rate", &["99.999999 Hz", "does not divide"]),
    ("environment_rate = 100.0 ", "environment_rate = 1e-308 ", "environment_rate", &["1e-308 Hz", "inf"]),
    ("\"backward-difference\"", "\"backward_diference\"", "velocity", &["backward_diference", "did you mean \"backward-difference\"", "\"exact\""]),
    ("velocity = \"backward-difference\"", "velocity = 1", "velocity", &["the number 1", "one of: \"backward-difference\", \"exact\""]),
    ("\"f64\"", "\"F64\"", "scalar", &["did you mean \"f64\"", "\"f32\""]),
    ("\"f64\"", "\"double\"", "scalar", &["\"double\"", "one of: \"f64\", \"f32\""]),
    ("integrator = \"exact\"", "integrator = \"euler\"", "integrator", &["\"euler\"", "one of: \"exact\""]),
    ("integrator = \"exact\"", "integrator = \"dopri\"", "integrator", &["did you mean \"dopri5\"", "\"semi-implicit-euler\", \"implicit-midpoint\", \"rk4\", \"dopri5\", \"dop853\""]),
    ("integrator = \"exact\"", "steps_per_tick = 4", "steps_per_tick", &["`steps_per_tick` does not apply", "\"exact\" takes one step", "leave it out", "\"rk4\""]),
    ("integrator = \"exact\"", "tolerance = 1e-9", "tolerance", &["`tolerance` does not apply", "\"exact\" takes one step", "\"dopri5\" or \"dop853\""]),
    ("integrator = \"exact\"", "integrator = \"rk4\"\ntolerance = 1e-9", "tolerance", &["`tolerance` does not apply", "\"rk4\" takes equal steps", "`steps_per_tick`"]),
    ("integrator = \"exact\"", "integrator = \"dop853\"\nsteps_per_tick = 4", "steps_per_tick", &["\"dop853\" chooses its own steps", "`tolerance`"]),
    ("integrator = \"exact\"", "integrator = \"rk4\"\nsteps_per_tick = 0", "steps_per_tick", &["whole number from 1 to 1000000", "not 0", "steps_per_tick = 4"]),
    ("integrator = \"exact\"", "integrator = \"rk4\"\nsteps_per_tick = 1000001", "steps_per_tick", &["1 to 1000000"]),
    ("integrator = \"exact\"", "integrator = \"rk4\"\nsteps_per_tick = 1.5", "steps_per_tick", &["must be a whole number", "1.5"]),
    ("integrator = \"exact\"", "integrator = \"rk4\"\nsteps_per_tick = \"4\"", "steps_per_tick", &["must be a whole number"]),
    ("integrator = \"exact\"", "integrator = \"dopri5\"\ntolerance = 0", "tolerance", &["greater than 0", "not 0.0", "m and m/s"]),
    ("integrator = \"exact\"", "integrator = \"dopri5\"\ntolerance = nan", "tolerance", &["finite", "NaN"]),
    ("integrator = \"exact\"", "integrator = \"dopri5\"\ntolerance = 1e-15", "tolerance", &["1e-15", "rounding in f64", "give 1.7763568394002505e-15 or more"]),
    ("integrator = \"exact\"", "integrator = \"dopri5\"\ntolerance = 1e-320", "tolerance", &["rounding in f64"]),
    ("integrator = \"exact\"", "integrator = { exact = 1 }", "integrator.exact", &["must be a word in quotes"]),
    ("mass = 0.1", "mass = -0.1", "operator.mass", &["0 or greater", "-0.1", "unit is kg"]),
    ("mass = 0.1", "maas = 0.1", "operator.maas", &["unknown key `maas` in [operator]", "did you mean `mass`", "mass, damping, stiffness, rest"]),
    ("damping = 0.2", "damping = nan", "operator.damping", &["0 or greater", "NaN", "N.s/m"]),
    ("stiffness = 50.0", "stiffness = inf", "operator.stiffness", &["finite", "inf", "N/m"]),
    ("rest = 0.0", "rest = -inf", "operator.rest", &["must be finite", "-inf"]),
    ("rest = 0.0", "rest = 0.0\nservo_rate = 5", "operator.servo_rate", &["unknown key `servo_rate` in [operator]", "key of the top level (above the first [table])"]),
    ("mass = 0.2", "mass = 0", "device.mass", &["greater than 0", "kg"]),
    ("mass = 0.2", "mass = nan", "device.mass", &["greater than 0", "NaN"]),
    ("mass = 0.2", "mass = {}", "device.mass", &["must be a number, not a table"]),
    ("damping = 0.001", "damping = -1e-3", "device.damping", &["0 or greater", "-0.001"]),
    ("damping = 0.001", "dampng = 1", "device.dampng", &["did you mean `damping`", "mass, damping"]),
    ("position = -0.004", "position = inf", "initial.position", &["must be finite", "unit is m"]),
    ("velocity = 0.0", "velocity = nan", "initial.velocity", &["must be finite", "m/s"]),
    ("position = 0.0", "position = \"here\"", "environment.wall.position", &["must be a number, not the text \"here\""]),
    ("stiffness = 8000.0", "stifness = 8000.0", "environment.wall.stifness", &["`stifness` in [environment.wall]", "did you mean `stiffness`", "position, stiffness, damping"]),
    ("stiffness = 8000.0", "stiffness = -1", "environment.wall.stiffness", &["0 or greater", "-1.0", "N/m"]),
    ("damping = 2.0", "damping = -2.0", "environment.wall.damping", &["0 or greater", "-2.0", "N.s/m"]),
    ("[environment.wall]", "[environment.wal]", "environment.wal", &["unknown key `wal` in [environment]", "did you mean `wall`"]),
    ("[environment.wall]", "[wall]", "wall", &["unknown key `wall` at the top level", "[environment.wall]"]),
    ("[environment.wall]", "[[environment.wall]]", "environment.wall", &["must be a table, not a list", "single brackets"]),
    ("[environment.wall]", "[environment.spreng]\n[environment.wall]", "environment",
        &["two environments", "`spreng`", "`wall`", "there is no environment `spreng`"]),
    ("[environment.wall]           # one-sided\nposition = 0.0", "[environment]\nposition = 0.0", "environment.position",
        &["unknown key `position` in [environment]", "key of [environment.wall], [environment.spring]", "known keys here: wall"]),
    ("work = \"held\"", "work = \"hold\"", "stabilizer.lolc.work", &["\"hold\"", "did you mean \"held\"", "\"sampled\""]),
    ("\"mass-spring-damper\"", "\"mass_spring_damper\"", "stabilizer.lolc.candidate",
        &["did you mean \"mass-spring-damper\"", "\"device-damping\", \"spring\""]),
    ("work = \"held\"", "ledger = \"double\"", "stabilizer.lolc.ledger", &["\"double\"", "\"plain\"", "\"compensated\"", "\"wide\""]),
    ("damping_cap = 0.5", "damping_cap = -0.5", "stabilizer.lolc.damping_cap", &["0 or greater", "inf is allowed", "-0.5", "m / T"]),
    ("damping_cap = 0.5", "damping_cap = nan", "stabilizer.lolc.damping_cap", &["0 or greater", "NaN"]),
    ("damping_cap = 0.5", "damping_cap = 1e999", "stabilizer.lolc.damping_cap", &["1e999", "64 bits"]),
    ("damping_cap = 0.5", "cap = 0.5", "stabilizer.lolc.cap", &["did you mean `damping_cap`", "work, candidate, ledger, damping_cap"]),
    ("[stabilizer.lolc]", "[stabilizer.lock]", "stabilizer.lock", &["unknown key `lock` in [stabilizer]", "did you mean `lolc`", "lolc, popc"]),
    ("[stabilizer.lolc]", "[stabilizer.popc]\n[stabilizer.lolc]", "stabilizer", &["two stabilizers", "`popc`", "`lolc`", "only one"]),
    ("[effects.encoder]", "[effects.encodr]", "effects.encodr", &["did you mean `encoder`", "encoder, delay, saturation"]),
    ("resolution = 1e-5", "resolution = 0", "effects.encoder.resolution", &["greater than 0", "not 0.0", "unit is m"]),
    ("ticks = 2 ", "ticks = 2.5 ", "effects.delay.ticks", &["must be a whole number", "2.5", "0 to 1024"]),
    ("ticks = 2 ", "ticks = 2.0 ", "effects.delay.ticks", &["must be a whole number", "2.0", "0 to 1024"]),
    ("ticks = 2 ", "ticks = -1 ", "effects.delay.ticks", &["whole number from 0 to 1024", "not -1"]),
    ("ticks = 2 ", "ticks = 1025 ", "effects.delay.ticks", &["whole number from 0 to 1024", "not 1025"]),
    ("ticks = 2 ", "ticks = 99999999999999999999 ", "effects.delay.ticks", &["99999999999999999999", "a whole number of 64 bits, sign included", "0 to 1024"]),
    ("ticks = 2 ", "ticks = \"2\" ", "effects.delay.ticks", &["must be a whole number, not the text \"2\""]),
    ("force = 8.0", "force = -8.0", "effects.saturation.force", &["greater than 0", "-8.0", "unit is N"]),
    ("stiffness = 50.0", "stiffness = 1e300", "operator.stiffness", &["within one period", "1e300 stands out"]),
    ("force = 8.0", "force = 0x", "effects.saturation.force", &["64 bits"]),
];

#[test]
fn each_broken_rule_names_key_line_value_and_remedy() {
    for (part, replacement, key, words) in CASES {
        let text = with(part, replacement);
        let fault = fault(&text);
        let shown = fault.to_string();
        assert_eq!(fault.key(), Some(*key), "{shown}");
        assert_eq!(fault.line(), Some(line_of(part, replacement)), "{shown}");
        let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        for word in *words {
            assert!(unfolded.contains(word), "no {word:?} in:\n{shown}");
        }
        for jargon in ["invalid type", "expected f64", "variant", "struct", "Problem"] {
            assert!(!shown.contains(jargon), "{jargon:?} in:\n{shown}");
        }
    }
}

#[test]
fn popc_has_no_candidate() {
    let fault = fault(&with("[stabilizer.lolc]", "[stabilizer.popc]"));
    let shown = fault.to_string();
    assert_eq!(fault.key(), Some("stabilizer.popc.candidate"));
    assert_eq!(fault.line(), Some(line_of("candidate = ", "candidate")));
    assert!(shown.contains("unknown key `candidate` in [stabilizer.popc]"), "{shown}");
    assert!(shown.contains("`candidate` is a key of [stabilizer.lolc]"), "{shown}");
    assert!(shown.contains("known keys here: work, ledger, damping_cap"), "{shown}");
}

#[test]
fn the_message_holds_the_given_value() {
    let value = |part, replacement| fault(&with(part, replacement)).value().map(str::to_owned);
    assert_eq!(value("mass = 0.2", "mass = -2e-1").as_deref(), Some("-2e-1"));
    assert_eq!(value("\"f64\"", "'f46'").as_deref(), Some("'f46'"));
    assert_eq!(value("ticks = 2 ", "ticks = 4_000").as_deref(), Some("4_000"));
    assert_eq!(value("environment_rate = 100.0", "environment_rate = 30").as_deref(), Some("30"));
}

#[test]
fn missing_keys_are_named_with_their_unit_and_a_line_to_add() {
    #[rustfmt::skip]
    let cases: [(String, &str, usize, &[&str]); 8] = [
        (SMALLEST.replace("duration = 1.0  # s\n", ""), "duration", 1, &["in s", "duration = 10.0", "above the first [table]"]),
        (SMALLEST.replace("servo_rate = 1000.0  # Hz\n", ""), "servo_rate", 1, &["in Hz", "servo_rate = "]),
        (SMALLEST.replace("mass = 0.2  # kg\n", ""), "device.mass", 3, &["in kg", "to [device]", "mass = 0.2"]),
        (SMALLEST.replace("[device]\nmass = 0.2  # kg\n", ""), "device.mass", 1, &["no [device]", "mass = 0.2", "kg"]),
        (SMALLEST.replace("stiffness = 8000.0  # N/m", ""), "environment.wall.stiffness", 5, &["in N/m", "stiffness = 8000.0"]),
        (SMALLEST.replace("[environment.wall]\nstiffness = 8000.0  # N/m", ""), "environment.wall.stiffness", 1,
            &["no [environment]", "[environment.wall]"]),
        (smallest_and("[effects.encoder]"), "effects.encoder.resolution", 7, &["in m", "resolution = 1e-5"]),
        (smallest_and("[effects.delay]\n[effects.saturation]\nforce=1"), "effects.delay.ticks", 7, &["ticks = 2"]),
    ];
    for (text, key, line, words) in cases {
        let fault = fault(&text);
        let shown = fault.to_string();
        assert_eq!((fault.key(), fault.line()), (Some(key), Some(line)), "{shown}");
        for word in words {
            assert!(shown.contains(word), "no {word:?} in:\n{shown}");
        }
    }
}

#[test]
fn an_empty_choice_lists_its_options() {
    let shown = fault(&smallest_and("[stabilizer]")).to_string();
    assert!(shown.contains("[stabilizer] is empty"), "{shown}");
    assert!(shown.contains("[stabilizer.lolc], [stabilizer.popc]"), "{shown}");

    let text = format!("stabilizer = \"popc\"\n{SMALLEST}");
    let shown = fault(&text).to_string();
    assert!(shown.contains("must be a table, not the text \"popc\""), "{shown}");
    assert!(shown.contains("[stabilizer.popc]"), "{shown}");

    let text = format!("stabilizer = \"none\"\n{SMALLEST}");
    assert!(fault(&text).to_string().contains("must be a table"));

    let text = SMALLEST.replace("[environment.wall]\nstiffness = 8000.0  # N/m", "");
    let shown = fault(&format!("environment = 8000.0\n{text}")).to_string();
    assert!(shown.contains("`environment` must be a table, not the number 8000.0"), "{shown}");
}

#[test]
fn the_first_fault_of_the_text_is_reported() {
    let text = with("duration = 10.0 ", "duration = -10.0 ").replace("mass = 0.2", "mass = -0.2");
    assert_eq!(fault(&text).key(), Some("duration"));
    let text = FULL.replace("rest = 0.0", "zzz = 0.0").replace("damping = 0.2", "damping = -1");
    assert_eq!(fault(&text).key(), Some("operator.damping"));
}

#[test]
fn the_suggested_rates_are_valid() {
    for rate in ["30.0", "66.7", "99.0", "0.3", "7.0"] {
        let given = format!("environment_rate = {rate}");
        let shown = fault(&with("environment_rate = 100.0", &given)).to_string();
        let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        let offered = unfolded.split("nearest rates that do are ").nth(1).unwrap();
        let rates: Vec<_> =
            offered.split(" and ").filter_map(|part| part.split(' ').next()).collect();
        assert_eq!(rates.len(), 2, "{shown}");
        for rate in rates {
            scene(&with("environment_rate = 100.0", &format!("environment_rate = {rate}")));
        }
    }
}

#[test]
fn single_precision_must_hold_every_number() {
    let single = FULL.replace("\"f64\"", "\"f32\"");
    scene(&single);
    scene(&single.replace("damping_cap = 0.5", "damping_cap = inf"));
    for (part, replacement, key) in [
        ("mass = 0.2", "mass = 1e-50", "device.mass"),
        ("stiffness = 8000.0", "stiffness = 1e39", "environment.wall.stiffness"),
        ("force = 8.0", "force = 1e300", "effects.saturation.force"),
    ] {
        scene(&with(part, replacement));
        let text = single.replace(part, replacement);
        let fault = fault(&text);
        assert_eq!(fault.key(), Some(key));
        assert_eq!(fault.line(), Some(line_of(part, replacement)));
        assert!(fault.to_string().contains("f32"), "{fault}");
    }
}

#[test]
fn single_precision_rejects_a_fine_tolerance() {
    let text = with("\"f64\"", "\"f32\"")
        .replace("integrator = \"exact\"", "integrator = \"dopri5\"\ntolerance = 1e-7");
    let fault = fault(&text);
    assert_eq!((fault.key(), fault.value()), (Some("tolerance"), Some("1e-7")));
    assert!(fault.to_string().contains("rounding in f32"), "{fault}");
}

#[test]
fn a_quoted_key_is_not_taken_for_a_path() {
    let fault = fault(&format!("\"environment.wall\" = 1\n{SMALLEST}"));
    assert_eq!(fault.message(), "unknown key `environment.wall` at the top level");
}
