//! The damping limit at 0, 1 and 2 of `m / T`.

use lyapunov::{
    HeldTick, OnePort, ParameterError, Plant, PortSample, Scalar, Stabilizer,
    bodies::{Body, Impedance},
};

use crate::files::scene::Basis;
use crate::files::scene::Damping;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{Play, Played};

const PERIOD: f64 = 1e-3;
const MASS: f64 = 0.2;
const TICKS: u64 = 10_000;
/// Initial speed of the mass, m/s.
const SPEED: f64 = 0.1;

/// Free moving mass on a port with a debt of 1 J, a thousand times the mass's kinetic energy: the damping stays at
/// its limit.
struct Indebted {
    cap: f64,
    /// The first tick on which the velocity is measured.
    from: u64,
}

/// A port without an effort.
struct Still;

impl<T: Scalar> OnePort<T> for Still {
    fn respond(&mut self, _sample: &PortSample<T>) -> T {
        T::zero()
    }
}

impl Play for Indebted {
    fn play<T: Scalar>(
        &self,
        _index: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        let (period, mass) = (T::of(PERIOD), T::of(MASS));
        let speed = T::from_lanes(|lane| SPEED * (1.0 - 0.05 * (first + lane) as f64));
        let mut port = Still.stabilized(stabilizer);
        let parts = Impedance { mass, damping: T::zero(), stiffness: T::zero() };
        let mut plant = Body::new(parts, period)?.starting(T::zero(), speed);
        let before = HeldTick {
            period,
            position: T::zero(),
            velocity: T::zero(),
            displacement: T::of(0.05),
            applied: T::of(-20.0),
        }
        .sample();
        port.respond(&PortSample::starting(period, T::zero(), T::zero()));
        port.respond(&before);
        let mut sample = plant.start();
        let mut most = T::zero();
        for tick in 0..TICKS {
            sample = plant.advance(port.respond(&sample));
            if tick >= self.from {
                let share = sample.velocity.magnitude() / speed;
                most = T::choose(share.below(most), most, share);
            }
        }
        Ok(most)
    }

    fn basis(&self) -> Basis {
        let basis = Basis::of_hand(MASS, PERIOD, SPEED);
        Basis { limit: Damping { cap: self.cap, ..basis.limit }, ..basis }
    }

    fn terms(&self, limit: f64) -> Terms {
        Terms::of(TICKS + 2, limit)
    }
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, bound, indebted| Case {
        name,
        theme: "limit",
        hard,
        quantity: Quantity::own("velocity / first velocity", ""),
        bound,
        apart: None,
        trial: Box::new(Played(indebted)),
    };
    vec![
        case(
            "a cap of 0",
            "a pure observer: 1 J is owed, told in full as shortfall, and nothing is corrected",
            1.0,
            Indebted { cap: 0.0, from: 0 },
        ),
        case(
            "a cap of m / T",
            "1 J is owed: one tick takes all of the motion, and a rounding more turns it round",
            1e-6,
            Indebted { cap: 1.0, from: 1 },
        ),
        case(
            "a cap of 2 m / T",
            "1 J is owed: each tick turns the motion round, burns nothing, and may not let it grow",
            1.0 + 1e-3,
            Indebted { cap: 2.0, from: 0 },
        ),
    ]
}
