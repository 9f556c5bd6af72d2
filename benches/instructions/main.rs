//! Instructions per tick of loops composed by type, against the same loops written by hand, and the bytes of both: an
//! absent effect must cost nothing. Fails where a ratio is above [`MARK`], or where bytes or positions differ. Then what each
//! part around a stabilizer adds; fails where docs/telemetry.md has other numbers of the same compiler.
//!
//! `cargo bench -p lyapunov-instructions`. `valgrind --tool=callgrind` counts the instructions, the same on every run;
//! without valgrind the benchmark prints SKIPPED.

mod features;
mod hand;
mod numbers;
mod typed;

use std::env;
use std::hint::black_box;
use std::process::{Command, ExitCode};

/// Largest allowed ratio of instructions: loop composed by type over loop by hand.
const MARK: f64 = 1.02;

/// Lengths of two runs; the difference of their instructions is that of their ticks.
const TICKS: [usize; 2] = [2_000, 12_000];

/// Loop in its two forms, and the bytes of each.
struct Contest {
    name: &'static str,
    hand: fn(usize) -> Vec<f64>,
    typed: fn(usize) -> Vec<f64>,
    bytes: [usize; 2],
}

macro_rules! contest {
    ($name:expr, $real:ty, $run:ident, $hand:expr, $typed:expr) => {
        Contest {
            name: $name,
            hand: |ticks| {
                let mut positions: Vec<$real> = vec![0.0; ticks];
                black_box(&mut $hand).$run(black_box(&mut positions));
                positions.into_iter().map(f64::from).collect()
            },
            typed: |ticks| {
                let mut positions: Vec<$real> = vec![0.0; ticks];
                black_box(&mut $typed.expect("the numbers")).$run(black_box(&mut positions));
                positions.into_iter().map(f64::from).collect()
            },
            bytes: [size_of_val(&$hand), size_of_val(&$typed.expect("the numbers"))],
        }
    };
}

/// Contests of one scalar: with and without a stabilizer on a state that is kept; with one on a state that is dropped
/// with the run; with one that credits a damper; without one on a body that is integrated by steps; with the two
/// that limit the force; and one that is told readings.
macro_rules! contests {
    ($real:ident) => {{
        use hand::$real::{Credited, Integrated, Limited, Own, Plain, Stabilized, Tanked};
        use typed::{credited, integrated, limited, own, plain, stabilized, tanked};
        [
            contest!(
                concat!("stabilized/", stringify!($real)),
                $real,
                run,
                Stabilized::new(),
                stabilized::<$real>()
            ),
            contest!(
                concat!("rollout/", stringify!($real)),
                $real,
                roll,
                Stabilized::new(),
                stabilized::<$real>()
            ),
            contest!(
                concat!("lolc/", stringify!($real)),
                $real,
                run,
                Credited::new(),
                credited::<$real>()
            ),
            contest!(
                concat!("plain/", stringify!($real)),
                $real,
                run,
                Plain::new(),
                plain::<$real>()
            ),
            contest!(
                concat!("runge-kutta-4/", stringify!($real)),
                $real,
                run,
                Integrated::new(),
                integrated::<$real>()
            ),
            contest!(
                concat!("force-bound/", stringify!($real)),
                $real,
                run,
                Limited::new(),
                limited::<$real>()
            ),
            contest!(
                concat!("tank/", stringify!($real)),
                $real,
                run,
                Tanked::new(),
                tanked::<$real>()
            ),
            contest!(
                concat!("readings/", stringify!($real)),
                $real,
                run,
                Own::new(),
                own::<$real>()
            ),
        ]
    }};
}

fn contests() -> impl Iterator<Item = Contest> {
    contests!(f64).into_iter().chain(contests!(f32))
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [name, side, ticks] = &arguments[..] {
        let ticks: usize = ticks.parse().expect("a number of ticks");
        if let Some(feature) = features::features().into_iter().find(|it| it.name == name) {
            black_box(feature.runs[usize::from(side == "f32")](ticks));
            return ExitCode::SUCCESS;
        }
        let contest = contests().find(|it| it.name == name).expect("a contest");
        let run = if side == "hand" { contest.hand } else { contest.typed };
        black_box(run(ticks));
        return ExitCode::SUCCESS;
    }
    let counting = Command::new("valgrind").arg("--version").output().is_ok();
    if !counting {
        println!("SKIPPED: instructions are not counted, for valgrind cannot be run here");
    }
    let mut fair = true;
    for contest in contests() {
        fair &= same(&contest);
        if counting {
            fair &= counted(&contest);
        }
    }
    fair &= features::alike(TICKS[0]);
    if counting {
        fair &= features::told(per_tick);
    }
    if fair { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Whether both sides compute the same and keep as many bytes.
fn same(contest: &Contest) -> bool {
    let alike = (contest.hand)(TICKS[0]) == (contest.typed)(TICKS[0]);
    let [hand, typed] = contest.bytes;
    println!("{:<18} {typed} bytes, by hand {hand}", contest.name);
    if !alike {
        println!("{:<18} FAILED: the two forms move differently", contest.name);
    }
    if hand != typed {
        println!("{:<18} FAILED: the bytes differ", contest.name);
    }
    alike && hand == typed
}

/// Whether the instructions are within the mark.
fn counted(contest: &Contest) -> bool {
    let [hand, typed] = ["hand", "typed"].map(|side| per_tick(contest.name, side));
    let ratio = typed / hand;
    println!("{:<18} {typed:.2} instructions a tick, by hand {hand:.2}: {ratio:.3}", contest.name);
    if ratio > MARK {
        println!("{:<18} FAILED: more than {MARK} times those by hand", contest.name);
    }
    ratio <= MARK
}

fn per_tick(name: &str, side: &str) -> f64 {
    let [short, long] = TICKS.map(|ticks| instructions(name, side, ticks));
    (long - short) / (TICKS[1] - TICKS[0]) as f64
}

/// The instructions of a whole run, by callgrind.
fn instructions(name: &str, side: &str, ticks: usize) -> f64 {
    let own = env::current_exe().expect("the path of this program");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(own)
        .args([name, side, &ticks.to_string()])
        .output()
        .expect("valgrind runs");
    let told = String::from_utf8_lossy(&output.stderr);
    let count = told.lines().find_map(|line| line.split_once("Collected : "));
    let count = count.and_then(|(_, count)| count.trim().parse().ok());
    count.unwrap_or_else(|| panic!("valgrind tells no count:\n{told}"))
}
