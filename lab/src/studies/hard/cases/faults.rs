//! Samples that are not finite.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant, PortEnergy, PortSample, Scalar, Stabilizer,
    bodies::{Body, Impedance},
    effects::{Fallback, OnePortExt},
    environments::Wall,
};

use crate::files::scene::Basis;
use crate::files::scene::Pledge;
use crate::simulate::family::StabilizerName;
use crate::studies::hard::case::{Case, Quantity};
use crate::studies::hard::member;
use crate::studies::hard::tally::Tally;
use crate::studies::hard::terms::Terms;
use crate::studies::hard::trial::{HardError, MakeStabilizer, Play, Played, Runs, Trial};
use crate::studies::hard::watched::Watched;

pub(super) const PERIOD: f64 = 1e-3;
pub(super) const MASS: f64 = 0.2;
pub(super) const TICKS: u64 = 120;
/// Stiffness of the wall, N/m.
pub(super) const STIFFNESS: f64 = 8000.0;
/// Mass, damping and stiffness of the hand: kg, N·s/m, N/m.
const HAND: [f64; 3] = [MASS, 0.05, 50.0];

/// Hand that meets a wall of 8 kN/m at tick 10 and leaves it at about tick 26; each lane is a little slower.
pub(super) fn hand<T: Scalar>(first: usize) -> Result<Body<T>, ParameterError> {
    let [mass, damping, stiffness] = HAND.map(T::of);
    let speed = T::from_lanes(|lane| 0.1 - 0.003 * (first + lane) as f64);
    let body = Body::new(Impedance { mass, damping, stiffness }, T::of(PERIOD))?;
    Ok(body.starting(T::of(-1e-3), speed))
}

pub(super) fn wall<T: Scalar>() -> Result<Wall<T>, ParameterError> {
    Wall::new(T::of(STIFFNESS), T::of(0.5))
}

pub(super) fn limit<T: Scalar>() -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::of_mass(T::of(0.5), T::of(MASS), T::of(PERIOD))
}

/// The largest swing of the hand, m: with the energy of the start and that of one tick without the wall's force, at
/// most `v sqrt(K m)` times `v T`.
pub(super) fn reach() -> f64 {
    let [mass, _, stiffness] = HAND;
    let (start, speed) = (1e-3, 0.1);
    let energy = 0.5 * (mass * speed * speed + stiffness * start * start);
    let lost = speed * (STIFFNESS * mass).sqrt() * speed * PERIOD;
    (2.0 * (energy + lost) / stiffness).sqrt()
}

/// Fault of the sample: a field that is not finite at one tick, or from that tick on. Run `6 k + i` spoils field `i`
/// at tick `k`.
#[derive(Clone, Copy)]
struct Spoilt {
    value: f64,
    forever: bool,
    /// The credited damping of the device, N·s/m.
    credit: f64,
}

const FIELDS: u64 = 6;

impl Spoilt {
    fn spoil<T: Scalar>(&self, field: u64, sample: PortSample<T>) -> PortSample<T> {
        let bad = T::of(self.value);
        match field {
            0 => PortSample { period: bad, ..sample },
            1 => PortSample { position: bad, ..sample },
            2 => PortSample { velocity: bad, ..sample },
            3 => PortSample { displacement: bad, ..sample },
            4 => PortSample { applied: bad, ..sample },
            _ => PortSample { work: bad, ..sample },
        }
    }

    fn close<T: Scalar>(
        &self,
        index: u64,
        first: usize,
        mut port: impl OnePort<T>,
    ) -> Result<T, ParameterError> {
        let (at, field) = (index / FIELDS, index % FIELDS);
        let mut plant = hand::<T>(first)?;
        let mut sample = plant.start();
        for tick in 0..TICKS {
            let spoilt = tick == at || (self.forever && tick > at);
            let told = if spoilt { self.spoil(field, sample) } else { sample };
            sample = plant.advance(port.respond(&told));
        }
        // The plant's true position, whatever the samples said.
        Ok(sample.position.magnitude())
    }
}

impl Play for Spoilt {
    fn play<T: Scalar>(
        &self,
        index: u64,
        first: usize,
        stabilizer: impl Stabilizer<T>,
    ) -> Result<T, ParameterError> {
        self.close(index, first, wall::<T>()?.stabilized(stabilizer))
    }

    fn runs(&self) -> u64 {
        TICKS * FIELDS
    }

    fn basis(&self) -> Basis {
        Basis { damping: self.credit, ..Basis::of_hand(MASS, PERIOD, 0.1) }
    }

    fn terms(&self, limit: f64) -> Terms {
        Terms::of(TICKS, limit)
    }
}

/// The same behind a guard, which takes scalars only.
struct Guarded(Spoilt);

impl Guarded {
    fn runs_in<T: Scalar<Mask = bool>, S: Stabilizer<T> + 'static>(
        &self,
        first: usize,
        pledge: &Pledge,
        stabilizer: impl Fn() -> Result<S, HardError>,
    ) -> Result<Tally, HardError> {
        let most = limit::<T>()?.most().lane(0);
        let mut worst = Tally::default();
        for index in 0..self.0.runs() {
            let terms = Terms { pledge: pledge.clone(), ..Terms::of(TICKS, most) };
            let (watched, record) = Watched::new(stabilizer()?, terms);
            let port = wall::<T>()?.stabilized(watched).guarded(Fallback::Hold);
            let end = self.0.close(index, first, port)?;
            for mut tally in record.tallies() {
                tally.value = end.lane(0);
                worst = worst.worse(tally);
            }
        }
        Ok(worst)
    }

    /// The runs of each of four hands.
    fn in_turn<T: Scalar<Mask = bool>, S: Stabilizer<T> + 'static>(
        &self,
        pledge: &Pledge,
        stabilizer: impl Fn() -> Result<S, HardError>,
    ) -> Result<Vec<Tally>, HardError> {
        (0..4).map(|first| self.runs_in(first, pledge, &stabilizer)).collect()
    }
}

impl Trial for Guarded {
    fn ours(&self) -> Result<Runs, HardError> {
        fn popc<T: Scalar>() -> Result<Lolc<T, PortEnergy>, HardError> {
            Ok(Lolc::new(PortEnergy, limit()?))
        }
        Ok(Runs {
            double: self.in_turn::<f64, _>(&Pledge::POPC, popc)?,
            single: self.in_turn::<f32, _>(&Pledge::POPC, popc)?,
            ..Runs::default()
        })
    }

    fn under(&self, member: StabilizerName) -> Result<Runs, HardError> {
        let basis = &self.0.basis();
        let [double, single] =
            [member::pledge_of::<f64>(member, basis), member::pledge_of::<f32>(member, basis)];
        Ok(Runs {
            double: self.in_turn::<f64, _>(&double, || member::set_by::<f64>(member, basis))?,
            single: self.in_turn::<f32, _>(&single, || member::set_by::<f32>(member, basis))?,
            ..Runs::default()
        })
    }

    fn with(&self, own: MakeStabilizer<'_>) -> Result<Option<Tally>, HardError> {
        Ok(Some(self.runs_in::<f64, _>(0, &Pledge::POPC, || Ok(own()))?))
    }
}

pub(super) fn cases() -> Vec<Case> {
    let case = |name, hard, value, forever| Case {
        name,
        theme: "samples",
        hard,
        quantity: Quantity { words: "where it ends", unit: "mm", of: |tally| 1e3 * tally.value },
        bound: 1e3 * reach(),
        apart: None,
        trial: Box::new(Played(Spoilt { value, forever, credit: 0.0 })),
    };
    let guarded = Case {
        name: "NaN once, behind a guard",
        hard: "as above; the guard holds the last force and hands on what the gap was",
        apart: Some("a guard stands on one value at a time, so there are no lanes"),
        trial: Box::new(Guarded(Spoilt { value: f64::NAN, forever: false, credit: 0.0 })),
        ..case("", "", f64::NAN, false)
    };
    let credited = Case {
        trial: Box::new(Played(Spoilt { value: f64::NAN, forever: false, credit: HAND[1] })),
        ..case(
            "NaN once, with a credit",
            "a credit of NaN may not take the work of its tick with it: that debt is real",
            f64::NAN,
            false,
        )
    };
    vec![
        case(
            "NaN once",
            "in each of 6 fields of the sample, at each of 120 ticks: 720 runs",
            f64::NAN,
            false,
        ),
        case("infinity once", "likewise, +inf", f64::INFINITY, false),
        case(
            "NaN from then on",
            "a sensor that died: each field, from each tick on",
            f64::NAN,
            true,
        ),
        case("infinity from then on", "likewise, -inf", f64::NEG_INFINITY, true),
        credited,
        guarded,
    ]
}
