//! A servo loop at 1 and 10 kHz on a thread of real-time priority: percentiles of a step and of the wake-up, beside a loop
//! without a stabilizer; no allocation after the start; and the time of a step for inputs of every kind.
//!
//! `cargo run --release --example realtime [TICKS]`, 20,000 ticks of each loop if it is not said. It ends with status 1 where
//! a loop allocates.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use lyapunov::stabilizers::{Plausibility, StabilizerExt, WatchdogTimes};
use lyapunov::{
    DampingLimit, HeldTick, ParameterError, Popc, PortEnergy, PortSample, Reading, Readings,
    Stabilizer,
};
use thread_priority::ThreadPriority;

const STIFFNESS: f64 = 800.0; // N/m
const PLAUSIBLE: Plausibility<f64> = Plausibility { speed: 10.0, effort: 100.0 }; // m/s, N

/// Times of every tick, ns.
struct Times {
    wake: Vec<u32>,
    step: Vec<u32>,
}

fn main() -> ExitCode {
    let ticks = std::env::args().nth(1).map_or(Ok(20_000), |ticks| ticks.parse());
    let Ok(ticks @ 1..) = ticks else {
        eprintln!("TICKS is a whole number from 1 on");
        return ExitCode::from(2);
    };
    match set_priority() {
        Ok(()) => println!("real-time priority: SCHED_FIFO"),
        Err(why) => println!("SKIPPED: real-time priority is refused here: {why}"),
    }
    match report(ticks) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(count) => {
            eprintln!("{count} allocations after the start");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(unix)]
fn set_priority() -> Result<(), String> {
    use thread_priority::{
        RealtimeThreadSchedulePolicy, ThreadSchedulePolicy, set_thread_priority_and_policy,
        thread_native_id,
    };
    let priority = ThreadPriority::Crossplatform(80_u8.try_into()?);
    let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    set_thread_priority_and_policy(thread_native_id(), priority, policy)
        .map_err(|error| format!("{error:?}"))
}

#[cfg(not(unix))]
fn set_priority() -> Result<(), String> {
    thread_priority::set_current_thread_priority(ThreadPriority::Max)
        .map_err(|error| format!("{error:?}"))
}

/// Prints everything; the number of allocations in the loops.
fn report(ticks: usize) -> Result<u64, ParameterError> {
    println!("{ticks} ticks each, µs");
    println!(
        "{:34}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}",
        "", "50 %", "90 %", "99 %", "99.9 %", "99.99 %", "most"
    );
    let mut allocations = 0;
    for rate in [1_000.0, 10_000.0] {
        let limit = DampingLimit::of_mass(0.5, 0.2, 1.0 / rate)?;
        let times = WatchdogTimes { hold: 5.0 / rate, rise: 0.1 };
        let mut readings = Readings::every(1.0 / rate)?.no_faster_than(10.0)?;
        let mut popc = Popc::new(PortEnergy, limit).plausible(PLAUSIBLE)?.watched(times)?;
        let stabilized = |position: f64, applied: f64| {
            let sample = readings.read(Reading { position, applied }).sample;
            popc.stabilize(&sample, STIFFNESS * sample.position).effort
        };
        allocations += run("with a stabilizer", rate, ticks, stabilized);
        allocations += run("without", rate, ticks, |position, _| STIFFNESS * position);
    }
    println!("allocations after the start: {allocations}");
    mixes()?;
    Ok(allocations)
}

/// One loop; the number of its allocations.
fn run(name: &str, rate: f64, ticks: usize, step: impl FnMut(f64, f64) -> f64) -> u64 {
    let mut times = Times { wake: vec![0; ticks], step: vec![0; ticks] };
    let counted = allocation_counter::measure(|| servo(rate, &mut times, step));
    for (what, mut times) in [("wake-up", times.wake), ("step", times.step)] {
        times.sort_unstable();
        let at = |share: f64| f64::from(times[((ticks - 1) as f64 * share).round() as usize]) / 1e3;
        print!("{:34}", format!("{:2} kHz, {name}, {what}", rate / 1e3));
        for share in [0.5, 0.9, 0.99, 0.999, 0.9999, 1.0] {
            print!("{:10.2}", at(share));
        }
        println!();
    }
    counted.count_total
}

/// The loop itself: sleep, read, step, command. Your device is in the place of the sine.
fn servo(rate: f64, times: &mut Times, mut step: impl FnMut(f64, f64) -> f64) {
    let period = Duration::from_secs_f64(1.0 / rate);
    let (mut due, mut effort) = (Instant::now(), 0.0);
    for (tick, (wake, took)) in times.wake.iter_mut().zip(&mut times.step).enumerate() {
        due += period;
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        let start = Instant::now();
        let position = 0.01 * (tick as f64 * 20.0 / rate).sin();
        effort = step(black_box(position), black_box(effort));
        *took = nanoseconds(start.elapsed());
        *wake = nanoseconds(start.saturating_duration_since(due));
        // A tick that was missed altogether is not made up for.
        due = due.max(start);
    }
    black_box(effort);
}

fn nanoseconds(time: Duration) -> u32 {
    time.as_nanos().try_into().unwrap_or(u32::MAX)
}

/// Prints the time of a step for inputs of each kind, of POPC by itself and of plausible samples only.
fn mixes() -> Result<(), ParameterError> {
    let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
    mixed("POPC", popc);
    mixed("POPC that sees plausible samples only", popc.plausible(PLAUSIBLE)?);
    Ok(())
}

/// The fastest of many rounds of each kind.
fn mixed<S: Stabilizer<f64> + Copy>(name: &str, stabilizer: S) {
    let tick = |velocity: f64, displacement: f64, applied: f64| {
        let position = velocity;
        HeldTick { period: 1e-3, position, velocity, displacement, applied }.sample()
    };
    let tiny = 5e-324;
    let short = PortSample { period: tiny, ..tick(0.1, 0.0, 2.0) };
    let kinds = [
        ("ordinary, absorbing", tick(0.1, 1e-4, 2.0), 1.0),
        ("a debt beyond the limit", tick(0.1, 1e-4, -90.0), 1.0),
        ("an absurd debt", tick(0.1, 1e-4, -2e3), 1.0),
        ("as large as can be, infinite work", tick(f64::MAX, 1e-3 * f64::MAX, f64::MAX), f64::MAX),
        ("NaN", tick(f64::NAN, f64::NAN, f64::NAN), f64::NAN),
        ("subnormal velocity", tick(tiny, 1e-4, 2.0), 1.0),
        ("subnormal work", tick(0.1, tiny, 2.0), 1.0),
        ("subnormal period", short, 1.0),
        ("all subnormal", PortSample { period: tiny, ..tick(tiny, tiny, tiny) }, tiny),
    ];
    let mut fastest = kinds.map(|_| f64::INFINITY);
    for _ in 0..400 {
        for ((_, sample, effort), fastest) in kinds.iter().zip(&mut fastest) {
            let (mut stabilizer, rounds) = (stabilizer, 1000);
            let start = Instant::now();
            for _ in 0..rounds {
                black_box(stabilizer.stabilize(black_box(sample), black_box(*effort)));
            }
            *fastest = (1e9 / f64::from(rounds) * start.elapsed().as_secs_f64()).min(*fastest);
        }
    }
    let least = fastest.into_iter().fold(f64::INFINITY, f64::min);
    println!("a step of {name} by inputs, fastest of 400 rounds");
    for ((kind, ..), time) in kinds.iter().zip(fastest) {
        println!("  {kind:36}{time:8.2} ns, {:.3} of the fastest", time / least);
    }
}
