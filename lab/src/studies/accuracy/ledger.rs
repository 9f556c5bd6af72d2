//! Precision of ledgers, and its cost.

use std::hint::black_box;
use std::time::Instant;

use lyapunov::{
    DampingLimit, HeldTick, Lolc, ParameterError, PortEnergy, PortSample, Scalar, Stabilizer,
    accumulators::{Accumulator, Compensated, DoubleDouble, Plain, Wide},
};

use super::AccuracyError;
use super::timing::Time;
use super::trace::Progress;
use crate::measure::timing::Rounds;

/// Ticks of 1 ms in total.
pub(super) const TICKS: u32 = 10_000_000;

/// Ticks after which the motion repeats: thirteen swings of about 3 Hz.
const BLOCK: u32 = 4000;

const SWINGS: f64 = 13.0;

/// Rounds over all ledgers.
const ROUNDS: usize = 31;

/// Ticks of a lap.
const LAP: usize = 5 * BLOCK as usize;

/// The result of one ledger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LedgerRow {
    /// The scalar of the port.
    pub scalar: &'static str,
    /// The type it sums in, as a scene names it.
    pub ledger: &'static str,
    /// The error of the sum after all ticks, J.
    pub error: f64,
    /// The time of a step of POPC with this ledger.
    pub time: Time,
}

/// Hand that a damper of 0.5 N·s/m brakes, swinging at 0.1 m/s at most.
struct Motion {
    /// Forces and displacements of one block.
    samples: Vec<(f64, f64)>,
}

impl Motion {
    fn new() -> Self {
        let sample_at = |tick: u32| {
            let turn = f64::from(tick) * SWINGS / f64::from(BLOCK);
            // A parabola for each half swing, signs alternating: a sine would differ from machine to machine.
            let (half, part) = ((2.0 * turn).floor(), (2.0 * turn).fract());
            let sign = if half % 2.0 == 0.0 { 0.1 } else { -0.1 };
            let velocity = sign * 4.0 * part * (1.0 - part);
            (0.5 * velocity, 1e-3 * velocity)
        };
        Self { samples: (0..BLOCK).map(sample_at).collect() }
    }

    /// The energy that the damper takes in all ticks, J.
    fn energy(&self) -> DoubleDouble {
        let block =
            self.samples.iter().fold(DoubleDouble::of(0.0), |sum, &(force, displacement)| {
                sum + DoubleDouble::product_of(force, displacement)
            });
        block * DoubleDouble::of(f64::from(TICKS / BLOCK))
    }

    fn samples<T: Scalar>(&self) -> Vec<PortSample<T>> {
        let sample = |&(force, displacement): &(f64, f64)| {
            let (period, velocity) = (T::of(1e-3), T::of(1e3 * displacement));
            HeldTick {
                period,
                position: T::of(0.0),
                velocity,
                displacement: T::of(displacement),
                applied: T::of(force),
            }
            .sample()
        };
        self.samples.iter().map(sample).collect()
    }
}

/// Stabilizer with one kind of ledger, and the samples that it runs over.
struct Bench<T: Scalar, A> {
    samples: Vec<PortSample<T>>,
    popc: Lolc<T, PortEnergy, lyapunov::Held, A>,
}

/// Bench with its types erased.
trait Lap {
    /// The sum after all ticks minus `energy`, J.
    fn error(&self, energy: DoubleDouble) -> f64;

    /// The time of a step, ns.
    fn time(&mut self) -> f64;
}

impl<T: Scalar, A: Accumulator<T> + 'static> Bench<T, A> {
    fn of(motion: &Motion) -> Result<Box<dyn Lap>, ParameterError> {
        let limit = DampingLimit::of_mass(T::of(0.5), T::of(0.3), T::of(1e-3))?;
        let popc = Lolc::new(PortEnergy, limit).summed_in::<A>();
        Ok(Box::new(Self { samples: motion.samples(), popc }))
    }

    fn run(&self, popc: &mut Lolc<T, PortEnergy, lyapunov::Held, A>, blocks: u32) -> T {
        let mut sum = T::of(0.0);
        for _ in 0..blocks {
            for sample in &self.samples {
                sum = popc.stabilize(sample, T::of(0.0)).observed_energy;
            }
        }
        sum
    }
}

impl<T: Scalar, A: Accumulator<T> + 'static> Lap for Bench<T, A> {
    fn error(&self, energy: DoubleDouble) -> f64 {
        let sum = self.run(&mut self.popc.clone(), TICKS / BLOCK);
        (DoubleDouble::of(sum.lane(0)) - energy).magnitude().high()
    }

    fn time(&mut self) -> f64 {
        let mut popc = self.popc;
        let start = Instant::now();
        black_box(self.run(black_box(&mut popc), LAP as u32 / BLOCK));
        1e9 * start.elapsed().as_secs_f64() / LAP as f64
    }
}

/// Runs every ledger over the same ticks, and times them in turns.
pub(super) fn rows(progress: Progress<'_>) -> Result<Vec<LedgerRow>, AccuracyError> {
    let motion = Motion::new();
    let mut benches = [
        ("f32", "plain", Bench::<f32, Plain<f32>>::of(&motion)?),
        ("f32", "compensated", Bench::<f32, Compensated<f32>>::of(&motion)?),
        ("f32", "wide", Bench::<f32, Wide<f32>>::of(&motion)?),
        ("f64", "plain", Bench::<f64, Plain<f64>>::of(&motion)?),
        ("f64", "compensated", Bench::<f64, Compensated<f64>>::of(&motion)?),
        ("f64", "wide", Bench::<f64, Wide<f64>>::of(&motion)?),
    ];
    let (energy, count) = (motion.energy(), benches.len());
    let mut errors = Vec::new();
    for (index, (_, _, bench)) in benches.iter().enumerate() {
        errors.push(bench.error(energy));
        progress.part(0.0, 0.7).tell(index + 1, count)?;
    }
    let times = Rounds::of(count, ROUNDS, |round, at| {
        progress.part(0.7, 1.0).tell(round, ROUNDS)?;
        Ok::<_, AccuracyError>(benches[at].2.time())
    })?;
    let rows = benches.iter().zip(errors).enumerate();
    let row = |(at, (&(scalar, ledger, _), error))| LedgerRow {
        scalar,
        ledger,
        error,
        time: Time::of(&times, at),
    };
    Ok(rows.map(row).collect())
}
