//! Forces that act ticks late.

use lyapunov::DampingLimit;

use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::looped::Looped;

/// The damping cap, of `m / T`, that the rule gives for `ticks` of delay.
fn cap(ticks: u32) -> f64 {
    // With a mass of 1 kg and a period of 1 s the limit equals the cap.
    DampingLimit::at(0.5).map_or(0.0, |limit: DampingLimit<f64>| limit.delayed(ticks).most())
}

fn scene(ticks: u32) -> String {
    format!(
        "
duration = 20.0
servo_rate = 1000.0
operator = {{ mass = 0.1, damping = 0.1, stiffness = 50.0 }}
device = {{ mass = 0.2, damping = 0.001 }}
initial.position = -0.004
environment.wall = {{ stiffness = 2000.0, damping = 0.0 }}
stabilizer.popc.damping_cap = {}
effects.delay.ticks = {ticks}
",
        cap(ticks)
    )
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, ticks| Case {
        name,
        theme: "delay",
        hard,
        quantity: Quantity::LATE_SWING,
        // The distance of the start.
        bound: 4.0,
        apart: None,
        trial: Box::new(Looped { text: scene(ticks), rest: 0.0, credit: 0.0 }),
    };
    vec![
        case(
            "1 tick of delay",
            "the wall gives out k v^2 T more per tick it is late; the rule's cap is 0.207 m / T",
            1,
        ),
        case(
            "2 ticks of delay",
            "the damper is as late as the wall: the rule's cap is 0.134 m / T",
            2,
        ),
        case("3 ticks of delay", "likewise, 0.099 m / T", 3),
        case("4 ticks of delay", "likewise, 0.079 m / T", 4),
        case(
            "5 ticks of delay",
            "likewise, 0.066 m / T; at half of m / T the damper alone would grow",
            5,
        ),
    ]
}
