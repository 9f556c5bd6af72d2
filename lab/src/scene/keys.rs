//! What messages say about each key: its unit, and a line that would be right.

/// One key of a scene file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Key {
    /// Its name with its table path.
    pub(super) path: &'static str,
    /// Its unit; empty where it has none.
    pub(super) unit: &'static str,
    /// Lines that are right, from within its table; for a table, with its header.
    pub(super) example: &'static str,
}

/// A file that holds what is required and nothing else.
pub(super) const SMALLEST: &str = "duration = 1.0  # s
servo_rate = 1000.0  # Hz
[device]
mass = 0.2  # kg
[environment.wall]
stiffness = 8000.0  # N/m";

const fn key(path: &'static str, unit: &'static str, example: &'static str) -> Key {
    Key { path, unit, example }
}

/// Every key and table; a test holds it against the types.
pub(super) const KEYS: &[Key] = &[
    key("duration", "s", "duration = 10.0  # s"),
    key("servo_rate", "Hz", "servo_rate = 1000.0  # Hz"),
    key("environment_rate", "Hz", "environment_rate = 100.0  # Hz"),
    key("velocity", "", "velocity = \"backward-difference\""),
    key("scalar", "", "scalar = \"f64\""),
    key("integrator", "", "integrator = \"exact\""),
    key("operator", "", "[operator]\nmass = 0.1  # kg"),
    key("operator.mass", "kg", "mass = 0.1  # kg"),
    key("operator.damping", "N.s/m", "damping = 0.2  # N.s/m"),
    key("operator.stiffness", "N/m", "stiffness = 50.0  # N/m"),
    key("operator.rest", "m", "rest = 0.0  # m"),
    key("device", "", "[device]\nmass = 0.2  # kg"),
    key("device.mass", "kg", "mass = 0.2  # kg"),
    key("device.damping", "N.s/m", "damping = 0.001  # N.s/m"),
    key("initial", "", "[initial]\nposition = -0.004  # m"),
    key("initial.position", "m", "position = -0.004  # m"),
    key("initial.velocity", "m/s", "velocity = 0.0  # m/s"),
    key("environment", "", "[environment.wall]\nstiffness = 8000.0  # N/m"),
    key("environment.wall", "", "[environment.wall]\nstiffness = 8000.0  # N/m"),
    key("environment.wall.stiffness", "N/m", "stiffness = 8000.0  # N/m"),
    key("environment.wall.position", "m", "position = 0.0  # m"),
    key("environment.wall.damping", "N.s/m", "damping = 2.0  # N.s/m"),
    key("stabilizer", "", "[stabilizer.popc]\ndamping_cap = 0.5  # m / T"),
    key("stabilizer.lolc", "", "[stabilizer.lolc]\ndamping_cap = 0.5  # m / T"),
    key("stabilizer.lolc.work", "", "work = \"held\""),
    key("stabilizer.lolc.candidate", "", "candidate = \"device-damping\""),
    key("stabilizer.lolc.damping_cap", "m / T", "damping_cap = 0.5  # m / T"),
    key("stabilizer.popc", "", "[stabilizer.popc]\ndamping_cap = 0.5  # m / T"),
    key("stabilizer.popc.work", "", "work = \"held\""),
    key("stabilizer.popc.damping_cap", "m / T", "damping_cap = 0.5  # m / T"),
    key("effects", "", "[effects.encoder]\nresolution = 1e-5  # m"),
    key("effects.encoder", "", "[effects.encoder]\nresolution = 1e-5  # m"),
    key("effects.encoder.resolution", "m", "resolution = 1e-5  # m"),
    key("effects.delay", "", "[effects.delay]\nticks = 2"),
    key("effects.delay.ticks", "servo ticks, 0 to 1024", "ticks = 2  # servo ticks"),
    key("effects.saturation", "", "[effects.saturation]\nforce = 8.0  # N"),
    key("effects.saturation.force", "N", "force = 8.0  # N"),
];

impl Key {
    /// Whether it is a table, or one that chooses among tables, rather than a value.
    pub(super) fn is_table(&self) -> bool {
        self.example.starts_with('[')
    }

    /// Its name without the table path.
    pub(super) fn name(&self) -> &'static str {
        split(self.path).1
    }

    /// The table it stands in; empty at the top level.
    pub(super) fn table(&self) -> &'static str {
        split(self.path).0
    }
}

/// The entry of a key with this table path.
pub(super) fn find(path: &str) -> Option<&'static Key> {
    KEYS.iter().find(|key| key.path == path)
}

/// A table path and the name in it.
pub(super) fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('.').unwrap_or(("", path))
}
