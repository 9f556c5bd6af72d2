//! Contacts that only graze, never end, or come in pairs.

use lyapunov::{
    OnePort, ParameterError, Plant, PortSample, Scalar, Stabilizer,
    bodies::{Body, Impedance},
    environments::Wall,
};

use crate::files::scene::Basis;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::looped::Looped;
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{Play, Played};

/// Hand that swings from -8 mm about -4 mm: it reaches 0 and no further, up to the rounding.
const GRAZING: &str = "
duration = 20.0
servo_rate = 1000.0
operator = { mass = 0.1, stiffness = 50.0, rest = -0.004 }
device.mass = 0.2
initial.position = -0.008
environment.wall.stiffness = 1e5
stabilizer.popc = {}
";

/// Ball of 100 g without damping that falls 10 um onto a wall.
const BOUNCES: &str = "
duration = 60.0
servo_rate = 1000.0
device.mass = 0.1
initial.position = -1e-5
environment.wall.stiffness = 2e4
effects.load.force = 0.981
stabilizer.popc = {}
";

/// Hand that presses with 0.1 N on a surface between two counts.
const CHATTER: &str = "
duration = 20.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0, rest = 0.002 }
device = { mass = 0.2, damping = 0.001 }
environment.wall = { position = 5e-6, stiffness = 2e4, damping = 10.0 }
effects.encoder.resolution = 1e-5
stabilizer.popc = {}
";

/// Two walls of 20 kN/m, 2 mm apart, without damping between them.
struct Facing;

const GAP: f64 = 1e-3;
const PERIOD: f64 = 1e-3;
const MASS: f64 = 0.1;
const TICKS: u64 = 20_000;

/// A wall on each side.
struct Walls<T> {
    right: Wall<T>,
    left: Wall<T>,
}

impl<T: Scalar> OnePort<T> for Walls<T> {
    fn respond(&mut self, sample: &PortSample<T>) -> T {
        let (position, velocity) = (-sample.position, -sample.velocity);
        let mirrored = PortSample { position, velocity, ..*sample };
        self.right.respond(sample) - self.left.respond(&mirrored)
    }
}

impl Play for Facing {
    fn play<T: Scalar>(
        &self,
        _index: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        let wall = Wall::new(T::of(2e4), T::zero())?.at(T::of(GAP));
        let mut port = Walls { right: wall, left: wall }.stabilized(stabilizer);
        let speed = T::from_lanes(|lane| 0.1 - 0.004 * (first + lane) as f64);
        let parts = Impedance { mass: T::of(MASS), damping: T::zero(), stiffness: T::zero() };
        let mut plant = Body::new(parts, T::of(PERIOD))?.starting(T::zero(), speed);
        let mut sample = plant.start();
        for _ in 0..TICKS {
            sample = plant.advance(port.respond(&sample));
        }
        Ok(T::zero())
    }

    fn basis(&self) -> Basis {
        Basis::of_hand(MASS, PERIOD, 0.1)
    }

    fn terms(&self, limit: f64) -> Terms {
        Terms::of(TICKS, limit)
    }
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, bound, rest, text: &str| Case {
        name,
        theme: "contact",
        hard,
        quantity: Quantity::LATE_SWING,
        bound,
        apart: None,
        trial: Box::new(Looped { text: text.to_owned(), rest, credit: 0.0 }),
    };
    vec![
        case(
            "grazing contact",
            "the swing ends where the wall begins: a rounding decides whether they meet",
            4.0 * 1.01,
            -0.004,
            GRAZING,
        ),
        case(
            "endless small bounces",
            "10 um above a wall of 20 kN/m, nothing brakes: contacts of a few ticks, for ever",
            // The weight's deflection, 49 um; the deflection by the fall's energy, sqrt(49^2 + 2 49 10) = 58 um; and
            // the travel of two ticks, 14 um each: one before the wall samples the contact, one before its force acts.
            0.135,
            0.0,
            BOUNCES,
        ),
        case(
            "encoder chatter at rest",
            "the surface lies between two counts: one count more or less is 0.2 N and a velocity",
            // Two counts of the encoder.
            0.02,
            5e-6,
            CHATTER,
        ),
        Case {
            name: "two walls facing each other",
            theme: "contact",
            hard: "2 mm apart, undamped, 20 kN/m at 1 kHz: each throws the hand at the other",
            quantity: Quantity::LATE_SWING,
            // The gap, v sqrt(m / k) into the wall, and the travel of the tick before the wall samples the contact.
            bound: 1e3 * GAP + 0.224 + 0.1,
            apart: None,
            trial: Box::new(Played(Facing)),
        },
    ]
}
