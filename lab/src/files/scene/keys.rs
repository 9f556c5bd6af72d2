//! The keys of scene files for messages: the unit and a correct example line of each.

use toml::de::DeTable;

use super::book::{Book, Key, count, joined, key};
use super::{environments, stabilizers};

/// The keys of scene files.
pub(crate) const BOOK: Book =
    Book { noun: "scene", keys: KEYS, own: stabilizers::own::keys, smallest: SMALLEST };

/// The smallest valid file: the required keys only.
pub(super) const SMALLEST: &str = "duration = 1.0  # s
servo_rate = 1000.0  # Hz
[device]
mass = 0.2  # kg
[environment.wall]
stiffness = 8000.0  # N/m";

/// Every key and table; a test compares them with the types.
pub(super) const KEYS: &[Key] = &joined::<{ count(TABLES) }>(TABLES);

const TABLES: &[&[Key]] = &[LOOP, environments::KEYS, STABILIZED, stabilizers::KEYS, EFFECTS];

/// The keys before the environments.
const LOOP: &[Key] = &[
    key("duration", "s", "duration = 10.0  # s"),
    key("servo_rate", "Hz", "servo_rate = 1000.0  # Hz"),
    key("environment_rate", "Hz", "environment_rate = 100.0  # Hz"),
    key("velocity", "", "velocity = \"backward-difference\""),
    key("scalar", "", "scalar = \"f64\""),
    key("integrator", "", "integrator = \"exact\""),
    key("steps_per_tick", "", "steps_per_tick = 4"),
    key("tolerance", "m and m/s", "tolerance = 1e-9  # m and m/s"),
    key("operator", "", "[operator]\nmass = 0.1  # kg"),
    key("operator.mass", "kg", "mass = 0.1  # kg"),
    key("operator.damping", "N.s/m", "damping = 0.2  # N.s/m"),
    key("operator.stiffness", "N/m", "stiffness = 50.0  # N/m"),
    key("operator.rest", "m", "rest = 0.0  # m"),
    key("operator.motion", "", "[operator.motion]\nkind = \"step\"\nat = 1.0  # s\nto = 0.01  # m"),
    key("operator.motion.kind", "", "kind = \"step\""),
    key("operator.motion.at", "s", "at = 1.0  # s"),
    key("operator.motion.to", "m", "to = 0.01  # m"),
    key("operator.motion.rate", "m/s", "rate = 0.02  # m/s"),
    key("operator.motion.amplitude", "m", "amplitude = 0.005  # m"),
    key("operator.motion.frequency", "Hz", "frequency = 1.0  # Hz"),
    key("operator.motion.path", "", "path = \"motion.csv\""),
    key(
        "operator.grip",
        "",
        "[operator.grip]\ntimes = [1.0]  # s\nstiffness = [500.0]  # N/m\ndamping = [5.0]  # N.s/m",
    ),
    key("operator.grip.times", "s", "times = [1.0, 2.0]  # s"),
    key("operator.grip.stiffness", "N/m", "stiffness = [500.0, 50.0]  # N/m"),
    key("operator.grip.damping", "N.s/m", "damping = [5.0, 0.2]  # N.s/m"),
    key("device", "", "[device]\nmass = 0.2  # kg"),
    key("device.mass", "kg", "mass = 0.2  # kg"),
    key("device.damping", "N.s/m", "damping = 0.001  # N.s/m"),
    key("link", "", "[link]\nstiffness = 20000.0  # N/m"),
    key("link.stiffness", "N/m", "stiffness = 20000.0  # N/m"),
    key("link.damping", "N.s/m", "damping = 1.0  # N.s/m"),
    key("space", "", "[space]\ndimensions = 2"),
    key("space.dimensions", "", "dimensions = 2"),
    key("initial", "", "[initial]\nposition = -0.004  # m"),
    key("initial.position", "m", "position = -0.004  # m"),
    key("initial.velocity", "m/s", "velocity = 0.0  # m/s"),
    key("environment", "", "[environment.wall]\nstiffness = 8000.0  # N/m"),
];

/// The key of the stabilizers.
const STABILIZED: &[Key] =
    &[key("stabilizer", "", "[stabilizer.popc]\ndamping_cap = 0.5  # m / T")];

/// The keys of the effects.
const EFFECTS: &[Key] = &[
    key("effects", "", "[effects.encoder]\nresolution = 1e-5  # m"),
    key("effects.encoder", "", "[effects.encoder]\nresolution = 1e-5  # m"),
    key("effects.encoder.resolution", "m", "resolution = 1e-5  # m"),
    key("effects.delay", "", "[effects.delay]\nticks = 2"),
    key("effects.delay.ticks", "servo ticks, 0 to 1024", "ticks = 2  # servo ticks"),
    key("effects.saturation", "", "[effects.saturation]\nforce = 8.0  # N"),
    key("effects.saturation.force", "N", "force = 8.0  # N"),
    key("effects.filter", "", "[effects.filter]\ncutoff = 30.0  # Hz"),
    key("effects.filter.cutoff", "Hz", "cutoff = 30.0  # Hz"),
    key("effects.filter.window", "servo ticks, 1 to 256", "window = 16  # servo ticks"),
    key("effects.noise", "", "[effects.noise]\ndeviation = 1e-6  # m\nseed = 1"),
    key("effects.noise.deviation", "m", "deviation = 1e-6  # m"),
    key("effects.noise.seed", "", "seed = 1"),
    key("effects.jitter", "", "[effects.jitter]\ndeviation = 5e-5  # s\nseed = 1"),
    key("effects.jitter.deviation", "s", "deviation = 5e-5  # s"),
    key("effects.jitter.seed", "", "seed = 1"),
    key(
        "effects.dropout",
        "",
        "[effects.dropout]\nprobability = 0.05\nseed = 1\npolicy = \"hold\"",
    ),
    key("effects.dropout.probability", "", "probability = 0.05"),
    key("effects.dropout.seed", "", "seed = 1"),
    key("effects.dropout.policy", "", "policy = \"hold\""),
    key(
        "effects.friction",
        "",
        "[effects.friction]\ncoulomb = 0.2  # N\nstatic = 0.3  # N\nstribeck_velocity = 0.01  # m/s",
    ),
    key("effects.friction.coulomb", "N", "coulomb = 0.2  # N"),
    key("effects.friction.static", "N", "static = 0.3  # N"),
    key("effects.friction.stribeck_velocity", "m/s", "stribeck_velocity = 0.01  # m/s"),
    key("effects.load", "", "[effects.load]\nforce = 1.0  # N"),
    key("effects.load.force", "N", "force = 1.0  # N"),
    key(
        "effects.pulse",
        "",
        "[effects.pulse]\nstart = 0.5  # s\nduration = 0.1  # s\nforce = 2.0  # N",
    ),
    key("effects.pulse.start", "s", "start = 0.5  # s"),
    key("effects.pulse.duration", "s", "duration = 0.1  # s"),
    key("effects.pulse.force", "N", "force = 2.0  # N"),
];

/// Whether `key` is a number: all are but those of tables and words.
pub(crate) fn is_number(key: &str) -> bool {
    BOOK.find(key).is_some_and(|key| !key.is_table() && !key.example.contains('"'))
}

/// Whether `key` is a number that is whole in its example.
pub(crate) fn is_whole(key: &str) -> bool {
    let example = BOOK.find(key).and_then(|key| DeTable::parse(key.example).ok());
    example.is_some_and(|it| it.get_ref().values().any(|value| value.get_ref().is_integer()))
}

/// The example of `key` as a list for so many `axes`, with its last number for every axis that it lacks.
pub(super) fn example(key: &str, axes: usize) -> String {
    let line = BOOK.find(key).map_or("", |key| key.example);
    let value = line.split(['=', '#']).nth(1).unwrap_or("1.0");
    let numbers: Vec<&str> = value.trim().trim_matches(['[', ']']).split(", ").collect();
    let number = |axis: usize| numbers[axis.min(numbers.len() - 1)];
    format!("[{}]", (0..axes).map(number).collect::<Vec<_>>().join(", "))
}

/// The unit of a key of a scene, without the range that may follow it for messages; empty if it has none.
pub(crate) fn unit(key: &str) -> &'static str {
    BOOK.find(key).map_or("", |key| key.unit.split(',').next().unwrap_or_default())
}
