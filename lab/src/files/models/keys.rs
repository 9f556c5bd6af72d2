//! The keys of model files for messages: the unit and a correct example line of each.

use crate::files::scene::{Book, Key, key};

/// The keys of model files.
pub(crate) const BOOK: Book = Book { noun: "model", keys: KEYS, own: || &[], smallest: SMALLEST };

/// The smallest valid file: the required keys only.
pub(crate) const SMALLEST: &str = "duration = 10.0  # s
servo_rate = 100.0  # Hz
initial = [0.5, 0.0]
[plant.van-der-pol]
mu = 1.0";

/// Every key and table; a test compares them with the types.
pub(crate) const KEYS: &[Key] = &[
    key("duration", "s", "duration = 10.0  # s"),
    key("servo_rate", "Hz", "servo_rate = 1000.0  # Hz"),
    key("scalar", "", "scalar = \"f64\""),
    key("steps_per_tick", "", "steps_per_tick = 4"),
    key("initial", "", "initial = [0.1, 0.0]"),
    key("plant", "", "[plant.van-der-pol]\nmu = 1.0"),
    key("plant.van-der-pol", "", "[plant.van-der-pol]\nmu = 1.0"),
    key("plant.van-der-pol.mu", "", "mu = 1.0"),
    key(
        "plant.inverted-pendulum",
        "",
        "[plant.inverted-pendulum]\nmass = 0.5  # kg\nlength = 0.4  # m",
    ),
    key("plant.inverted-pendulum.mass", "kg", "mass = 0.5  # kg"),
    key("plant.inverted-pendulum.length", "m", "length = 0.4  # m"),
    key("plant.inverted-pendulum.damping", "N.m.s/rad", "damping = 0.002  # N.m.s/rad"),
    key(
        "plant.dc-motor",
        "",
        "[plant.dc-motor]\ninertia = 1e-4  # kg.m²\ntorque_constant = 0.05  # N.m/A\nresistance = 1.0  # Ω\n\
         inductance = 0.02  # H\nwanted_stiffness = 0.05  # N.m/rad",
    ),
    key("plant.dc-motor.inertia", "kg.m²", "inertia = 1e-4  # kg.m²"),
    key("plant.dc-motor.friction", "N.m.s/rad", "friction = 1e-5  # N.m.s/rad"),
    key("plant.dc-motor.torque_constant", "N.m/A", "torque_constant = 0.05  # N.m/A"),
    key("plant.dc-motor.resistance", "Ω", "resistance = 1.0  # Ω"),
    key("plant.dc-motor.inductance", "H", "inductance = 0.02  # H"),
    key("plant.dc-motor.wanted_stiffness", "N.m/rad", "wanted_stiffness = 0.05  # N.m/rad"),
    key("plant.dc-motor.wanted_damping", "N.m.s/rad", "wanted_damping = 0.004  # N.m.s/rad"),
    key(
        "plant.admittance-device",
        "",
        "[plant.admittance-device]\nhand_stiffness = 1000.0  # N/m\nwanted_mass = 0.2  # kg",
    ),
    key("plant.admittance-device.hand_stiffness", "N/m", "hand_stiffness = 1000.0  # N/m"),
    key("plant.admittance-device.wanted_mass", "kg", "wanted_mass = 0.2  # kg"),
    key(
        "plant.two-link-arm",
        "",
        "[plant.two-link-arm]\nupper = { mass = 2.0, length = 0.4 }  # kg, m\n\
         lower = { mass = 1.0, length = 0.3 }",
    ),
    key(
        "plant.two-link-arm.upper",
        "",
        "[plant.two-link-arm.upper]\nmass = 2.0  # kg\nlength = 0.4  # m",
    ),
    key("plant.two-link-arm.upper.mass", "kg", "mass = 2.0  # kg"),
    key("plant.two-link-arm.upper.length", "m", "length = 0.4  # m"),
    key("plant.two-link-arm.upper.centre", "m", "centre = 0.2  # m"),
    key("plant.two-link-arm.upper.inertia", "kg.m²", "inertia = 0.03  # kg.m²"),
    key(
        "plant.two-link-arm.lower",
        "",
        "[plant.two-link-arm.lower]\nmass = 1.0  # kg\nlength = 0.3  # m",
    ),
    key("plant.two-link-arm.lower.mass", "kg", "mass = 1.0  # kg"),
    key("plant.two-link-arm.lower.length", "m", "length = 0.3  # m"),
    key("plant.two-link-arm.lower.centre", "m", "centre = 0.15  # m"),
    key("plant.two-link-arm.lower.inertia", "kg.m²", "inertia = 0.01  # kg.m²"),
    key(
        "plant.prosthetic-leg",
        "",
        "[plant.prosthetic-leg]\nposture = [0.3, -0.6]  # rad\nthigh = { mass = 4.0, length = 0.4 }  # kg, m\n\
         shank = { mass = 2.5, length = 0.45 }\nground = { stiffness = 2e4 }  # N/m",
    ),
    key("plant.prosthetic-leg.posture", "rad", "posture = [0.3, -0.6]  # rad"),
    key(
        "plant.prosthetic-leg.thigh",
        "",
        "[plant.prosthetic-leg.thigh]\nmass = 4.0  # kg\nlength = 0.4  # m",
    ),
    key("plant.prosthetic-leg.thigh.mass", "kg", "mass = 4.0  # kg"),
    key("plant.prosthetic-leg.thigh.length", "m", "length = 0.4  # m"),
    key("plant.prosthetic-leg.thigh.centre", "m", "centre = 0.2  # m"),
    key("plant.prosthetic-leg.thigh.inertia", "kg.m²", "inertia = 0.05  # kg.m²"),
    key(
        "plant.prosthetic-leg.shank",
        "",
        "[plant.prosthetic-leg.shank]\nmass = 2.5  # kg\nlength = 0.45  # m",
    ),
    key("plant.prosthetic-leg.shank.mass", "kg", "mass = 2.5  # kg"),
    key("plant.prosthetic-leg.shank.length", "m", "length = 0.45  # m"),
    key("plant.prosthetic-leg.shank.centre", "m", "centre = 0.2  # m"),
    key("plant.prosthetic-leg.shank.inertia", "kg.m²", "inertia = 0.04  # kg.m²"),
    key("plant.prosthetic-leg.ground", "", "[plant.prosthetic-leg.ground]\nstiffness = 2e4  # N/m"),
    key("plant.prosthetic-leg.ground.stiffness", "N/m", "stiffness = 2e4  # N/m"),
    key("plant.prosthetic-leg.ground.damping", "s/m", "damping = 0.5  # s/m"),
    key("plant.prosthetic-leg.ground.drag", "s/m", "drag = 0.2  # s/m"),
    key("controller", "", "[controller]\nproportional = 6.0  # N.m/rad or V/rad"),
    key(
        "controller.proportional",
        "N.m/rad or V/rad",
        "proportional = 6.0  # [40.0, 10.0] for two inputs",
    ),
    key(
        "controller.derivative",
        "N.m.s/rad or V.s/rad",
        "derivative = 0.4  # [4.0, 2.0] for two inputs",
    ),
    key("controller.hold", "servo ticks, 1 to 1024", "hold = 20  # servo ticks"),
    key("controller.delay", "servo ticks, 0 to 1024", "delay = 20  # servo ticks"),
    key("stabilizer", "", "[stabilizer]\ndamping_cap = 0.5  # m / T\ndecay = 1.0  # 1/s"),
    key("stabilizer.damping_cap", "m / T", "damping_cap = 0.5  # m / T"),
    key("stabilizer.decay", "1/s", "decay = 1.0  # 1/s"),
];
