//! Several axes under one observed energy or one for each axis.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant, PortEnergy, PortSample, Scalar, Stabilizer,
    bodies::{Body, Impedance},
    stabilizers::{NoStabilizer, PerAxis},
};
use nalgebra::SVector;

use crate::files::scene::Basis;
use crate::simulate::Space;
use crate::simulate::family::StabilizerName;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::member;
use crate::studies::hard::naive::Naive;
use crate::studies::hard::tally::Tally;
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{EveryScalar, HardError, MakeStabilizer, Runs, Trial};
use crate::studies::hard::watched::{Record, Watched};

const PERIOD: f64 = 1e-3;
const MASS: f64 = 0.2;
const TICKS: u64 = 4000;

type Plane<T> = SVector<T, 2>;

/// A port that absorbs along x and gives away along y.
struct Masking {
    per_axis: bool,
}

/// A damper along x, a driver along y.
struct Dampers;

impl<T: Scalar> OnePort<Plane<T>> for Dampers {
    fn respond(&mut self, sample: &PortSample<Plane<T>>) -> Plane<T> {
        SVector::from([sample.velocity[0] * T::of(2.0), sample.velocity[1] * T::of(-0.9)])
    }
}

fn limit<T: Scalar>() -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::of_mass(T::of(0.5), T::of(MASS), T::of(PERIOD))
}

/// Run of a hand that is thrown along x and let go along y. Returns its largest distance along y in the last
/// quarter, as a share of the start.
fn close<T: Scalar>(
    first: usize,
    stabilizer: impl Stabilizer<Plane<T>>,
) -> Result<T, ParameterError> {
    let [mass, damping, stiffness] = [MASS, 0.05, 200.0].map(T::of);
    let start = T::from_lanes(|lane| 0.01 - 0.0003 * (first + lane) as f64);
    let speed = SVector::from([T::of(1.0), T::zero()]);
    let body = Body::new(Impedance { mass, damping, stiffness }, T::of(PERIOD))?;
    let mut plant = body.starting(SVector::from([T::zero(), start]), speed);
    let mut port = Dampers.stabilized(stabilizer);
    let mut sample = plant.start();
    let mut most = T::zero();
    for tick in 0..TICKS {
        sample = plant.advance(port.respond(&sample));
        if tick > 3 * TICKS / 4 {
            most = most.larger(sample.position[1].magnitude() / start);
        }
    }
    Ok(most)
}

impl Masking {
    fn told<T: Scalar>(record: &[Record], value: T) -> Vec<Tally> {
        let mut tallies = record.iter().map(Record::tallies);
        let first = tallies.next().unwrap_or_default();
        let all = tallies
            .fold(first, |all, next| all.into_iter().zip(next).map(|(a, b)| a.worse(b)).collect());
        let told = |(lane, tally): (usize, Tally)| Tally { value: value.lane(lane), ..tally };
        all.into_iter().enumerate().map(told).collect()
    }

    fn alone(
        stabilizer: impl Stabilizer<Plane<f64>> + 'static,
    ) -> Result<Option<Tally>, HardError> {
        let terms = Terms::of(TICKS, f64::INFINITY);
        let (watched, record) = Watched::new(stabilizer, terms);
        let value = close::<f64>(0, watched)?;
        Ok(Self::told(&[record], value).pop())
    }
}

fn popc_limit<T: Scalar>() -> f64 {
    limit::<T>().map_or(f64::INFINITY, |limit| limit.most().lane(0))
}

impl EveryScalar for Masking {
    fn ours_in<T: Scalar>(&self, first: usize) -> Result<Vec<Tally>, HardError> {
        let popc = Lolc::new(PortEnergy, limit::<T>()?);
        let terms = || Terms::of(TICKS, popc_limit::<T>());
        if self.per_axis {
            let (x, of_x) = Watched::new(popc, terms());
            let (y, of_y) = Watched::new(popc, terms());
            let value = close::<T>(first, PerAxis::of([x, y]))?;
            return Ok(Self::told(&[of_x, of_y], value));
        }
        let (watched, record) = Watched::new(popc, terms());
        let value = close::<T>(first, watched)?;
        Ok(Self::told(&[record], value))
    }
}

/// Measurements under `member` on each axis.
fn per_axis<T: Scalar + Space>(
    member: StabilizerName,
    first: usize,
) -> Result<Vec<Tally>, HardError> {
    let basis = Basis::of_hand(MASS, PERIOD, 1.0);
    let pledge = member::pledge_of::<T>(member, &basis);
    let terms = Terms { pledge, ..Terms::of(TICKS, popc_limit::<T>()) };
    let (x, of_x) = Watched::new(member::set_by::<T>(member, &basis)?, terms.clone());
    let (y, of_y) = Watched::new(member::set_by::<T>(member, &basis)?, terms);
    let value = close::<T>(first, PerAxis::of([x, y]))?;
    Ok(Masking::told(&[of_x, of_y], value))
}

impl Trial for Masking {
    fn ours(&self) -> Result<Runs, HardError> {
        Runs::of(self)
    }

    fn under(&self, member: StabilizerName) -> Result<Runs, HardError> {
        // No member of the family watches all axes at once.
        if !self.per_axis {
            return Err(HardError::NoPart);
        }
        let double = |first| per_axis::<f64>(member, first);
        let single = |first| per_axis::<f32>(member, first);
        Runs::of_scalars(double, single)
    }

    fn with(&self, _own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        Self::alone(NoStabilizer)
    }

    fn naive(&self) -> Result<Option<Tally>, HardError> {
        Self::alone(Naive::<f64>::default())
    }
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, bound, per_axis| Case {
        name,
        theme: "axes",
        hard,
        quantity: Quantity::own("late swing of y / start", ""),
        bound,
        apart: None,
        trial: Box::new(Masking { per_axis }),
    };
    vec![
        case(
            "masking: a sum for each axis",
            "x burns 100 mJ of its own, y gives energy away: y may not live on what x burnt",
            1.0,
            true,
        ),
        case(
            "masking: one sum",
            "the same port: both together give nothing away, and y grows on what x burnt",
            // All energy of the start, 100 mJ in x and 10 mJ in y, ends in y.
            11_f64.sqrt(),
            false,
        ),
    ]
}
