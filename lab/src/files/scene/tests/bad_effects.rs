//! Scenes whose tables of effects break a rule, and the contents of their messages.

use super::{Scene, fault};

const HEAD: &str = "duration = 1.0\nservo_rate = 1000.0\n";

const REST: &str = "[device]\nmass = 0.2\n";

const WALL: &str = "[environment.wall]\nstiffness = 8000.0\n";

const PLANE: &str = "[environment.plane]\npoint = [0, 0]\nnormal = [0, 1]\nstiffness = 500\n";

/// The text below the smallest scene, the key at fault, its marked line, and words of the message.
type Case = (&'static str, &'static str, &'static str, &'static [&'static str]);

#[rustfmt::skip]
const ON_A_LINE: &[Case] = &[
    ("[effects.filter]\ncutoff = 0", "effects.filter.cutoff", "cutoff", &["greater than 0", "not 0.0", "Hz"]),
    ("[effects.filter]\ncutoff = inf", "effects.filter.cutoff", "cutoff", &["finite", "not inf"]),
    ("[effects.filter]\ncutoff = \"30\"", "effects.filter.cutoff", "cutoff", &["must be a number, not the text \"30\""]),
    ("[effects.filter]\ncutoff = 1e308", "effects.filter.cutoff", "cutoff", &["1e308", "range of f64"]),
    ("[effects.filter]\nwindow = 0", "effects.filter.window", "window", &["whole number from 1 to 256", "not 0"]),
    ("[effects.filter]\nwindow = 257", "effects.filter.window", "window", &["whole number from 1 to 256", "not 257"]),
    ("[effects.filter]\nwindow = 2.5", "effects.filter.window", "window", &["must be a whole number", "2.5", "1 to 256"]),
    ("[effects.filter]\nwindow = 4\ncutoff = 30", "effects.filter", "cutoff", &["two filters", "`window`", "`cutoff`", "keep one of these keys"]),
    ("[effects.filter]\ncutof = 30", "effects.filter.cutof", "cutof", &["unknown key `cutof` in [effects.filter]", "did you mean `cutoff`"]),
    ("[effects.filter]", "effects.filter", "[effects.filter]", &["[effects.filter] is empty", "cutoff", "window"]),
    ("[effects.noise]\ndeviation = -1e-6\nseed = 1", "effects.noise.deviation", "deviation", &["0 or greater", "-1e-6", "unit is m"]),
    ("[effects.noise]\ndeviation = nan\nseed = 1", "effects.noise.deviation", "deviation", &["finite", "NaN"]),
    ("[effects.noise]\ndeviation = 1e-6", "effects.noise.seed", "[effects.noise]", &["missing key `effects.noise.seed`", "seed = 1"]),
    ("[effects.noise]\nseed = 1", "effects.noise.deviation", "[effects.noise]", &["missing key", "in m", "deviation = 1e-6"]),
    ("[effects.noise]\ndeviation = 1e-6\nseed = -1", "effects.noise.seed", "seed", &["whole number of 0 or more", "not -1"]),
    ("[effects.noise]\ndeviation = 1e-6\nseed = 1.5", "effects.noise.seed", "seed", &["must be a whole number", "1.5"]),
    ("[effects.noise]\ndeviation = 1e-6\nseed = \"a\"", "effects.noise.seed", "seed", &["must be a whole number", "\"a\""]),
    ("[effects.noise]\ndeviation = 1e-6\nseed = 1\nsigma = 2", "effects.noise.sigma", "sigma", &["unknown key `sigma`", "deviation, seed"]),
    ("[effects.jitter]\ndeviation = -1e-4\nseed = 1", "effects.jitter.deviation", "deviation", &["0 or greater", "unit is s"]),
    ("[effects.jitter]\ndeviation = inf\nseed = 1", "effects.jitter.deviation", "deviation", &["finite", "inf"]),
    ("[effects.jitter]\ndeviation = 1e-4\nseed = -7", "effects.jitter.seed", "seed", &["0 or more", "-7"]),
    ("[effects.jitter]\nseed = 1", "effects.jitter.deviation", "[effects.jitter]", &["missing key", "in s"]),
    ("[effects.dropout]\nprobability = 1.5\nseed = 1\npolicy = \"hold\"", "effects.dropout.probability", "probability", &["from 0 to 1", "not 1.5"]),
    ("[effects.dropout]\nprobability = -0.1\nseed = 1\npolicy = \"hold\"", "effects.dropout.probability", "probability", &["from 0 to 1", "-0.1"]),
    ("[effects.dropout]\nprobability = nan\nseed = 1\npolicy = \"hold\"", "effects.dropout.probability", "probability", &["from 0 to 1", "NaN"]),
    ("[effects.dropout]\nprobability = 0.1\nseed = 0.5\npolicy = \"hold\"", "effects.dropout.seed", "seed", &["must be a whole number", "0.5"]),
    ("[effects.dropout]\nprobability = 0.1\nseed = 1\npolicy = \"holt\"", "effects.dropout.policy", "policy", &["did you mean \"hold\"", "\"zero\""]),
    ("[effects.dropout]\nprobability = 0.1\nseed = 1\npolicy = 0", "effects.dropout.policy", "policy", &["the number 0", "\"hold\", \"zero\""]),
    ("[effects.dropout]\nprobability = 0.1\nseed = 1", "effects.dropout.policy", "[effects.dropout]", &["missing key", "policy = \"hold\""]),
    ("[effects.friction]\nstatic = 0.3", "effects.friction.coulomb", "[effects.friction]", &["missing key", "in N"]),
    ("[effects.friction]\ncoulomb = -0.1", "effects.friction.coulomb", "coulomb", &["0 or greater", "-0.1"]),
    ("[effects.friction]\ncoulomb = 0.2\nstatic = 0.1\nstribeck_velocity = 0.1", "effects.friction.static", "static", &["0.1 N is less than `coulomb` = 0.2 N", "at least"]),
    ("[effects.friction]\ncoulomb = 0.2\nstatic = 0.3", "effects.friction", "[effects.friction]", &["lacks `stribeck_velocity`", "m/s"]),
    ("[effects.friction]\ncoulomb = 0.2\nstatic = 0.3\nstribeck_velocity = 0", "effects.friction.stribeck_velocity", "stribeck", &["greater than 0", "not 0.0", "m/s"]),
    ("[effects.friction]\ncoulomb = 0.2\nstatic = inf\nstribeck_velocity = 1", "effects.friction.static", "static", &["finite", "inf"]),
    ("[effects.friction]\ncoulomb = 0.2\nviscous = 1", "effects.friction.viscous", "viscous", &["unknown key `viscous`", "coulomb, static, stribeck_velocity"]),
    ("[effects.load]\nforce = nan", "effects.load.force", "force", &["must be finite", "NaN", "unit is N"]),
    ("[effects.load]", "effects.load.force", "[effects.load]", &["missing key", "in N"]),
    ("[effects.load]\nforce = [1.0]", "effects.load.force", "force", &["must be a number, not a list"]),
    ("[effects.pulse]\nstart = -1\nduration = 1\nforce = 1", "effects.pulse.start", "start", &["0 or greater", "-1.0", "unit is s"]),
    ("[effects.pulse]\nstart = 1\nduration = -0.5\nforce = 1", "effects.pulse.duration", "duration", &["0 or greater", "-0.5"]),
    ("[effects.pulse]\nstart = 1\nduration = 1\nforce = inf", "effects.pulse.force", "force", &["must be finite", "inf"]),
    ("[effects.pulse]\nstart = 1\nforce = 1", "effects.pulse.duration", "[effects.pulse]", &["missing key", "in s"]),
    ("[link]\nstiffness = 100", "operator.mass", "[link]", &["`operator.mass` must be greater than 0", "operator.mass = 0.1"]),
    ("[link]\nstiffness = 100\n[operator]\ndamping = 1", "operator.mass", "[operator]", &["must be greater than 0"]),
    ("[link]\nstiffness = 100\n[operator]\nmass = 0", "operator.mass", "mass = 0", &["`operator.mass` must be greater than 0", "not 0.0"]),
    ("[operator]\nmass = 0.1\n[link]\nstiffness = 0", "link.stiffness", "stiffness", &["greater than 0", "not 0.0", "N/m"]),
    ("[operator]\nmass = 0.1\n[link]\nstiffness = 100\ndamping = -1", "link.damping", "damping", &["0 or greater", "-1.0"]),
    ("[operator]\nmass = 0.1\n[link]\ndamping = 1", "link.stiffness", "[link]", &["missing key `link.stiffness`", "in N/m"]),
    ("[operator]\nmass = 0.1\n[link]\nstiffness = 1e300", "link.stiffness", "stiffness = 1e300", &["= 1e300 between 0.1 and", "within one period", "give at most 1.288e30 N/m", "leave out `link`"]),
    ("[operator]\nmass = 1e-60\n[link]\nstiffness = 100", "link.stiffness", "stiffness = 100", &["between 1e-60 and", "within one period", "leave out `link`"]),
    ("[operator.grip]\ntimes = [1, 2]\nstiffness = [5]\ndamping = [1, 1]", "operator.grip.stiffness", "stiffness", &["has 1 numbers", "`times` has 2", "one stiffness and one damping"]),
    ("[operator.grip]\ntimes = [1]\nstiffness = [5]\ndamping = []", "operator.grip.damping", "damping", &["has 0 numbers", "`times` has 1"]),
    ("[operator.grip]\ntimes = [2, 1]\nstiffness = [5, 5]\ndamping = [1, 1]", "operator.grip.times", "times", &["1.0 s after 2.0 s", "later"]),
    ("[operator.grip]\ntimes = [-1]\nstiffness = [5]\ndamping = [1]", "operator.grip.times[0]", "times", &["0 or greater", "-1.0", "unit is s"]),
    ("[operator.grip]\ntimes = [1]\nstiffness = [nan]\ndamping = [1]", "operator.grip.stiffness[0]", "stiffness", &["finite", "NaN", "unit is N/m"]),
    ("[operator.grip]\ntimes = [1]\nstiffness = [5]\ndamping = [-1]", "operator.grip.damping[0]", "damping", &["0 or greater", "-1.0", "N.s/m"]),
    ("[operator.grip]\ntimes = 1\nstiffness = [5]\ndamping = [1]", "operator.grip.times", "times", &["must be a list", "the number 1"]),
    ("[operator.grip]\nstiffness = [5]\ndamping = [1]", "operator.grip.times", "[operator.grip]", &["missing key", "in s"]),
    ("[operator.motion]\nkind = \"step\"", "operator.motion.to", "[operator.motion]", &["missing key `operator.motion.to`", "in m"]),
    ("[operator.motion]\nkind = \"stp\"\nto = 1", "operator.motion.kind", "kind", &["did you mean \"step\"", "\"ramp\", \"sine\", \"file\""]),
    ("[operator.motion]\nto = 1", "operator.motion.kind", "[operator.motion]", &["missing key `operator.motion.kind`"]),
    ("[operator.motion]\nkind = \"step\"\nto = 1\nrate = 2", "operator.motion", "[operator.motion]", &["has `rate`", "kind, at, to"]),
    ("[operator.motion]\nkind = \"step\"\nto = 1\nat = -1", "operator.motion.at", "at", &["0 or greater", "-1.0", "unit is s"]),
    ("[operator.motion]\nkind = \"ramp\"\nto = 1\nrate = -1", "operator.motion.rate", "rate", &["0 or greater", "-1.0", "m/s"]),
    ("[operator.motion]\nkind = \"ramp\"\nto = nan\nrate = 1", "operator.motion.to", "to", &["must be finite", "NaN"]),
    ("[operator.motion]\nkind = \"sine\"\namplitude = 1", "operator.motion.frequency", "[operator.motion]", &["missing key", "in Hz"]),
    ("[operator.motion]\nkind = \"sine\"\namplitude = inf\nfrequency = 1", "operator.motion.amplitude", "amplitude", &["must be finite"]),
    ("[operator.motion]\nkind = \"sine\"\namplitude = 1\nfrequency = -1", "operator.motion.frequency", "frequency", &["0 or greater", "Hz"]),
    ("[operator.motion]\nkind = \"sine\"\namplitude = 1\nfrequency = 1\nspeed = 1", "operator.motion.speed", "speed", &["unknown key `speed`"]),
    ("[operator.motion]\nkind = \"file\"", "operator.motion.path", "[operator.motion]", &["missing key", "path = \"motion.csv\""]),
    ("[operator.motion]\nkind = \"file\"\npath = 3", "operator.motion.path", "path", &["the number 3"]),
    ("[operator.motion]\nkind = \"file\"\npath = \"no-such.csv\"", "operator.motion.path", "path", &["no-such.csv", "cannot be read", "t,rest"]),
    ("[space]\ndimensions = 1", "space.dimensions", "dimensions", &["must be 2 or 3", "not 1"]),
    ("[space]\ndimensions = 2.0", "space.dimensions", "dimensions", &["must be a whole number", "2.0"]),
    ("[space]", "space.dimensions", "[space]", &["missing key `space.dimensions`"]),
    ("[space]\ndimensions = 2", "environment.wall", "[environment.wall]", &["not for 2 dimensions", "plane, sphere or box"]),
    ("[initial]\nposition = [0, 0]", "initial.position", "position", &["a list of 2 numbers", "1 dimension", "dimensions = 2"]),
    ("[initial]\nposition = []", "initial.position", "position", &["list"]),
];

#[rustfmt::skip]
const TOUCHING: &[Case] = &[
    ("[environment.spring]\nposition = 1", "environment.spring.stiffness", "[environment.spring]", &["missing key", "in N/m"]),
    ("[environment.spring]\nstiffness = inf", "environment.spring.stiffness", "stiffness", &["must be finite"]),
    ("[environment.spring]\nstiffness = 1\ndamping = 1", "environment.spring.damping", "damping", &["unknown key `damping`", "position, stiffness"]),
    ("[environment.mass-spring-damper]\nmass = -1", "environment.mass-spring-damper.mass", "mass", &["0 or greater", "-1.0", "kg"]),
    ("[environment.mass-spring-damper]\nstiffness = -1", "environment.mass-spring-damper.stiffness", "stiffness", &["0 or greater"]),
    ("[environment.mass-spring-damper]\ndamping = nan", "environment.mass-spring-damper.damping", "damping", &["must be finite", "NaN"]),
    ("[environment.layered-wall]\ndepth = -1\nstiffness = [1, 2]", "environment.layered-wall.depth", "depth", &["0 or greater", "unit is m"]),
    ("[environment.layered-wall]\ndepth = 1\nstiffness = [1]", "environment.layered-wall.stiffness", "stiffness", &["a list of two numbers, not of 1"]),
    ("[environment.layered-wall]\ndepth = 1\nstiffness = [1, 2, 3]", "environment.layered-wall.stiffness", "stiffness", &["a list of two numbers, not of 3"]),
    ("[environment.layered-wall]\ndepth = 1\nstiffness = 1", "environment.layered-wall.stiffness", "stiffness", &["must be a list", "the number 1"]),
    ("[environment.layered-wall]\ndepth = 1\nstiffness = [1, -2]", "environment.layered-wall.stiffness[1]", "stiffness", &["0 or greater", "-2.0"]),
    ("[environment.layered-wall]\nstiffness = [1, 2]", "environment.layered-wall.depth", "[environment.layered-wall]", &["missing key", "in m"]),
    ("[environment.hunt-crossley]\nstiffness = 1\nexponent = 0", "environment.hunt-crossley.exponent", "exponent", &["greater than 0", "not 0.0"]),
    ("[environment.hunt-crossley]\nstiffness = 1", "environment.hunt-crossley.exponent", "[environment.hunt-crossley]", &["missing key", "exponent = 1.5"]),
    ("[environment.hunt-crossley]\nstiffness = 1\nexponent = 1\ndamping = -1", "environment.hunt-crossley.damping", "damping", &["0 or greater", "s/m"]),
    ("[environment.moving-wall]\nstiffness = 1\namplitude = 1", "environment.moving-wall.frequency", "[environment.moving-wall]", &["missing key", "in Hz"]),
    ("[environment.moving-wall]\nstiffness = 1\namplitude = nan\nfrequency = 1", "environment.moving-wall.amplitude", "amplitude", &["must be finite"]),
    ("[environment.moving-wall]\nstiffness = 1\namplitude = 1\nfrequency = -1", "environment.moving-wall.frequency", "frequency", &["0 or greater", "Hz"]),
    ("[environment.moving-wall]\nstiffness = 1\namplitude = 1\nfrequency = 1e308", "environment.moving-wall.frequency", "frequency", &["1e308", "range of f64"]),
    ("[environment.varying-spring]\nstiffness = 1\nfrequency = 1", "environment.varying-spring.amplitude", "[environment.varying-spring]", &["missing key", "in N/m"]),
    ("[environment.cubic-spring]\nstiffness = 1", "environment.cubic-spring.cubic", "[environment.cubic-spring]", &["missing key", "in N/m^3"]),
    ("[environment.cubic-spring]\nstiffness = 1\ncubic = -1", "environment.cubic-spring.cubic", "cubic", &["0 or greater", "N/m^3"]),
    ("[environment.wall]\nstiffness = 1\n[environment.spring]\nstiffness = 1", "environment", "[environment.spring]", &["two environments", "`spring`", "`wall`", "keep one of these tables"]),
    ("[environment.plane]\npoint = [0, 0]\nnormal = [0, 1]\nstiffness = 1", "environment.plane", "[environment.plane]", &["not for 1 dimension", "[space]"]),
    ("[environment.sphere]\ncenter = 0\nradius = 1\nstiffness = 1", "environment.sphere", "[environment.sphere]", &["not for 1 dimension", "[space]"]),
];

#[rustfmt::skip]
const IN_A_PLANE: &[Case] = &[
    ("[environment.plane]\npoint = [0, 0, 0]\nnormal = [0, 1]\nstiffness = 1", "environment.plane.point", "point", &["a list of 3 numbers", "2 dimensions", "[0.0, 0.0]"]),
    ("[environment.plane]\npoint = [0, 0]\nnormal = [0, 1, 0]\nstiffness = 1", "environment.plane.normal", "normal", &["a list of 3 numbers", "for example [0.0, 1.0]"]),
    ("[environment.plane]\npoint = [0, 0]\nnormal = [0, 0]\nstiffness = 1", "environment.plane.normal", "normal", &["0 along every axis", "direction"]),
    ("[environment.plane]\npoint = [0, 0]\nnormal = [0, nan]\nstiffness = 1", "environment.plane.normal[1]", "normal", &["must be finite", "NaN"]),
    ("[environment.plane]\npoint = [0, 0]\nstiffness = 1", "environment.plane.normal", "[environment.plane]", &["missing key"]),
    ("[environment.plane]\npoint = \"here\"\nnormal = [0, 1]\nstiffness = 1", "environment.plane.point", "point", &["list of numbers", "\"here\""]),
    ("[environment.sphere]\ncenter = [0, 0]\nradius = 0\nstiffness = 1", "environment.sphere.radius", "radius", &["greater than 0", "not 0.0", "unit is m"]),
    ("[environment.sphere]\ncenter = 0.5\nradius = 1\nstiffness = 1", "environment.sphere.center", "center", &["one number", "2 dimensions"]),
    ("[environment.box]\ncenter = [0, 0]\nhalf = [1, 0]\nstiffness = 1", "environment.box.half[1]", "half", &["greater than 0"]),
    ("[environment.box]\ncenter = [0, 0]\nhalf = [1]\nstiffness = 1", "environment.box.half", "half", &["2 dimensions"]),
    ("[environment.box]\ncenter = [0, 0]\nhalf = [1, 1, 1]\nstiffness = 1", "environment.box.half", "half", &["2 dimensions", "for example [0.02, 0.01]"]),
    ("[environment.box]\ncenter = [0, 0]\nhalf = []\nstiffness = 1", "environment.box.half", "half", &["2 dimensions"]),
    ("[environment.box]\ncenter = [0, 0]\nhalf = [1, 1]\nstiffness = -1", "environment.box.stiffness", "stiffness", &["0 or greater", "-1.0"]),
];

#[rustfmt::skip]
const BESIDE_A_PLANE: &[Case] = &[
    ("[operator]\nmass = 0.1\n[link]\nstiffness = 9\n[effects.friction]\ncoulomb = 0.1", "effects.friction", "[effects.friction]", &["2 dimensions", "one mass", "`link`", "leave out the friction"]),
    ("[initial]\nvelocity = 0.1", "initial.velocity", "velocity", &["one number", "2 dimensions", "a list of 2 numbers"]),
    ("[stabilizer.directed-damping]\ndirection = [1, 0, 0]", "stabilizer.directed-damping.direction", "direction", &["a list of 3 numbers", "for example [1.0, 1.0]"]),
    ("[operator]\nrest = [0, 0, 0]", "operator.rest", "rest", &["a list of 3 numbers"]),
];

#[track_caller]
fn reported(before: &str, (table, key, line, words): &Case) {
    let text = format!("{before}{table}\n");
    let fault = fault(&text);
    let shown = fault.to_string();
    assert_eq!(fault.key(), Some(*key), "{shown}");
    let start = before.lines().count();
    let marked = text.lines().enumerate().skip(start.min(fault.line().unwrap_or(1) - 1));
    let found = marked.filter(|(_, text)| text.starts_with(line)).map(|(n, _)| n + 1).last();
    assert_eq!(fault.line(), found, "{shown}");
    let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
    for word in *words {
        assert!(unfolded.contains(word), "no {word:?} in:\n{shown}");
    }
    for jargon in
        ["invalid", "expected f64", "variant", "struct", "Problem", "sequence", "tuple", "u64"]
    {
        assert!(!shown.contains(jargon), "{jargon:?} in:\n{shown}");
    }
}

/// Asserts all cases, so that a failure lists every bad message, not only the first.
fn all_reported(before: &str, cases: &[Case]) {
    let badly =
        cases.iter().filter(|case| std::panic::catch_unwind(|| reported(before, case)).is_err());
    let badly: Vec<&str> = badly.map(|case| case.0).collect();
    assert!(badly.is_empty(), "{badly:#?}");
}

#[test]
fn each_broken_rule_of_an_effect_names_key_line_value_and_remedy() {
    all_reported(&format!("{HEAD}{REST}{WALL}"), ON_A_LINE);
    all_reported(&format!("{HEAD}{REST}"), TOUCHING);
    all_reported(&format!("{HEAD}space.dimensions = 2\n{REST}"), IN_A_PLANE);
    all_reported(&format!("{HEAD}space.dimensions = 2\n{REST}{PLANE}"), BESIDE_A_PLANE);
}

#[test]
fn a_filter_needs_the_backward_difference() {
    let exact = format!("{HEAD}velocity = \"exact\"\n{REST}{WALL}");
    reported(
        &exact,
        &(
            "[effects.filter]\nwindow = 4",
            "effects.filter",
            "[effects.filter]",
            &["\"exact\"", "leave the filter out"],
        ),
    );
}

#[test]
fn single_precision_must_hold_every_number_of_an_effect() {
    let single = format!("{HEAD}scalar = \"f32\"\n{REST}{WALL}");
    for case in [
        (
            "[effects.load]\nforce = 1e39",
            "effects.load.force",
            "force",
            &["1e39", "range of f32"] as &[&str],
        ),
        (
            "[effects.noise]\nseed = 1\ndeviation = 1e-50",
            "effects.noise.deviation",
            "deviation",
            &["range of f32"],
        ),
        (
            "[operator.grip]\ntimes = [1]\ndamping = [1]\nstiffness = [1e39]",
            "operator.grip.stiffness",
            "stiffness",
            &["range of f32"],
        ),
    ] {
        reported(&single, &case);
    }
}

#[test]
fn a_fault_of_a_recorded_motion_is_reported_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.toml");
    let table = "[operator.motion]\nkind = \"file\"\npath = \"hand.csv\"\n";
    for scalar in ["f64", "f32"] {
        std::fs::write(&scene, format!("{HEAD}scalar = \"{scalar}\"\n{REST}{WALL}{table}"))
            .unwrap();
        #[rustfmt::skip]
        let cases: &[(&str, &[&str])] = &[
            ("", &["has no rows"]),
            ("t,rest\n", &["has no rows"]),
            ("t,x\n0,1\n", &["line 1", "`t,x`, not `t,rest`"]),
            ("0,1\n1,1\n", &["line 1", "not `t,rest`"]),
            ("t,rest\n0,1\n1\n", &["line 3", "`1` is not two numbers"]),
            ("t,rest\n0,1,2\n", &["line 2", "not two numbers"]),
            ("t,rest\n0,nan\n", &["line 2", "not two numbers"]),
            ("t,rest\ninf,1\n", &["line 2", "not two numbers"]),
            ("t,rest\n0,one\n", &["line 2", "not two numbers"]),
            ("t,rest\n0,1\n1,1\n0.5,1\n", &["line 4", "t = 0.5 does not come after"]),
        ];
        for (file, words) in cases {
            std::fs::write(folder.path().join("hand.csv"), file).unwrap();
            let fault = Scene::load(&scene).expect_err(file);
            let shown = fault.to_string();
            assert_eq!(fault.key(), Some("operator.motion.path"), "{shown}");
            let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
            for word in *words {
                assert!(unfolded.contains(word), "no {word:?} in:\n{shown}");
            }
        }
        std::fs::write(folder.path().join("hand.csv"), "t,rest\n0,1e39\n").unwrap();
        assert_eq!(Scene::load(&scene).is_ok(), scalar == "f64");
    }
}
