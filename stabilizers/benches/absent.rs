//! Instructions per tick of one loop in two builds: without any feature, and with all. Absent features cost nothing, and present
//! ones nothing in the step, so the counts must be equal; fails where they are not.
//!
//! `cargo bench -p lyapunov-stabilizers --bench absent`. The build without features runs the other one. `valgrind` counts;
//! without it the benchmark prints SKIPPED.

use std::env;
use std::hint::black_box;
use std::process::{Command, ExitCode};

use lyapunov_core::{
    ParameterError, PortEnergy, Reading, Readings, Scalar, Stabilizer,
    telemetry::{EnergyMeter, TickRing},
};
use lyapunov_stabilizers::{DampingLimit, Popc, StabilizerExt, WatchdogTimes};

/// Lengths of two runs; the difference of their instructions is that of their ticks. So long that the hundred or so in which the
/// rest of two processes differs do not show.
const TICKS: [usize; 2] = [2_000, 202_000];

/// All that a loop of one's own may have in its step: readings, a watched stabilizer, a meter, a ring.
#[inline(never)]
fn run<T: Scalar>(ticks: usize) -> Result<T, ParameterError> {
    let of = |number: f64| black_box(T::of(number));
    let mut readings = Readings::<T>::every(of(1e-3))?.no_faster_than(of(20.0))?;
    let times = WatchdogTimes { hold: of(5e-3), rise: of(20e-3) };
    let popc = Popc::new(PortEnergy, DampingLimit::at(of(150.0))?);
    let mut dog = popc.watched::<T>(times)?;
    let (mut meter, mut ring) = black_box((EnergyMeter::new(), TickRing::<T, 64>::new()));
    let (period, mass, stiffness) = (of(1e-3), of(0.3), of(8e3));
    let (mut position, mut velocity, mut applied) = (of(-4e-3), of(0.4), T::of(0.0));
    for _ in 0..ticks {
        let sample = readings.read(Reading { position, applied }).sample;
        let wall = stiffness * sample.position.larger(T::of(0.0));
        let correction = dog.stabilize(&sample, wall);
        meter.add(&sample, &correction);
        ring.push(&sample, &correction);
        applied = correction.effort;
        velocity -= (applied + of(50.0) * position) * period / mass;
        position += velocity * period;
    }
    black_box((meter, ring));
    Ok(position)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).filter(|it| it != "--bench").collect();
    match &arguments[..] {
        [scalar, ticks] => {
            let ticks = ticks.parse().expect("a number of ticks");
            let end = match scalar.as_str() {
                "f32" => run::<f32>(ticks).map(f64::from),
                _ => run::<f64>(ticks),
            };
            println!("ends at {:e}", end.expect("the numbers"));
            ExitCode::SUCCESS
        }
        [only] if only == "count" => {
            counts().into_iter().for_each(|line| println!("{line}"));
            ExitCode::SUCCESS
        }
        _ if Command::new("valgrind").arg("--version").output().is_err() => {
            println!("SKIPPED: instructions are not counted, for valgrind cannot be run here");
            ExitCode::SUCCESS
        }
        _ => compared(),
    }
}

/// Whether both builds take as many instructions.
fn compared() -> ExitCode {
    let without = counts();
    let cargo = env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let all = ["bench", "-q", "-p", "lyapunov-stabilizers", "--bench", "absent", "--all-features"];
    let output = Command::new(cargo).args(all).args(["--", "count"]).output().expect("cargo runs");
    let told = String::from_utf8_lossy(&output.stdout);
    let with: Vec<&str> = told.lines().filter(|line| line.contains("a tick")).collect();
    println!("without features: {}\nwith all:         {}", without.join("; "), with.join("; "));
    if with == without {
        return ExitCode::SUCCESS;
    }
    println!("FAILED: the counts differ\n{}", String::from_utf8_lossy(&output.stderr));
    ExitCode::FAILURE
}

fn counts() -> Vec<String> {
    ["f64", "f32"]
        .map(|scalar| {
            let [short, long] = TICKS.map(|ticks| instructions(scalar, ticks));
            let ticks = (TICKS[1] - TICKS[0]) as f64;
            format!("{scalar}: {:.2} instructions a tick", (long - short) / ticks)
        })
        .into()
}

/// The instructions of a whole run, by callgrind.
fn instructions(scalar: &str, ticks: usize) -> f64 {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(env::current_exe().expect("the path of this program"))
        .args([scalar, &ticks.to_string()])
        .output()
        .expect("valgrind runs");
    let told = String::from_utf8_lossy(&output.stderr);
    let count = told.lines().find_map(|line| line.split_once("Collected : "));
    let count = count.and_then(|(_, count)| count.trim().parse().ok());
    count.unwrap_or_else(|| panic!("valgrind tells no count:\n{told}"))
}
