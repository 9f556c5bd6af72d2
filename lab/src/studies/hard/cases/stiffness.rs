//! Walls far too stiff for their rate, and very small and very large masses.

use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::looped::Looped;

const PAPER: &str = "
duration = 20.0
servo_rate = 100.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.wall = { stiffness = 5e4, damping = 20.0 }
stabilizer.popc = {}
";

const MEGANEWTON: &str = "
duration = 10.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.wall = { stiffness = 1e6, damping = 0.0 }
stabilizer.popc = {}
";

const HEAVY_HAND: &str = "
duration = 10.0
servo_rate = 1000.0
operator = { mass = 1000.0, damping = 200.0, stiffness = 2000.0 }
device = { mass = 0.001, damping = 0.001 }
link = { stiffness = 100.0, damping = 0.01 }
initial.position = -0.004
environment.wall = { stiffness = 500.0, damping = 0.0 }
stabilizer.popc = {}
";

const HEAVY_DEVICE: &str = "
duration = 20.0
servo_rate = 1000.0
operator = { mass = 0.001, damping = 0.2, stiffness = 2000.0 }
device = { mass = 1000.0, damping = 1.0 }
link = { stiffness = 2000.0, damping = 0.1 }
initial.position = -0.004
environment.wall = { stiffness = 1e7, damping = 0.0 }
stabilizer.popc = {}
";

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, text: &str| Case {
        name,
        theme: "stiffness",
        hard,
        quantity: Quantity::LATE_SWING,
        // The distance of the start.
        bound: 4.0,
        apart: None,
        trial: Box::new(Looped { text: text.to_owned(), rest: 0.0, credit: 0.0 }),
    };
    vec![
        case(
            "1e6 N/m at 1 kHz",
            "K T^2 / m = 3.3: a tick is longer than the time the wall needs to throw the hand back",
            MEGANEWTON,
        ),
        case("5e4 N/m at 100 Hz", "K T^2 / m = 17: the paper's stiff wall", PAPER),
        case(
            "a hand 1e6 times the device",
            "1 t on 1 g through a link: the damping limit is that of the gram",
            HEAVY_HAND,
        ),
        case(
            "a device 1e6 times the hand",
            "1 g on 1 t: what the port sees is all device; K T^2 / m = 0.01 at 10 MN/m",
            HEAVY_DEVICE,
        ),
    ]
}
