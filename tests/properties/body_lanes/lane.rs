//! Numbers of one lane.

use crate::support::{Bits, bad, hostile, log_between, ordinary, unit, wild};

/// Body, start and efforts of one lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane {
    pub(super) body: [f64; 3],
    pub(super) link: [f64; 4],
    pub(super) law: [f64; 3],
    pub(super) period: f64,
    pub(super) deviation: f64,
    pub(super) start: [f64; 2],
    pub(super) push: Push,
}

/// Effort on a body: `x (stiffness + swing sin(k / 2)) + damping v`, and a random one of `noise`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Push {
    pub(super) stiffness: f64,
    pub(super) swing: f64,
    pub(super) damping: f64,
    pub(super) noise: Noise,
    pub(super) seed: u64,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Noise {
    Within(f64),
    Hostile,
    /// One in so many ticks is any pattern of bits.
    WildEvery(u64),
}

impl Push {
    pub(super) fn at(&self, tick: usize, sample: &[f64; 6]) -> f64 {
        let [_, position, velocity, ..] = *sample;
        let bits = scrambled(self.seed.wrapping_add(tick as u64));
        let noise: f64 = match self.noise {
            Noise::Within(scale) => ordinary(bits, scale),
            Noise::Hostile => hostile(bits),
            Noise::WildEvery(ticks) if bits.is_multiple_of(ticks) => wild(bits),
            Noise::WildEvery(_) => ordinary(bits, 2.0),
        };
        let gain = self.stiffness + self.swing * (0.5 * tick as f64).sin();
        position * gain + velocity * self.damping + noise
    }
}

/// The finalizer of SplitMix64.
fn scrambled(bits: u64) -> u64 {
    let bits = bits.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ bits >> 31
}

impl Lane {
    /// A body of ordinary size.
    pub(super) fn ordinary(bits: Bits) -> Self {
        let random = |at: u64| scrambled(bits.wrapping_add(at << 32));
        let log = |at, least, most| log_between(random(at), least, most);
        let breakaway = log(0, 0.1, 10.0);
        let period = log(1, 1e-4, 2e-2);
        let noise = Noise::Within(2.0 * breakaway);
        Self {
            body: [log(2, 0.05, 1.0), log(3, 1e-3, 1.0), log(4, 1.0, 1e4)],
            link: [log(5, 0.05, 1.0), log(6, 1e-3, 1.0), log(7, 1e2, 1e5), log(8, 1e-2, 10.0)],
            law: [breakaway * unit(random(9)), breakaway, log(10, 1e-3, 0.1)],
            period,
            deviation: if bits.is_multiple_of(2) { 0.0 } else { period * log(11, 1e-3, 1.0) },
            start: [ordinary(random(12), 0.02), ordinary(random(13), 0.3)],
            push: Push { stiffness: 0.0, swing: 0.0, damping: 0.0, noise, seed: random(14) },
        }
    }

    /// A block that its own push drives out of the range of the numbers.
    fn runaway(bits: Bits) -> Self {
        let lane = Self::ordinary(bits);
        let random = |at: u64| scrambled(bits.wrapping_add(at << 32 | 1));
        let push = Push {
            stiffness: ordinary(random(0), 900.0),
            swing: ordinary(random(1), 300.0),
            damping: ordinary(random(2), 30.0),
            ..lane.push
        };
        let [damping, stiffness] = if bits.is_multiple_of(3) { [0.0, 0.0] } else { [0.1, 30.0] };
        let body = [0.5, damping, stiffness];
        Self { body, period: 0.1, law: [0.3, 0.32, 0.002], push, ..lane }
    }

    /// Numbers of any size.
    fn wide(bits: Bits) -> Self {
        let mut lane = Self::ordinary(bits);
        let random = |at: u64| scrambled(bits.wrapping_add(at << 32 | 2));
        for (at, number) in lane.numbers().into_iter().enumerate() {
            let random = random(at as u64);
            *number = match bits % 2 {
                0 => hostile::<f64>(random),
                _ => log_between(random, 1e-6, 1e6),
            };
            // Of positions and velocities alone may be negative.
            *number = if at < 2 { *number } else { number.abs() };
        }
        lane.law[1] += lane.law[0];
        lane.push.noise = if bits % 4 < 2 { Noise::Hostile } else { lane.push.noise };
        lane
    }

    fn numbers(&mut self) -> [&mut f64; 14] {
        let Self { body: [m, b, k], link: [om, ob, lk, lb], law: [c, s, v], .. } = self;
        let [position, velocity] = &mut self.start;
        let (period, deviation) = (&mut self.period, &mut self.deviation);
        [position, velocity, m, b, k, om, ob, lk, lb, c, s, v, period, deviation]
    }

    /// One of all kinds; of those that spend a period in very many pieces only in some sets.
    pub(super) fn of(bits: Bits, set: Bits) -> Self {
        let mut lane = Self::ordinary(bits);
        match bits >> 60 {
            0 => lane.law = [0.0, 0.0, 1.0],
            1 => lane.law[0] = lane.law[1],
            2 => lane.start[(bits % 2) as usize] = bad(bits),
            3 => lane.push.noise = Noise::WildEvery(50),
            4 => lane.start[(bits % 2) as usize] = wild(scrambled(bits)),
            5 => lane.deviation = hostile::<f64>(scrambled(bits)).abs(),
            6..=8 if set.is_multiple_of(64) => return Self::runaway(bits),
            9 | 10 if set.is_multiple_of(16) => return Self::wide(bits),
            _ => {}
        }
        lane
    }
}
