//! The ticks of loops, watched and counted bit by bit.

use lyapunov::{ParameterError, Scalar, Signal};

use crate::files::Scene;
use crate::simulate::{Fitted, Instructions, Rollout, Scenes, Space, Tick};
use crate::studies::hard::looped::{named_in, terms};
use crate::studies::hard::tally::Tally;
use crate::studies::hard::watched::Meters;

/// Measurements and bits of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ran {
    /// Its measurements.
    pub(super) tally: Tally,
    /// A hash of every number of every tick.
    pub(super) bits: u64,
}

/// The runs of `scenes`, one in each lane, to their end even where the motion leaves the range of the scalar.
pub(super) fn ticks<V: Space>(scenes: &[Scene]) -> Result<Vec<Ran>, ParameterError> {
    let on = Scenes::on(scenes, Instructions::Base);
    let tables: Vec<_> = scenes.iter().map(|scene| scene.stabilizer).collect();
    let mut rollout = Rollout::<V>::on(on, Fitted::on(on, &tables)?)?;
    let mut meters = Meters::of_lanes::<V::Scalar>(
        scenes.iter().map(|scene| terms(scene, 0.0, named_in::<V>(scene))),
    );
    let mut hashes = vec![Hash::default(); scenes.len()];
    for _ in 0..=on.common().ticks() {
        let tick = rollout.tick();
        meters.watch(&tick.measured, tick.environment, &tick.correction);
        for (lane, hash) in hashes.iter_mut().enumerate() {
            hash.add_tick(&tick, lane);
        }
    }
    let runs = meters.tallies().into_iter().zip(hashes);
    Ok(runs.map(|(tally, Hash(bits))| Ran { tally, bits }).collect())
}

/// Hash of numbers by their bits, all that are no number alike (FNV-1a of words).
#[derive(Clone, Copy, Debug)]
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    fn add(&mut self, number: f64) {
        let bits = if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() };
        self.0 = (self.0 ^ bits).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(29);
    }

    fn add_tick<V: Signal>(&mut self, tick: &Tick<V>, lane: usize) {
        let correction = &tick.correction;
        for number in [correction.observed_energy, correction.alpha, correction.shortfall] {
            self.add(number.lane(lane));
        }
        let signals = [
            tick.truth.position,
            tick.truth.velocity,
            tick.measured.position,
            tick.measured.velocity,
            tick.environment,
            tick.command,
            tick.applied,
        ];
        for signal in signals {
            signal.map(|axis| {
                self.add(axis.lane(lane));
                axis
            });
        }
    }
}
