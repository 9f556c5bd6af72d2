//! The schema of scene files: made from the types, in agreement with the reader, and where editors look for it.

use std::fs;

use jsonschema::Validator;
use lyapunov_lab::Scene;
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::scene::{Member, schema_text};
use lyapunov_lab::scenes::{SCENES, text_of};
use serde_json::Value;

use crate::shipped::rows::folder;

fn validator() -> Validator {
    jsonschema::validator_for(&serde_json::from_str(&schema_text()).unwrap()).unwrap()
}

/// A TOML file as the JSON value that the validator checks.
fn json(text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Value>(text).unwrap()).unwrap()
}

/// A shipped scene with one part replaced.
fn with(name: &str, from: &str, to: &str) -> String {
    let text = text_of(name).unwrap();
    assert!(text.contains(from), "{name}: {from}");
    text.replacen(from, to, 1)
}

#[test]
fn the_schema_file_is_made_from_the_types() {
    let file = fs::read_to_string(folder().join("scene.schema.json")).unwrap();
    assert_eq!(file, schema_text(), "lyapunov schema > scenes/scene.schema.json");
}

#[test]
fn every_shipped_scene_is_valid() {
    let validator = validator();
    for scene in SCENES {
        let faults: Vec<String> =
            validator.iter_errors(&json(scene.text)).map(|fault| fault.to_string()).collect();
        assert!(faults.is_empty(), "{}: {faults:?}", scene.name);
    }
}

/// A shipped scene, a part of it, and a valid replacement.
#[rustfmt::skip]
const ALLOWED: &[(&str, &str, &str)] = &[
    ("paper-8k-lolc", "damping_cap = 0.5", "damping_cap = inf"),
    ("paper-8k-lolc", "damping_cap = 0.5", "damping_cap = 0"),
    ("paper-8k-lolc", "\"held\"", "\"sampled\""),
    ("hold", "[stabilizer.popc]", "[stabilizer.popc]\ndamping_cap = inf"),
    ("hold", "[stabilizer.popc]", "[stabilizer.lolc]"),
    ("hold", "[stabilizer.popc]", "[stabilizer.iss]\nslope = inf"),
    ("hold", "[stabilizer.popc]", "[stabilizer.directed-damping]\ndirection = [1.0]"),
    ("hold", "rest = 0.01", "rest = [0.01]"),
    ("hold", "duration = 2.0", "duration = 2"),
    ("hold", "duration = 2.0", "duration = 2.0\nvelocity = \"exact\"\nscalar = \"f32\"\nintegrator = \"exact\""),
    ("hold", "duration = 2.0", "duration = 2.0\nintegrator = \"rk4\"\nsteps_per_tick = 4"),
    ("hold", "duration = 2.0", "duration = 2.0\nintegrator = \"dop853\"\ntolerance = 1e-12"),
    ("delay", "ticks = 2", "ticks = 1024"),
    ("dropout", "\"hold\"", "\"zero\""),
    ("dropout", "probability = 0.3", "probability = 1"),
    ("noise", "seed = 1", "seed = 9223372036854775807"),
    ("friction", "static = 1.0\nstribeck_velocity = 0.005", ""),
    ("friction", "coulomb = 0.5", "coulomb = 0"),
    ("load", "force = 2.0", "force = -2.0"),
    ("spring", "stiffness = -150.0", "stiffness = 150"),
    ("mass-spring-damper", "damping = 0.5", "damping = -0.5"),
    ("motion-ramp", "at = 0.5\n", ""),
    ("box", "half = [0.02, 0.03]", "half = [1, 2]"),
];

#[test]
fn allowed_values_are_valid() {
    let validator = validator();
    for (name, from, to) in ALLOWED {
        let text = with(name, from, to);
        Scene::parse(&text, name).unwrap_or_else(|fault| panic!("{fault}"));
        let faults: Vec<String> =
            validator.iter_errors(&json(&text)).map(|fault| fault.to_string()).collect();
        assert!(faults.is_empty(), "{text}\n{faults:?}");
    }
}

/// A shipped scene, a part of it, and an invalid replacement.
#[rustfmt::skip]
const REFUSED: &[(&str, &str, &str)] = &[
    ("hold", "duration = 2.0", ""),
    ("hold", "duration = 2.0", "duration = 0.0"),
    ("hold", "duration = 2.0", "duration = \"2 s\""),
    ("hold", "duration = 2.0", "duration = 2.0\nlength = 1"),
    ("hold", "servo_rate = 1000.0", "servo_rate = -1000.0"),
    ("hold", "servo_rate = 1000.0", "servorate = 1000.0"),
    ("hold", "duration = 2.0", "duration = 2.0\nvelocity = \"forward\""),
    ("hold", "duration = 2.0", "duration = 2.0\nscalar = \"f16\""),
    ("hold", "duration = 2.0", "duration = 2.0\nintegrator = \"euler\""),
    ("hold", "duration = 2.0", "duration = 2.0\nintegrator = \"rk4\"\nsteps_per_tick = 0"),
    ("hold", "duration = 2.0", "duration = 2.0\nintegrator = \"dopri5\"\ntolerance = 0"),
    ("hold", "[device]\nmass = 0.2", "[device]"),
    ("hold", "mass = 0.2", "mass = 0"),
    ("hold", "mass = 0.1", "mass = -0.1"),
    ("hold", "rest = 0.01", "rest = \"here\""),
    ("hold", "rest = 0.01", "rest = [0, 0, 0, 0]"),
    ("hold", "rest = 0.01", "rest = 0.01\nstifness = 1"),
    ("hold", "[environment.wall]", "[environment.wal]"),
    ("hold", "[environment.wall]", "[environment.spring]\nstiffness = 1\n[environment.wall]"),
    ("hold", "stiffness = 2000.0", ""),
    ("hold", "stiffness = 2000.0", "stiffness = -1"),
    ("hold", "[stabilizer.popc]", "[stabilizer.popc]\ncandidate = \"spring\""),
    ("hold", "[stabilizer.popc]", "[stabilizer.popc]\n[stabilizer.lolc]"),
    ("hold", "[stabilizer.popc]", "[stabilizer.popc]\ndamping_cap = -1"),
    ("hold", "[stabilizer.popc]", "[stabilizer.popc]\ndamping_cap = \"inf\""),
    ("hold", "[stabilizer.popc]", "[stabilizer.tank]\nstart = -1e-3"),
    ("hold", "[stabilizer.popc]", "[stabilizer.tank]\nlevel = 1e-3"),
    ("hold", "[stabilizer.popc]", "[stabilizer.iss]\nslope = 0"),
    ("hold", "[stabilizer.popc]", "[stabilizer.popc-spread]\nticks = 1.5"),
    ("hold", "[stabilizer.popc]", "[stabilizer.least-norm]\ndecay = 2.0"),
    ("hold", "[stabilizer.popc]", "[stabilizer.lolc-spring]"),
    ("paper-8k-lolc", "\"held\"", "\"hold\""),
    ("paper-8k-lolc", "\"mass-spring-damper\"", "\"mass_spring_damper\""),
    ("delay", "ticks = 2", "ticks = 1025"),
    ("delay", "ticks = 2", "ticks = -1"),
    ("delay", "ticks = 2", "ticks = 1.5"),
    ("delay", "ticks = 2", ""),
    ("saturation", "force = 4.0", "force = 0"),
    ("encoder", "resolution = 1e-4", "resolution = 0.0"),
    ("filter-cutoff", "cutoff = 50.0", "cutoff = 0"),
    ("filter-cutoff", "cutoff = 50.0", "cutoff = 50.0\nwindow = 16"),
    ("filter-cutoff", "cutoff = 50.0", ""),
    ("filter-window", "window = 16", "window = 257"),
    ("filter-window", "window = 16", "window = 0"),
    ("noise", "deviation = 1e-6", "deviation = -1e-6"),
    ("noise", "seed = 1", ""),
    ("noise", "seed = 1", "seed = -1"),
    ("jitter", "seed = 1", "seed = 1.5"),
    ("jitter", "deviation = 5e-5", "deviation = true"),
    ("dropout", "probability = 0.3", "probability = 1.1"),
    ("dropout", "\"hold\"", "\"last\""),
    ("dropout", "policy = \"hold\"", ""),
    ("friction", "coulomb = 0.5", ""),
    ("friction", "static = 1.0", "breakaway = 1.0"),
    ("friction", "stribeck_velocity = 0.005", "stribeck_velocity = 0"),
    ("load", "force = 2.0", "force = [2.0]"),
    ("load", "[effects.load]", "[effects.weight]"),
    ("pulse", "duration = 0.02", "duration = -0.02"),
    ("pulse", "start = 1.0\n", ""),
    ("link", "stiffness = 5000.0", "stiffness = 0"),
    ("motion-step", "\"step\"", "\"jump\""),
    ("motion-step", "kind = \"step\"\n", ""),
    ("motion-step", "to = 0.01", "to = 0.01\nrate = 1.0"),
    ("motion-ramp", "rate = 0.01", ""),
    ("motion-sine", "frequency = 2.0", "frequency = -2.0"),
    ("motion-file", "path = \"motion-file.csv\"", "path = 3"),
    ("grip", "times = [1.0, 2.0]", "times = 1.0"),
    ("grip", "damping = [20.0, 1.0]", "damping = [20.0, -1.0]"),
    ("layered-wall", "[500.0, 20000.0]", "[500.0]"),
    ("layered-wall", "[500.0, 20000.0]", "500.0"),
    ("layered-wall", "depth = 0.003", "depth = -0.003"),
    ("hunt-crossley", "exponent = 1.5", "exponent = 0"),
    ("moving-wall", "frequency = 4.0", ""),
    ("varying-spring", "amplitude = 100.0", "amplitude = \"100\""),
    ("cubic-spring", "cubic = 1e6", "cubic = -1e6"),
    ("mass-spring-damper", "stiffness = 200.0", "stiffness = -200.0"),
    ("plane", "dimensions = 2", "dimensions = 1"),
    ("plane", "dimensions = 2", "dimensions = 4"),
    ("plane", "normal = [0.5, 1.0]", "normal = 1.0"),
    ("sphere", "radius = 0.02", "radius = 0"),
    ("sphere", "center", "centre"),
    ("box", "half = [0.02, 0.03]", "half = [0.02, 0.0]"),
    ("box", "half = [0.02, 0.03]", "half = [0.02]"),
];

#[test]
fn forbidden_values_are_not_valid() {
    let validator = validator();
    for (name, from, to) in REFUSED {
        let text = with(name, from, to);
        assert!(!validator.is_valid(&json(&text)), "valid:\n{text}");
        assert!(Scene::parse(&text, name).is_err(), "read:\n{text}");
    }
}

/// Every table of a stabilizer, empty and with each number written out.
#[test]
fn tables_of_stabilizers_are_valid() {
    let validator = validator();
    let bare = Scene::parse(text_of("hold").unwrap(), "hold").unwrap();
    for member in Member::ALL {
        let name = StabilizerName::Member(*member);
        let empty = with("hold", "[stabilizer.popc]", &format!("[stabilizer.{name}]"));
        let scene = Scene::parse(&empty, name.name()).unwrap_or_else(|fault| panic!("{fault}"));
        let parameters = name.parameters(&scene);
        let numbers = parameters.iter().filter_map(|it| Some((it.name(), it.default?)));
        let written = name.written_in(&bare, &numbers.collect::<Vec<_>>()).unwrap();
        for text in [&empty, &toml::to_string(&written).unwrap()] {
            let faults: Vec<String> =
                validator.iter_errors(&json(text)).map(|fault| fault.to_string()).collect();
            assert!(faults.is_empty(), "{text}\n{faults:?}");
        }
        for wrong in ["stiffnes = 1.0", &format!("{} = \"much\"", parameters[0].name())] {
            let text = with("hold", "[stabilizer.popc]", &format!("[stabilizer.{name}]\n{wrong}"));
            assert!(!validator.is_valid(&json(&text)), "valid:\n{text}");
            assert!(Scene::parse(&text, name.name()).is_err(), "read:\n{text}");
        }
    }
}

/// Visits the parts of a schema that stand for a value or a table of the file.
fn walk(schema: &Value, path: &str, visit: &mut impl FnMut(&str, &Value)) {
    visit(path, schema);
    for key in ["oneOf", "anyOf", "allOf"] {
        for part in schema.get(key).and_then(Value::as_array).into_iter().flatten() {
            walk(part, path, visit);
        }
    }
    for key in ["properties", "definitions"] {
        for (name, part) in schema.get(key).and_then(Value::as_object).into_iter().flatten() {
            walk(part, &format!("{path}.{name}"), visit);
        }
    }
}

#[test]
fn every_key_says_what_it_is_and_no_table_takes_others() {
    let schema: Value = serde_json::from_str(&schema_text()).unwrap();
    walk(&schema, "", &mut |path, part| {
        for (name, key) in part.get("properties").and_then(Value::as_object).into_iter().flatten() {
            let told = key.get("description").or(key.get("$ref")).or(key.get("const"));
            assert!(told.is_some(), "{path}.{name}: {key}");
            assert_eq!(part["additionalProperties"], false, "{path}");
        }
        if let Some(Value::String(text)) = part.get("description") {
            assert!(!text.contains("::") && !text.contains("[`"), "{path}: {text}");
        }
    });
}
