//! Test that the tape is the step: evaluated with numbers it has the bits of the real one.

use lyapunov_core::{
    Compensated, Correction, Dissipation, InContact, ParameterError, PortEnergy, PortSample,
    Scalar, Snapshot, Stabilizer,
};
use lyapunov_stabilizers::{
    DampingLimit, EnergyBounding, ForceBound, ForceBounding, LeastNorm, Lolc, NoStabilizer,
    Plausibility, Popc, Sharing, StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide,
    WatchdogTimes,
};
use nalgebra::SVector;

use crate::members;
use crate::seen::Seen;
use crate::symbolic::Symbolic;
use crate::tape::{self, Node};

/// Number whose bits are compared.
trait Real: Scalar<Mask = bool> {
    fn of_bits(bits: u64) -> Self;

    /// Its bits; every NaN has the same.
    fn bits(self) -> u64;
}

macro_rules! real {
    ($($real:ident $bits:ident),+) => {$(
        impl Real for $real {
            fn of_bits(bits: u64) -> Self {
                Self::from_bits(bits as $bits)
            }

            fn bits(self) -> u64 {
                if self.is_nan() { u64::MAX } else { self.to_bits().into() }
            }
        }
    )+};
}

real!(f32 u32, f64 u64);

/// Numbers by the names of the free ones: the same for the tape and for the step.
#[derive(Clone, Copy)]
struct Numbers {
    seed: u64,
}

impl Numbers {
    /// Numbers of every kind: ordinary ones, any bits, and the ends of the range.
    fn of<T: Real>(self, name: &str) -> T {
        let start = self.seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let bits = name.bytes().fold(start, |hash, byte| mixed(hash ^ u64::from(byte)));
        let ordinary = T::of((bits >> 40) as f64 / 65536.0 - 128.0);
        let signed = |size: T| if bits & 1 == 0 { size } else { -size };
        match bits >> 8 & 15 {
            0 => T::of_bits(mixed(bits)),
            1 => signed(T::smallest_normal()),
            2 => signed(T::smallest_positive()),
            3 => signed(T::of(0.0)),
            4 => signed(T::largest()),
            5 => T::of([f64::NAN, f64::INFINITY, f64::NEG_INFINITY][(bits >> 20) as usize % 3]),
            6 | 7 => ordinary * T::of(1e-9),
            _ => ordinary,
        }
    }

    /// A number that a constructor may accept; an ordinary share is below 1.
    fn parameter<T: Real>(self, name: &str) -> T {
        let most = if name == "share" { 128.0 } else { 1.0 };
        self.of::<T>(name).magnitude() / T::of(most)
    }

    fn any<T: Real>(self, name: &str) -> T {
        if PARAMETERS.contains(&name) { self.parameter(name) } else { self.of(name) }
    }
}

/// The names of parameters, none of which may be below 0.
const PARAMETERS: [&str; 19] = [
    "limit",
    "damping",
    "most",
    "threshold",
    "rate",
    "speed",
    "strongest",
    "hold",
    "rise",
    "decay",
    "c1",
    "c2",
    "start",
    "floor",
    "ceiling",
    "power",
    "share",
    "level",
    "gain",
];

/// A step of SplitMix64.
fn mixed(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}

/// The tape with numbers in the place of the free ones; truths are 1 or 0.
struct Evaluated<T>(Vec<T>);

impl<T: Real> Evaluated<T> {
    fn of(numbers: Numbers) -> Self {
        let mut values: Vec<T> = Vec::new();
        tape::with(|tape| {
            for place in tape.places() {
                let node = tape.node(place);
                let value = match node {
                    Node::Free(index) => numbers.any(&tape.names[index as usize]),
                    node => node.value(&values),
                };
                values.push(value);
            }
        });
        Self(values)
    }

    fn number(&self, place: Symbolic) -> T {
        self.0[place.0 as usize]
    }

    fn holds(&self, path: &Seen) -> bool {
        path.given.iter().all(|truth| self.0[truth.0 as usize] == T::of(1.0))
    }
}

/// Memory spelled by numbers, under the names that `fresh` gives to symbols.
trait Spelled<T> {
    fn spelled(numbers: Numbers, name: &str) -> Self;
}

impl<T> Spelled<T> for () {
    fn spelled(_numbers: Numbers, _name: &str) {}
}

impl<T: Real> Spelled<T> for T {
    fn spelled(numbers: Numbers, name: &str) -> Self {
        numbers.any(name)
    }
}

impl<T: Real, const N: usize> Spelled<T> for SVector<T, N> {
    fn spelled(numbers: Numbers, name: &str) -> Self {
        Self::from_fn(|axis, _| numbers.any(&format!("{name}.{axis}")))
    }
}

macro_rules! tuple {
    ($($of:ident $index:tt),+) => {
        impl<T, $($of: Spelled<T>),+> Spelled<T> for ($($of,)+) {
            fn spelled(numbers: Numbers, name: &str) -> Self {
                ($($of::spelled(numbers, &format!("{name}.{}", $index)),)+)
            }
        }
    };
}

tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);

/// The real step of a member; none where its constructor or its memory's check refuses a number.
fn step<T, S>(numbers: Numbers, made: Result<S, ParameterError>) -> Option<Correction<T>>
where
    T: Real,
    S: Stabilizer<T> + Snapshot<State: Spelled<T>>,
{
    let made = made.ok()?;
    let mut member = made.restored(S::State::spelled(numbers, "memory")).ok()?;
    let of = |name| numbers.any(name);
    let sample = PortSample {
        period: of("period"),
        position: of("position"),
        velocity: of("velocity"),
        displacement: of("displacement"),
        applied: of("applied"),
        work: of("work"),
    };
    Some(member.stabilize(&sample, of("effort")))
}

fn limit<T: Real>(numbers: Numbers) -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::at(numbers.any("limit"))
}

fn popc<T: Real>(numbers: Numbers) -> Result<Popc<T>, ParameterError> {
    Ok(Popc::new(PortEnergy, limit(numbers)?))
}

type Step<T> = fn(Numbers) -> Option<Correction<T>>;

/// The members of `members::on_one_axis` whose memory is numbers only.
fn steps<T: Real>() -> Vec<(&'static str, Step<T>)> {
    let mut steps = damping::<T>();
    steps.extend(shaping::<T>());
    steps.extend(bounding::<T>());
    steps
}

fn damping<T: Real>() -> Vec<(&'static str, Step<T>)> {
    fn credited<T: Real>(of: Numbers) -> Result<(PortEnergy, Dissipation<T>), ParameterError> {
        Ok((PortEnergy, Dissipation::of(of.any("damping"))?))
    }
    fn lolc<T: Real>(of: Numbers) -> Result<Lolc<T, (PortEnergy, Dissipation<T>)>, ParameterError> {
        Ok(Lolc::new(credited(of)?, limit(of)?))
    }
    vec![
        ("none", |of| step(of, Ok(NoStabilizer))),
        ("popc", |of| step(of, popc::<T>(of))),
        ("popc-sampled", |of| step(of, popc::<T>(of).map(Lolc::sampled))),
        ("popc-compensated", |of| {
            step(of, popc::<T>(of).map(|it| it.summed_in::<Compensated<T>>()))
        }),
        ("lolc", |of| step(of, lolc::<T>(of))),
        ("lolc-sampled", |of| step(of, lolc::<T>(of).map(Lolc::sampled))),
        ("least-norm", |of| {
            let made =
                limit::<T>(of).and_then(|it| LeastNorm::new(PortEnergy, it, of.any("decay")));
            step(of, made)
        }),
    ]
}

fn shaping<T: Real>() -> Vec<(&'static str, Step<T>)> {
    vec![
        ("popc-contact-reset", |of| {
            let contact = InContact { position: of.any::<T>("surface") };
            step(of, popc::<T>(of).map(|it| it.reset_at(contact)))
        }),
        ("popc-bounded", |of| step(of, popc::<T>(of).and_then(|it| it.bounded(of.any("most"))))),
        ("popc-threshold", |of| {
            step(of, popc::<T>(of).and_then(|it| it.above_velocity(of.any("threshold"))))
        }),
        ("popc-spread", |of| step(of, popc::<T>(of).and_then(|it| it.spread_over(5)))),
        ("popc-rate-limited", |of| {
            step(of, popc::<T>(of).and_then(|it| it.rate_limited::<T>(of.any("rate"))))
        }),
        ("popc-rising", |of| step(of, popc::<T>(of).and_then(|it| it.rising_over(5)))),
        ("popc-plausible", |of| {
            let limits = Plausibility { speed: of.any("speed"), effort: of.any("strongest") };
            step(of, popc::<T>(of).and_then(|it| it.plausible(limits)))
        }),
        ("popc-watched", |of| {
            let times = WatchdogTimes { hold: of.any("hold"), rise: of.any("rise") };
            step(of, popc::<T>(of).and_then(|it| it.watched::<T>(times)))
        }),
    ]
}

fn bounding<T: Real>() -> Vec<(&'static str, Step<T>)> {
    vec![
        ("two-port", |of| step(of, limit::<T>(of).map(TwoPortSide::new))),
        ("two-layer", |of| {
            let sharing = Sharing { start: T::of(0.0), share: of.any("share") };
            step(of, TwoLayer::master(sharing, of.any("level"), of.any("gain")))
        }),
        ("force-bound", |of| step(of, ForceBound::<T>::new(of.any("damping")))),
        ("force-bounding", |of| {
            let made: Result<ForceBounding<T>, _> = ForceBounding::of_damping(of.any("damping"));
            step(of, made)
        }),
        ("tank", |of| {
            let [start, floor, ceiling, power] =
                ["start", "floor", "ceiling", "power"].map(|it| of.any::<T>(it));
            step(of, Tank::new(PortEnergy, TankLimits { start, floor, ceiling, power }))
        }),
        ("energy-bounding", |of| step(of, EnergyBounding::<T>::new(of.any("c1"), of.any("c2")))),
    ]
}

/// Random numbers of each member.
const RUNS: u64 = 4000;

/// How many of the numbers a step took, or the first seed on which the tape tells something else.
fn compared<T: Real>(seen: &[Seen], step: Step<T>) -> Result<u64, String> {
    let mut stepped = 0;
    for seed in 0..RUNS {
        let numbers = Numbers { seed };
        let Some(real) = step(numbers) else { continue };
        let evaluated = Evaluated::<T>::of(numbers);
        let taken: Vec<&Seen> = seen.iter().filter(|path| evaluated.holds(path)).collect();
        let path = match taken[..] {
            [path] => path,
            // A memory that is not what a step leaves, though its own check accepts it: docs/proofs.md.
            [] => continue,
            _ => return Err(format!("seed {seed}: {} paths", taken.len())),
        };
        stepped += 1;
        let told = [path.effort[0], path.sum, path.alpha, path.shortfall];
        let told = told.map(|it| evaluated.number(it));
        let given = [real.effort, real.observed_energy, real.alpha, real.shortfall];
        let accepted = evaluated.0[path.accepted.0 as usize] == T::of(1.0);
        if told.map(T::bits) != given.map(T::bits) || accepted != real.accepted {
            return Err(format!("seed {seed}: {told:?}, {real:?}"));
        }
    }
    Ok(stepped)
}

fn tape_is_the_step<T: Real>() {
    for (name, step) in steps::<T>() {
        let members = members::on_one_axis();
        let member = members.iter().find(|it| it.name == name).expect(name);
        tape::clear();
        let stepped = compared(&(member.seen)(), step);
        assert!(stepped.as_ref().is_ok_and(|it| *it > RUNS / 20), "{name}: {stepped:?}");
    }
}

/// The same comparison tells the mutants of the solvers apart.
#[test]
fn another_step_is_noticed() {
    let members = members::on_one_axis();
    let popc = members.iter().find(|it| it.name == "popc").expect("it is there");
    for (name, mutant) in tape::Mutant::ALL {
        tape::clear();
        tape::mutate(Some(mutant));
        let seen = (popc.seen)();
        tape::mutate(None);
        let compared = compared::<f64>(&seen, |of| step(of, self::popc(of)));
        assert!(compared.is_err(), "{name}: {compared:?}");
    }
}

#[test]
fn the_tape_in_f64_is_the_real_step() {
    tape_is_the_step::<f64>();
}

#[test]
fn the_tape_in_f32_is_the_real_step() {
    tape_is_the_step::<f32>();
}
