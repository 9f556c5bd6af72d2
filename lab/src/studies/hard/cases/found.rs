//! Loops that a random search found: without a cap they run to the end of the range, or depend on roundings.
//!
//! They ran away with `damping_cap = inf`. Here the cap is half of `m / T`.

use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::looped::Looped;

/// Wall with `K T² / m = 18` whose force acts two ticks late: after one bounce, 661 kg fly off at 3 m/s.
const LATE: &str = "
duration = 2.2845031649528873e-2
servo_rate = 1.7509277559186445e4
operator = { mass = 5.069227007838071e2, damping = 4.223877932102459, stiffness = 9.196440736612512e3, rest = -1.8993015062682788e-3 }
device = { mass = 1.5406675508228398e2, damping = 4.2238779321024594e-1 }
initial = { position = -3.3724535757223686e-2, velocity = 3.099173235655846 }
environment.wall = { position = 4.756502334840401e-5, stiffness = 3.5972974039832686e12, damping = 2.8921182556962816e4 }
[stabilizer.popc]
damping_cap = 0.5
[effects.delay]
ticks = 2
";

/// Loop in which a fifth of the forces are lost, and nothing acts in their place.
const LOST: &str = "
duration = 2.441341919497634e2
servo_rate = 1.6384431726069317
operator = { mass = 3.721495320385751e1, damping = 4.463197998959122e2, stiffness = 1.9451628638474997e-4, rest = -4.2319674514388094e-8 }
device = { mass = 6.344495289435286e3, damping = 4.4631979989591215e1 }
initial = { position = 1.772772429049267e-7, velocity = 1.6947565701653157e-7 }
environment.wall = { position = -2.9555744050496075e-8, stiffness = 1.677944410090964e5, damping = 1.8097451587340039 }
[stabilizer.lolc]
damping_cap = 0.5
candidate = \"mass-spring-damper\"
[effects.dropout]
probability = 1.9647574622001515e-1
policy = \"zero\"
seed = 4100199770
";

/// Tens of nanonewtons on 5 t at 0.2 Hz; where a force is lost, the one before it acts on.
const HELD: &str = "
velocity = \"exact\"
duration = 2.350915826724089e3
servo_rate = 1.7014645758601432e-1
operator = { mass = 9.827035950626072e2, damping = 3.5331722638447594, stiffness = 1.1207676702253016e-4, rest = 2.551797647642319e-7 }
device = { mass = 4.0823311092814247e3, damping = 3.53317226384476e-1 }
initial = { position = 2.294337412052574e-7, velocity = -3.4955036112557734e-11 }
environment.wall = { position = 1.2541605805455682e-8, stiffness = 2.9794267149881388e-2, damping = 1.1783222998823659e1 }
[stabilizer.popc]
damping_cap = 0.5
[effects.dropout]
probability = 2.173990479357204e-1
policy = \"hold\"
seed = 1979298255
";

pub(super) fn cases() -> Vec<Case> {
    // The start, plus for the whole run the speed of the hand's first energy, `v² + k/m (x − rest)²` = speed². An
    // observed port gives out no more than it absorbed, so nothing moves faster or farther.
    let case = |name, hard, bound, credit, text: &str| Case {
        name,
        theme: "found",
        hard,
        quantity: Quantity::SWING,
        bound,
        apart: None,
        trial: Box::new(Looped { text: text.to_owned(), rest: 0.0, credit }),
    };
    vec![
        case(
            "a stiff wall, two ticks late",
            "seed 20026, scene 87: uncapped it leaves the range of f32; at half of m / T it holds",
            33.7246 + 3.1014 * 22.8451,
            0.0,
            LATE,
        ),
        case(
            "a fifth of the answers lost",
            "seed 20026, scene 431: uncapped it leaves the range of f32; at half of m / T it holds",
            1.7728e-4 + 1.695e-4 * 244.135,
            1.8097451587340039,
            LOST,
        ),
        case(
            "works of femtojoules",
            "seed 20026, scene 570: uncapped, f64 and f32 part on a rounding; at half of m / T they agree",
            2.2944e-4 + 3.517e-8 * 2350.92,
            0.0,
            HELD,
        ),
    ]
}
