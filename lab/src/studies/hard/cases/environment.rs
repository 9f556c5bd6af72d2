//! Active environments, wrong credits, slow clocks and saturated actuators.

use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::looped::Looped;

/// Damper of -3 N.s/m, which drives whatever moves.
const ACTIVE: &str = "
duration = 10.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.mass-spring-damper = { damping = -3.0, stiffness = 200.0 }
stabilizer.popc = {}
";

/// Wall that swings by itself and pumps the hand at the hand's own frequency.
const PUMPING: &str = "
duration = 20.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.varying-spring = { stiffness = 500.0, amplitude = 450.0, frequency = 13.5 }
stabilizer.popc = {}
";

/// Wall of 50 kN/m at 1 kHz whose virtual damper dissipates less than the paper's candidate credits.
const CREDIT: &str = "
duration = 20.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.wall = { stiffness = 5e4, damping = 20.0 }
stabilizer.lolc.candidate = \"device-damping\"
";

const JITTER: &str = "
duration = 5.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }
device = { mass = 0.2, damping = 0.001 }
initial.position = -0.004
environment.wall = { stiffness = 2e4, damping = 5.0 }
effects.jitter = { deviation = 3e-4, seed = 6 }
stabilizer.popc = {}
";

/// Hand that pushes with 5 N against a wall whose force saturates at 4 N.
const SATURATED: &str = "
duration = 10.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.2, stiffness = 50.0, rest = 0.1 }
device = { mass = 0.2, damping = 0.001 }
initial.velocity = 0.5
environment.wall = { stiffness = 1e5, damping = 20.0 }
effects.saturation.force = 4.0
stabilizer.popc = {}
";

fn case(
    name: &'static str,
    hard: &'static str,
    (rest, credit): (f64, f64),
    text: impl Into<String>,
) -> Case {
    Case {
        name,
        theme: "environment",
        hard,
        quantity: Quantity::LATE_SWING,
        // The distance of the start.
        bound: 4.0,
        apart: None,
        trial: Box::new(Looped { text: text.into(), rest, credit }),
    }
}

pub(super) fn cases() -> Vec<Case> {
    vec![
        case(
            "an active environment",
            "a damper of -3 N.s/m: it gives out 3 v^2 for as long as anything moves",
            (0.0, 0.0),
            ACTIVE,
        ),
        case(
            "a spring that pumps",
            "500 +- 450 N/m at twice the hand's own frequency: energy from outside, for ever",
            (0.0, 0.0),
            PUMPING,
        ),
        case(
            "a credit larger than what burns",
            "50 kN/m at 1 kHz: 20 N.s/m of the wall, credited, hide that it burns less; the device's do not",
            (0.0, 20.0),
            CREDIT,
        ),
        Case {
            quantity: Quantity::GIVEN,
            bound: 0.0,
            ..case(
                "the same credit, taken",
                "for the paper's candidate, under which the loop grows unseen and the account still closes",
                (0.0, 20.0),
                CREDIT.replace("device-damping", "mass-spring-damper"),
            )
        },
        case(
            "a jittered period",
            "each tick is 0.3 ms off by chance, and the velocity is wrong by as much",
            (0.0, 0.0),
            JITTER,
        ),
        Case {
            quantity: Quantity::ACTING,
            ..case(
                "saturation below the wall",
                "the hand pushes with 5 N at a wall that may give 4 N: it cannot hold, only not add",
                (0.1, 0.0),
                SATURATED,
            )
        },
    ]
}
