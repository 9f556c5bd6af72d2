//! The guarantees of scene files to their users.

mod bad;
mod bad_effects;
mod broken;
mod edits;
mod files;
mod good;
mod keys;
mod shown;

pub(crate) use keys::{assert_keys_of, merge};

use crate::files::scene::keys::SMALLEST;
use crate::files::scene::{Diagnostic, Scene};

/// The example of the specification, with every key.
const FULL: &str = r#"
duration = 10.0              # s
servo_rate = 100.0           # Hz
environment_rate = 100.0     # Hz; default: servo_rate
velocity = "backward-difference"   # default; or "exact"
scalar = "f64"               # default; or "f32"
integrator = "exact"         # default

[operator]                   # keys default to 0
mass = 0.1
damping = 0.2
stiffness = 50.0
rest = 0.0
[device]                     # damping defaults to 0
mass = 0.2
damping = 0.001
[initial]                    # keys default to 0
position = -0.004
velocity = 0.0
[environment.wall]           # one-sided
position = 0.0
stiffness = 8000.0
damping = 2.0
[stabilizer.lolc]            # or [stabilizer.popc]
work = "held"                # default; or "sampled"
candidate = "mass-spring-damper"   # default; or "device-damping", "spring"
damping_cap = 0.5            # default; of m / T
[effects.encoder]
resolution = 1e-5            # m
[effects.delay]
ticks = 2                    # 0 is allowed
[effects.saturation]
force = 8.0                  # N, symmetric
"#;

/// The full example with one part of it replaced.
fn with(part: &str, replacement: &str) -> String {
    assert!(FULL.contains(part), "the example has no {part:?}");
    FULL.replacen(part, replacement, 1)
}

/// The smallest scene with more below it.
fn smallest_and(more: &str) -> String {
    format!("{SMALLEST}\n{more}\n")
}

fn scene(text: &str) -> Scene {
    Scene::parse(text, "test.toml").unwrap_or_else(|fault| panic!("{fault}"))
}

fn fault(text: &str) -> Diagnostic {
    match Scene::parse(text, "test.toml") {
        Ok(_) => panic!("accepted:\n{text}"),
        Err(fault) => fault,
    }
}

/// The number of the last line that `with` puts into the example.
fn line_of(part: &str, replacement: &str) -> usize {
    let start = FULL.find(part).unwrap();
    FULL[..start].matches('\n').count() + replacement.lines().count()
}
