//! Long runs and late time stamps.

use lyapunov::{
    DampingLimit, Held, HeldTick, Lolc, OnePort, ParameterError, Plant, PortEnergy, PortSample,
    Scalar, Stabilizer,
    accumulators::{Accumulator, Compensated, Plain},
    bodies::{Body, Impedance, PlantExt},
    effects::OnePortExt,
    environments::Wall,
    stabilizers::NoStabilizer,
    trajectories::{Sine, Trajectory},
};

use crate::files::scene::Basis;
use crate::simulate::Space;
use crate::simulate::family::StabilizerName;
use crate::studies::hard::balance::{Balance, Double, Told};
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::member;
use crate::studies::hard::naive::Naive;
use crate::studies::hard::tally::{Tally, larger};
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{HardError, MakeStabilizer, Play, Played, Runs, Trial};
use crate::studies::hard::watched::Watched;

/// A stabilizer that sums the observed energy in an `A`.
type Summed<T, A> = Lolc<T, PortEnergy, Held, A>;

fn popc<T: Scalar, A: Accumulator<T>>(mass: f64, period: f64) -> Result<Summed<T, A>, HardError> {
    let limit = DampingLimit::of_mass(T::of(0.5), T::of(mass), T::of(period))?;
    Ok(Lolc::new(PortEnergy, limit).summed_in::<A>())
}

/// Run of 1e8 ticks: of every eight, five absorb 2^-20 J and three give it back.
///
/// Every number is a power of two, so that the energy over the port is counted, not summed: 25 million times 2^-20 J.
struct Counted;

const MANY: u64 = 100_000_000;

impl Counted {
    fn run<T: Scalar>(stabilizer: &mut impl Stabilizer<T>) -> Tally {
        let exp2 = |power: i32| T::of(f64::from(power).exp2());
        let (period, velocity, displacement, force) = (exp2(-10), exp2(-3), exp2(-13), exp2(-7));
        let sample = |applied| {
            HeldTick { period, position: T::zero(), velocity, displacement, applied }.sample()
        };
        let (absorbs, gives) = (sample(force), sample(-force));
        let mut tally = Tally::default();
        let mut told = T::zero();
        for _ in 0..MANY / 8 {
            for eighth in 0..8_u32 {
                let (sample, effort) = if eighth % 2 == 0 || eighth == 7 {
                    (&absorbs, force)
                } else {
                    (&gives, -force)
                };
                let correction = stabilizer.stabilize(sample, effort);
                told = correction.observed_energy;
                tally.peak_force = larger(tally.peak_force, correction.effort.lane(0).abs());
            }
        }
        let unit = (-20_f64).exp2();
        let counted = (MANY / 4) as f64 * unit;
        let error = (told.lane(0) - counted).abs();
        let allowed = MANY as f64 * unit + MANY as f64 * counted;
        tally.off = error / (4.0 * T::epsilon().lane(0) / 2.0 * allowed);
        tally.value = error / counted;
        tally
    }
}

impl Trial for Counted {
    fn ours(&self) -> Result<Runs, HardError> {
        let double = Self::run::<f64>(&mut popc::<f64, Plain<f64>>(0.25, 1e-3)?);
        let single = Self::run::<f32>(&mut popc::<f32, Compensated<f32>>(0.25, 1e-3)?);
        Ok(Runs { double: vec![double], single: vec![single], ..Runs::default() })
    }

    fn under(&self, _member: StabilizerName) -> Result<Runs, HardError> {
        // The case is about the ledger's summation, which a member does not choose.
        Err(HardError::NoPart)
    }

    fn with(&self, _own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        Ok(None)
    }

    fn naive(&self) -> Result<Option<Tally>, HardError> {
        Ok(Some(Self::run::<f32>(&mut Naive::<f32>::default())))
    }
}

/// An hour at 10 kHz: a hand that moves back and forth onto a wall computed at 1 kHz.
struct Hour;

const HOUR: u64 = 36_000_000;

/// Goal of the hand: ±8 mm, half a second each.
#[derive(Clone, Copy)]
struct ToAndFro;

impl<T: Scalar> Trajectory<T> for ToAndFro {
    fn at(&self, tick: u64) -> T {
        T::of(if (tick / 5000).is_multiple_of(2) { 0.008 } else { -0.008 })
    }
}

impl Hour {
    fn run<T: Scalar>(mut stabilizer: impl Stabilizer<T>) -> Result<Tally, HardError> {
        let parts = Impedance { mass: 0.3, damping: 0.5, stiffness: 50.0 };
        let [mass, damping, stiffness] = [parts.mass, parts.damping, parts.stiffness].map(T::of);
        let body = Body::new(Impedance { mass, damping, stiffness }, T::of(1e-4))?;
        let mut plant = body.led_by(ToAndFro);
        let mut wall = Wall::new(T::of(8000.0), T::zero())?.held(10)?;
        let mut balance =
            Balance::new(T::epsilon().lane(0) / 2.0, T::smallest_normal().lane(0), 0.0);
        let mut tally = Tally::default();
        let mut sample = plant.start();
        for tick in 0..HOUR {
            let effort = wall.respond(&sample);
            let correction = stabilizer.stabilize(&sample, effort);
            balance
                .book(&[Double::product(sample.applied.lane(0), sample.displacement.lane(0))], 0.0);
            if tick % 1000 == 0 {
                let square = (sample.velocity * sample.velocity * sample.period).lane(0);
                let told = Told {
                    sum: correction.observed_energy.lane(0),
                    dissipated: correction.alpha.lane(0) * square,
                    shortfall: correction.shortfall.lane(0),
                };
                tally.off = larger(tally.off, balance.off(told));
            }
            let force = correction.effort.lane(0);
            if !force.is_finite() && tally.not_finite.is_none() {
                tally.not_finite = Some(tick);
            }
            tally.peak_force = larger(tally.peak_force, force.abs());
            if 4 * tick >= 3 * HOUR {
                tally.late_swing = larger(tally.late_swing, sample.position.lane(0).abs());
            }
            sample = plant.advance(correction.effort);
        }
        tally.given = -balance.supplied();
        Ok(tally)
    }
}

impl Trial for Hour {
    fn ours(&self) -> Result<Runs, HardError> {
        let single = Self::run::<f32>(popc::<f32, Compensated<f32>>(0.3, 1e-4)?)?;
        let double = Self::run::<f64>(popc::<f64, Plain<f64>>(0.3, 1e-4)?)?;
        Ok(Runs { double: vec![double], single: vec![single], ..Runs::default() })
    }

    fn under(&self, _member: StabilizerName) -> Result<Runs, HardError> {
        // The case is about the ledger's summation, which a member does not choose.
        Err(HardError::NoPart)
    }

    fn with(&self, _own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        Ok(Some(Self::run::<f32>(NoStabilizer)?))
    }

    fn naive(&self) -> Result<Option<Tally>, HardError> {
        Ok(Some(Self::run::<f32>(Naive::<f32>::default())?))
    }
}

/// A loop after 1e9 s at 1 kHz, led by a sine of 2 Hz, compared with the same loop at its start.
struct Late;

const LATE: u64 = 1_000_000_000_000;
const RATE: f64 = 1000.0;
const TICKS: u64 = 4000;

/// A trajectory that starts at a later tick.
#[derive(Clone, Copy)]
struct From<C>(C, u64);

impl<T: Scalar, C: Trajectory<T>> Trajectory<T> for From<C> {
    fn at(&self, tick: u64) -> T {
        self.0.at(self.1 + tick)
    }
}

impl Late {
    fn close<T: Scalar>(
        from: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
        period_of: impl Fn(u64) -> T,
    ) -> Result<Vec<T>, ParameterError> {
        let [mass, damping, stiffness] = [0.3, 0.5, 50.0].map(T::of);
        let start = T::from_lanes(|lane| -0.004 * (1.0 - 0.02 * (first + lane) as f64));
        let body = Body::new(Impedance { mass, damping, stiffness }, T::of(1.0 / RATE))?;
        let body = body.starting(start, T::zero());
        let mut plant = body.led_by(From(Sine::new(0.0, 0.01, 2.0, RATE)?, from));
        let mut port = Wall::new(T::of(8000.0), T::of(1.0))?.stabilized(stabilizer).differenced();
        let mut sample = plant.start();
        let mut positions = Vec::new();
        for tick in 0..TICKS {
            let told = PortSample { period: period_of(from + tick), ..sample };
            sample = plant.advance(port.respond(&told));
            positions.push(sample.position);
        }
        Ok(positions)
    }

    fn apart<T: Scalar>(one: &[T], other: &[T]) -> T {
        let apart = one.iter().zip(other).map(|(a, b)| (*a - *b).magnitude());
        apart.fold(T::zero(), |most, next| T::choose(next.below(most), most, next))
    }

    /// Measurements of a late run under `member`, with its distance from an early run as the value.
    fn both<T: Scalar + Space>(
        &self,
        member: StabilizerName,
        first: usize,
    ) -> Result<Tally, HardError> {
        let (basis, period) = (self.basis(), |_| T::of(1.0 / RATE));
        let terms = self.terms(self.limit::<T>()?.most().lane(0));
        let terms = Terms { pledge: member::pledge_of::<T>(member, &basis), ..terms };
        let (watched, record) = Watched::new(member::set_by::<T>(member, &basis)?, terms);
        let late = Self::close(LATE, first, watched, period)?;
        let early = Self::close(0, first, member::set_by::<T>(member, &basis)?, period)?;
        let value = Self::apart(&late, &early).lane(0);
        let told = record.tallies().pop().unwrap_or_default();
        Ok(Tally { value, ..told })
    }
}

impl Play for Late {
    fn play<T: Scalar>(
        &self,
        _index: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        let period = |_| T::of(1.0 / RATE);
        let late = Self::close(LATE, first, stabilizer, period)?;
        let popc = Lolc::new(PortEnergy, self.limit::<T>()?);
        Ok(Self::apart(&late, &Self::close(0, first, popc, period)?))
    }

    fn basis(&self) -> Basis {
        Basis::of_hand(0.3, 1.0 / RATE, 0.1)
    }

    fn terms(&self, limit: f64) -> Terms {
        Terms::of(TICKS, limit)
    }
}

/// The same, with periods from the difference of two time stamps for the naive stabilizer.
struct Stamped(Played<Late>);

impl Trial for Stamped {
    fn ours(&self) -> Result<Runs, HardError> {
        self.0.ours()
    }

    fn under(&self, member: StabilizerName) -> Result<Runs, HardError> {
        let Self(Played(late)) = self;
        let mut runs = Runs::default();
        for first in 0..8 {
            runs.double.push(late.both::<f64>(member, first)?);
            runs.single.push(late.both::<f32>(member, first)?);
        }
        Ok(runs)
    }

    fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        self.0.with(own)
    }

    fn naive(&self) -> Result<Option<Tally>, HardError> {
        let stamp = |tick: u64| (tick as f64 / RATE) as f32;
        let period = |tick: u64| stamp(tick) - stamp(tick.saturating_sub(1));
        let late = Late::close::<f32>(LATE, 0, Naive::<f32>::default(), period)?;
        let exact = |_: u64| (1.0 / RATE) as f32;
        let early = Late::close::<f32>(0, 0, Naive::<f32>::default(), exact)?;
        let not_finite = late.iter().position(|x| !x.is_finite()).map(|tick| tick as u64);
        let value = f64::from(Late::apart(&late, &early));
        Ok(Some(Tally { value, not_finite, ..Tally::default() }))
    }
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, quantity, bound, apart, trial: Box<dyn Trial>| Case {
        name,
        theme: "time",
        hard,
        quantity,
        bound,
        apart,
        trial,
    };
    let long = Some(
        "f32 keeps its sum compensated; lanes are left out for time, their equality is shown by shorter cases",
    );
    vec![
        case(
            "1e8 ticks",
            "a sum of microjoules in f32 stops growing at 16 J: what follows is lost",
            Quantity::own("sum told / counted - 1", ""),
            1e-6,
            long,
            Box::new(Counted),
        ),
        case(
            "an hour at 10 kHz in f32",
            "3.6e7 ticks, 3600 contacts with a wall at 1 kHz: steps of 1e-7 m, works of nanojoules",
            Quantity::LATE_SWING,
            // Released at rest at -8 mm towards +8 mm, an undamped hand swings to 24 mm.
            24.0,
            long,
            Box::new(Hour),
        ),
        case(
            "time stamps after 1e9 s",
            "two stamps 1 ms apart are 0 s apart in f32, 0.95 or 1.07 ms in f64",
            Quantity { words: "late run - early run", unit: "mm", of: |tally| 1e3 * tally.value },
            1e-6,
            None,
            Box::new(Stamped(Played(Late))),
        ),
    ]
}
