//! The keys of teleoperator files for messages: the unit and a correct example line of each.

use crate::files::scene::{Book, Key, key};

/// The keys of teleoperator files.
pub(crate) const BOOK: Book =
    Book { noun: "teleoperator", keys: KEYS, own: || &[], smallest: SMALLEST };

/// The smallest valid file: the required keys only.
pub(crate) const SMALLEST: &str = "duration = 5.0  # s
servo_rate = 1000.0  # Hz
[master]
mass = 0.3  # kg
hand_stiffness = 100.0  # N/m
start = -0.01  # m
[slave]
mass = 0.3  # kg
[coordination]
stiffness = 200.0  # N/m
damping = 5.0  # N.s/m";

/// Every key and table; a test compares them with the types.
pub(crate) const KEYS: &[Key] = &[
    key("duration", "s", "duration = 5.0  # s"),
    key("servo_rate", "Hz", "servo_rate = 1000.0  # Hz"),
    key("scalar", "", "scalar = \"f64\""),
    key(
        "master",
        "",
        "[master]\nmass = 0.3  # kg\nhand_stiffness = 100.0  # N/m\nstart = -0.01  # m",
    ),
    key("master.mass", "kg", "mass = 0.3  # kg"),
    key("master.damping", "N.s/m", "damping = 1.0  # N.s/m"),
    key("master.hand_stiffness", "N/m", "hand_stiffness = 100.0  # N/m"),
    key("master.start", "m", "start = -0.01  # m"),
    key("slave", "", "[slave]\nmass = 0.3  # kg"),
    key("slave.mass", "kg", "mass = 0.3  # kg"),
    key("slave.damping", "N.s/m", "damping = 1.0  # N.s/m"),
    key("slave.wall", "", "[slave.wall]\nstiffness = 2000.0  # N/m"),
    key("slave.wall.position", "m", "position = -0.005  # m"),
    key("slave.wall.stiffness", "N/m", "stiffness = 2000.0  # N/m"),
    key("coordination", "", "[coordination]\nstiffness = 200.0  # N/m\ndamping = 5.0  # N.s/m"),
    key("coordination.stiffness", "N/m", "stiffness = 200.0  # N/m"),
    key("coordination.damping", "N.s/m", "damping = 5.0  # N.s/m"),
    key("channel", "", "[channel]\ndelay = 50  # servo ticks"),
    key("channel.delay", "servo ticks, 0 to 1024", "delay = 50  # servo ticks"),
    key("channel.spread", "servo ticks, 0 to 1024", "spread = 40  # servo ticks"),
    key("channel.loss", "", "loss = 0.3"),
    key("channel.seed", "", "seed = 1"),
    key("stabilizer", "", "[stabilizer]\ndamping_cap = 0.5"),
    key("stabilizer.damping_cap", "", "damping_cap = 0.5"),
    key("stabilizer.drift-compensated", "", "[stabilizer.drift-compensated]\nspeed = 0.02  # m/s"),
    key("stabilizer.drift-compensated.speed", "m/s", "speed = 0.02  # m/s"),
    key("stabilizer.two-layer", "", "[stabilizer.two-layer]\nlevel = 0.005  # J"),
    key("stabilizer.two-layer.level", "J", "level = 0.005  # J"),
    key("stabilizer.two-layer.gain", "N.s/(m J)", "gain = 2000.0  # N.s/(m J)"),
    key("stabilizer.two-layer.share", "", "share = 0.1"),
    key("stabilizer.wave-variables", "", "[stabilizer.wave-variables]\nimpedance = 5.0  # N.s/m"),
    key("stabilizer.wave-variables.impedance", "N.s/m", "impedance = 5.0  # N.s/m"),
    key("stabilizer.wave-variables.filter_time", "s", "filter_time = 0.004  # s"),
];
