//! What each part around a stabilizer costs: the same loop with one part more in each row, and the table of the page on
//! telemetry, which must say so.

use std::hint::black_box;
use std::process::Command;

use lyapunov::{
    DampingLimit, HeldTick, OnePort, ParameterError, Plant, Popc, PortEnergy, PortSample, Reading,
    Readings, Scalar, Stabilizer,
    bodies::{Body, Impedance},
    effects::{Fallback, OnePortExt},
    environments::Wall,
    stabilizers::{StabilizerExt, Watchdog, WatchdogTimes},
    telemetry::{EnergyMeter, TickRing},
};

use super::numbers::{
    DAMPING, DEVICE_DAMPING, DEVICE_MASS, FASTEST, MOST, OPERATOR_STIFFNESS, PERIOD, START,
    STIFFNESS,
};

/// The page that holds the table.
const PAGE: &str = include_str!("../../docs/telemetry.md");

/// A loop of both scalars, and what it is made of. It returns where the device ends.
pub(crate) struct Feature {
    pub(crate) name: &'static str,
    about: &'static str,
    pub(crate) runs: [fn(usize) -> f64; 2],
}

pub(crate) fn features() -> [Feature; 8] {
    macro_rules! feature {
        ($name:ident, $about:expr) => {
            Feature {
                name: stringify!($name),
                about: $about,
                runs: [
                    |ticks| $name::<f64>(ticks).expect("the numbers"),
                    |ticks| $name::<f32>(ticks).expect("the numbers"),
                ],
            }
        };
    }
    [
        feature!(by_hand, "`Popc` and a wall; last position and effort kept by hand, unchecked"),
        feature!(guarded, "by hand, and a `Guard` before wall and stabilizer"),
        feature!(read, "`Readings` in place of the hand"),
        feature!(limited, "`Readings` with `no_faster_than`"),
        feature!(watched, "… and a `Watchdog` that holds and ramps"),
        feature!(metered, "… and an `EnergyMeter`, without a watchdog"),
        feature!(recorded, "… and a `TickRing` of 64, without watchdog and meter"),
        feature!(everything, "… and all three"),
    ]
}

/// A device that is told an effort and tells where it is.
fn closed<T: Scalar>(ticks: usize, mut tick: impl FnMut(T, T) -> T) -> Result<f64, ParameterError> {
    let hand = Impedance {
        mass: T::of(DEVICE_MASS),
        damping: T::of(DEVICE_DAMPING),
        stiffness: T::of(OPERATOR_STIFFNESS),
    };
    let mut body = Body::new(hand, T::of(PERIOD))?.starting(T::of(START), T::of(0.0));
    let mut position = body.start().position;
    let mut applied = T::of(0.0);
    for _ in 0..ticks {
        applied = tick(position, applied);
        position = body.advance(applied).position;
    }
    Ok(position.lane(0))
}

fn wall<T: Scalar>() -> Result<Wall<T>, ParameterError> {
    Wall::new(black_box(T::of(STIFFNESS)), black_box(T::of(DAMPING)))
}

fn popc<T: Scalar>() -> Result<Popc<T>, ParameterError> {
    Ok(Popc::new(PortEnergy, DampingLimit::at(black_box(T::of(MOST)))?))
}

fn readings<T: Scalar>() -> Result<Readings<T>, ParameterError> {
    Readings::every(black_box(T::of(PERIOD)))
}

fn believed<T: Scalar>() -> Result<Readings<T>, ParameterError> {
    readings()?.no_faster_than(black_box(T::of(FASTEST)))
}

fn dog<T: Scalar>() -> Result<Watchdog<Popc<T>, T>, ParameterError> {
    let [hold, rise] = [5.0 * PERIOD, 20.0 * PERIOD].map(|time| black_box(T::of(time)));
    popc()?.watched(WatchdogTimes { hold, rise })
}

/// The sample that one makes in a line, with the last position.
#[inline(always)]
fn sample<T: Scalar>(period: T, last: &mut T, position: T, applied: T) -> PortSample<T> {
    let displacement = position - *last;
    *last = position;
    HeldTick { period, position, velocity: displacement / period, displacement, applied }.sample()
}

#[inline(never)]
fn by_hand<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut port, period) = (wall()?.stabilized(popc()?), black_box(T::of(PERIOD)));
    let mut last = T::of(START);
    closed(ticks, |position, applied| port.respond(&sample(period, &mut last, position, applied)))
}

/// Of one scalar at a time: a guard stands on no lanes.
trait Real: Scalar<Mask = bool> {}
impl<T: Scalar<Mask = bool>> Real for T {}

#[inline(never)]
fn guarded<T: Real>(ticks: usize) -> Result<f64, ParameterError> {
    let port = wall()?.stabilized(popc()?);
    let (mut port, period) = (port.guarded(Fallback::Hold), black_box(T::of(PERIOD)));
    let mut last = T::of(START);
    closed(ticks, |position, applied| port.respond(&sample(period, &mut last, position, applied)))
}

#[inline(never)]
fn read<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut port, mut readings) = (wall()?.stabilized(popc()?), readings::<T>()?);
    closed(ticks, |position, applied| {
        port.respond(&readings.read(Reading { position, applied }).sample)
    })
}

#[inline(never)]
fn limited<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut port, mut readings) = (wall()?.stabilized(popc()?), believed::<T>()?);
    closed(ticks, |position, applied| {
        port.respond(&readings.read(Reading { position, applied }).sample)
    })
}

#[inline(never)]
fn watched<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut port, mut readings) = (wall()?.stabilized(dog()?), believed::<T>()?);
    closed(ticks, |position, applied| {
        port.respond(&readings.read(Reading { position, applied }).sample)
    })
}

#[inline(never)]
fn metered<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut wall, mut popc, mut readings) = (wall()?, popc()?, believed::<T>()?);
    let mut meter = black_box(EnergyMeter::new());
    let end = closed(ticks, |position, applied| {
        let sample = readings.read(Reading { position, applied }).sample;
        let correction = popc.stabilize(&sample, wall.respond(&sample));
        meter.add(&sample, &correction);
        correction.effort
    });
    black_box(meter);
    end
}

#[inline(never)]
fn recorded<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut wall, mut popc, mut readings) = (wall()?, popc()?, believed::<T>()?);
    let mut ring = black_box(TickRing::<T, 64>::new());
    let end = closed(ticks, |position, applied| {
        let sample = readings.read(Reading { position, applied }).sample;
        let correction = popc.stabilize(&sample, wall.respond(&sample));
        ring.push(&sample, &correction);
        correction.effort
    });
    black_box(ring);
    end
}

#[inline(never)]
fn everything<T: Scalar>(ticks: usize) -> Result<f64, ParameterError> {
    let (mut wall, mut dog, mut readings) = (wall()?, dog()?, believed::<T>()?);
    let (mut meter, mut ring) = black_box((EnergyMeter::new(), TickRing::<T, 64>::new()));
    let end = closed(ticks, |position, applied| {
        let sample = readings.read(Reading { position, applied }).sample;
        let correction = dog.stabilize(&sample, wall.respond(&sample));
        meter.add(&sample, &correction);
        ring.push(&sample, &correction);
        correction.effort
    });
    black_box((meter, ring));
    end
}

/// Whether those without a ramp move alike: they differ in what they check and record.
pub(crate) fn alike(ticks: usize) -> bool {
    let ramped = |name: &str| ["watched", "everything"].contains(&name);
    let plain = || features().into_iter().filter(|feature| !ramped(feature.name));
    let same = |scalar: usize| {
        let ends: Vec<f64> = plain().map(|feature| (feature.runs[scalar])(ticks)).collect();
        ends.iter().all(|end| end.to_bits() == ends[0].to_bits())
    };
    let alike = same(0) && same(1);
    if !alike {
        println!("features           FAILED: they move differently");
    }
    alike
}

/// Prints the table; whether the page has it, if that was made by this compiler.
pub(crate) fn told(per_tick: impl Fn(&str, &str) -> f64) -> bool {
    let compiler = Command::new("rustc").arg("--version").output().map(|it| it.stdout);
    let compiler = String::from_utf8(compiler.unwrap_or_default()).expect("a version");
    let name: Vec<&str> = compiler.split(' ').take(2).collect();
    let made_by = format!("by {}", name.join(" "));
    let mut first = None;
    let mut told = true;
    println!("\ninstructions a tick, {made_by}:\n\n| a tick of | `f64` | more | `f32` | more |");
    println!("|---|---|---|---|---|");
    for feature in features() {
        let counts = ["f64", "f32"].map(|scalar| per_tick(feature.name, scalar));
        let [wide, narrow] = *first.get_or_insert(counts);
        let more = |count: f64, without: f64| format!("{count:.1} | {:+.1}", count - without);
        let [wide, narrow] = [more(counts[0], wide), more(counts[1], narrow)];
        let row = format!("| {} | {wide} | {narrow} |", feature.about);
        println!("{row}");
        told &= PAGE.contains(&row);
    }
    if !PAGE.contains(&made_by) {
        println!("\nnot compared: the table of docs/telemetry.md is not {made_by}");
        return true;
    }
    if !told {
        println!("\nFAILED: the table of docs/telemetry.md is another one");
    }
    told
}
