//! The same loop in other units.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant, PortEnergy, Scalar, Stabilizer,
    bodies::{Body, Impedance},
    environments::Wall,
};

use crate::files::scene::Basis;
use crate::files::scene::Pledge;
use crate::simulate::Space;
use crate::simulate::family::StabilizerName;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::member;
use crate::studies::hard::tally::Tally;
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{EveryScalar, HardError, MakeStabilizer, Runs, Trial};
use crate::studies::hard::watched::Watched;

const TICKS: u64 = 4000;

/// Loop in other units: `K T² / m`, `B T / m` and `b T / m` stay; masses, or periods, are `2^(4 k)` of the usual,
/// `k = −5 … 5`: 12 decades.
struct Scaled {
    /// Whether masses are scaled, instead of periods.
    masses: bool,
}

/// Powers of two by which masses or periods are scaled.
const POWERS: [i32; 11] = [-20, -16, -12, -8, -4, 0, 4, 8, 12, 16, 20];

impl Scaled {
    fn units(&self, power: i32) -> (f64, f64) {
        let factor = f64::from(power).exp2();
        if self.masses { (0.25 * factor, 1.0 / 1024.0) } else { (0.25, factor / 1024.0) }
    }

    fn limit<T: Scalar>(&self, power: i32) -> Result<DampingLimit<T>, ParameterError> {
        let (mass, period) = self.units(power);
        DampingLimit::of_mass(T::of(0.5), T::of(mass), T::of(period))
    }

    /// Basis of a hand that starts at 4 mm and swings at its own frequency.
    fn basis(&self, power: i32) -> Basis {
        let (mass, period) = self.units(power);
        Basis::of_hand(mass, period, 0.004 * 0.0002_f64.sqrt() / period)
    }

    fn of_family<T: Scalar + Space>(
        &self,
        member: StabilizerName,
        first: usize,
    ) -> Result<Vec<Tally>, HardError> {
        let pledge = |power| member::pledge_of::<T>(member, &self.basis(power));
        self.spread::<T, _>(first, pledge, |power| member::set_by::<T>(member, &self.basis(power)))
    }

    /// Late swing of a hand on a wall, m: `K T² / m = 0.25`, `B T / m = 0.02`, `b T / m = 0.001`.
    fn close<T: Scalar>(
        &self,
        power: i32,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        let (mass, period) = self.units(power);
        let of = |stiffness: f64| T::of(stiffness * mass / (period * period));
        let damping = |damping: f64| T::of(damping * mass / period);
        let parts = Impedance { mass: T::of(mass), damping: damping(0.001), stiffness: of(0.0002) };
        let start = T::from_lanes(|lane| -0.004 * (1.0 - 0.02 * (first + lane) as f64));
        let mut plant = Body::new(parts, T::of(period))?.starting(start, T::zero());
        let mut port = Wall::new(of(0.25), damping(0.02))?.stabilized(stabilizer);
        let mut sample = plant.start();
        let mut most = T::zero();
        for tick in 0..TICKS {
            sample = plant.advance(port.respond(&sample));
            if 4 * tick >= 3 * TICKS {
                most = most.larger(sample.position.magnitude());
            }
        }
        Ok(most)
    }

    /// Measurements of the scaled runs, the worst of all powers; their value is
    /// `|late swing / usual late swing − 1|`.
    fn spread<T: Scalar, S: Stabilizer<T> + 'static>(
        &self,
        first: usize,
        pledge: impl Fn(i32) -> Pledge,
        stabilizer: impl Fn(i32) -> Result<S, HardError>,
    ) -> Result<Vec<Tally>, HardError> {
        let mut worst = vec![Tally::default(); T::LANES];
        let usual = self.close::<T>(0, first, stabilizer(0)?)?;
        for power in POWERS {
            let most = self.limit::<T>(power)?.most().lane(0);
            let terms = Terms { pledge: pledge(power), ..Terms::of(TICKS, most) };
            let (watched, record) = Watched::new(stabilizer(power)?, terms);
            let swing = self.close::<T>(power, first, watched)?;
            for (lane, mut tally) in record.tallies().into_iter().enumerate() {
                tally.value = (swing.lane(lane) / usual.lane(lane) - 1.0).abs();
                worst[lane] = worst[lane].worse(tally);
            }
        }
        Ok(worst)
    }
}

impl EveryScalar for Scaled {
    fn ours_in<T: Scalar>(&self, first: usize) -> Result<Vec<Tally>, HardError> {
        let popc = |power| Ok(Lolc::new(PortEnergy, self.limit::<T>(power)?));
        self.spread::<T, _>(first, |_| Pledge::POPC, popc)
    }
}

impl Trial for Scaled {
    fn ours(&self) -> Result<Runs, HardError> {
        Runs::of(self)
    }

    fn under(&self, member: StabilizerName) -> Result<Runs, HardError> {
        let double = |first| self.of_family::<f64>(member, first);
        let single = |first| self.of_family::<f32>(member, first);
        Runs::of_scalars(double, single)
    }

    fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        Ok(self.spread::<f64, _>(0, |_| Pledge::POPC, |_| Ok(own()))?.pop())
    }
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, masses| Case {
        name,
        theme: "scale",
        hard,
        quantity: Quantity::own("swing scaled / usual - 1", ""),
        bound: 1e-3,
        apart: None,
        trial: Box::new(Scaled { masses }),
    };
    vec![
        case(
            "masses over 12 decades",
            "2^-20 to 2^20 of 0.25 kg with K T^2/m, B T/m, b T/m kept: the same run but for rounding",
            true,
        ),
        case(
            "periods over 12 decades",
            "2^-20 to 2^20 of 1 ms, likewise: from 1 ns to 17 minutes a tick",
            false,
        ),
    ]
}
