//! Numbers at the ends of their range.

use lyapunov::{HeldTick, ParameterError, PortSample, Scalar, Stabilizer};

use crate::files::scene::Basis;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{Play, Played};

const PERIOD: f64 = 1e-3;
const MASS: f64 = 0.2;
const TICKS: u64 = 400;

/// Strokes back and forth at a given speed, under efforts of a given size that generate energy at first.
struct Strokes {
    /// Speed in `f64` and in `f32`, m/s.
    speed: [f64; 2],
    /// Force in `f64` and in `f32`, N.
    force: [f64; 2],
    /// The true speed throughout, which only every other ten ticks report, m/s; none: `speed`.
    ordinary: Option<f64>,
}

/// The number for `T`, of one for `f64` and one for `f32`.
fn sized<T: Scalar>(sizes: [f64; 2]) -> T {
    let single = T::epsilon().lane(0) > 1e-10;
    T::of(sizes[usize::from(single)])
}

impl Play for Strokes {
    fn play<T: Scalar>(
        &self,
        _index: u64,
        first: usize,
        mut stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        let period = T::of(PERIOD);
        let (speed, force) = (sized::<T>(self.speed), sized::<T>(self.force));
        let mut position = T::zero();
        stabilizer.stabilize(&PortSample::starting(period, position, T::zero()), T::zero());
        let mut applied = T::zero();
        for tick in 0..TICKS {
            // Every lane has a stroke length of its own, and neighbouring ticks differ.
            let share = T::from_lanes(|lane| {
                let turn = tick as usize / (first + lane + 3) % 2;
                let length = 1.0 - 0.1 * (first + lane) as f64 + 0.03 * (tick % 7) as f64;
                length * [1.0, -1.0][turn]
            });
            // Ten ticks report the ordinary speed, where there is one, and ten the hard one.
            let ordinary = self.ordinary.filter(|_| tick / 10 % 2 == 0).map(T::of);
            let velocity = ordinary.unwrap_or(speed) * share;
            // The port moves at the ordinary speed, whatever the sample reports.
            let moved = self.ordinary.map_or(velocity, |speed| T::of(speed) * share);
            let displacement = moved * period;
            position += displacement;
            let sample = HeldTick { period, position, velocity, displacement, applied }.sample();
            // Along the motion at first, which generates energy; in the last three quarters half of that against it.
            let sign = T::choose(share.above(T::zero()), T::one(), -T::one());
            let away = if tick < TICKS / 4 { -1.0 } else { 0.5 };
            applied = force * sign * T::of(away);
            stabilizer.stabilize(&sample, applied);
        }
        Ok(T::zero())
    }

    fn basis(&self) -> Basis {
        Basis::of_hand(MASS, PERIOD, 0.1)
    }

    fn terms(&self, limit: f64) -> Terms {
        Terms::of(TICKS + 1, limit)
    }
}

fn case(name: &'static str, hard: &'static str, strokes: Strokes) -> Case {
    Case {
        name,
        theme: "numbers",
        hard,
        quantity: Quantity::CORRECTION,
        bound: 1.0 + 1e-6,
        apart: None,
        trial: Box::new(Played(strokes)),
    }
}

pub(super) fn cases() -> Vec<Case> {
    let strokes = |speed, force| Strokes { speed, force, ordinary: None };
    let at_rest = |speed| Strokes { ordinary: Some(0.01), ..strokes(speed, [0.3; 2]) };
    vec![
        case(
            "a debt at rest",
            "v = 0 while energy leaks: there is no velocity to divide by, or to damp",
            at_rest([0.0; 2]),
        ),
        case(
            "a debt at a subnormal velocity",
            "v = 1e-310 (f64), 1e-40 (f32): v and all that is made of it has lost its digits",
            at_rest([1e-310, 1e-40]),
        ),
        case(
            "a square of 0",
            "v = 1e-170 (f64), 1e-25 (f32): v is sound and v^2 underflows",
            at_rest([1e-170, 1e-25]),
        ),
        case(
            "a subnormal square",
            "v^2 T is below the smallest normal number, and not 0",
            at_rest([1e-153, 1e-19]),
        ),
        case(
            "forces and velocities of 1e150",
            "1e18 in f32: the square of each is near the end of the range",
            strokes([1e150, 1e18], [1e150, 1e18]),
        ),
        case(
            "forces and velocities of 1e-150",
            "1e-18 in f32: works below the smallest number that has all its digits",
            strokes([1e-150, 1e-18], [1e-150, 1e-18]),
        ),
        case(
            "forces of 1e150 at 1e-150 m/s",
            "1e18 at 1e-18 in f32: an ordinary debt, a damping beyond all bounds",
            strokes([1e-150, 1e-18], [1e150, 1e18]),
        ),
    ]
}
