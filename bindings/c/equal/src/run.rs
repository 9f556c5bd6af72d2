//! Random ticks and a hash of what comes out, the same here and in tests/c/random.h.

use lyapunov::{PortSample, Scalar, Signal};

/// The largest numbers of a sample's fields: m, m/s, m, N, J.
pub(crate) const MOST: [f64; 5] = [0.01, 0.5, 5e-4, 10.0, 5e-3];

pub(crate) struct Run {
    pub(crate) ticks: u64,
    state: u64,
    hash: u64,
}

impl Run {
    pub(crate) fn begin(ticks: u64) -> Self {
        Self { ticks, state: 0x9e37_79b9_7f4a_7c15, hash: 0xcbf2_9ce4_8422_2325 }
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.state
    }

    pub(crate) fn unit(&mut self) -> f64 {
        self.bits() as i64 as f64 / 9_223_372_036_854_775_808.0
    }

    pub(crate) fn number(&mut self, most: f64) -> f64 {
        match self.bits() >> 50 {
            20.. => most * self.unit(),
            16.. => 1e30 * self.unit(),
            chance => [0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN][chance as usize % 4],
        }
    }

    pub(crate) fn period(&mut self) -> f64 {
        if self.bits() >> 56 == 0 { self.number(1e-3) } else { 1e-3 * (1.0 + 0.25 * self.unit()) }
    }

    /// A signal that is 0 on all axes at times, as at rest and in free motion.
    pub(crate) fn signal<V: Signal>(&mut self, most: f64) -> V {
        let zero = V::splat(V::Scalar::of(0.0));
        if self.bits() >> 61 == 0 {
            return zero;
        }
        zero.map(|_| V::Scalar::of(self.number(most)))
    }

    pub(crate) fn sample<V: Signal>(&mut self) -> PortSample<V> {
        PortSample {
            period: V::Scalar::of(self.period()),
            position: self.signal(MOST[0]),
            velocity: self.signal(MOST[1]),
            displacement: self.signal(MOST[2]),
            applied: self.signal(MOST[3]),
            work: self.signal(MOST[4]),
        }
    }

    pub(crate) fn hash(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    pub(crate) fn tell<T: Scalar>(&mut self, number: T) {
        let number = number.lane(0);
        self.hash(if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() });
    }

    pub(crate) fn tell_all<V: Signal>(&mut self, signal: V) {
        let mut axes = Vec::new();
        signal.map(|axis| {
            axes.push(axis);
            axis
        });
        axes.into_iter().for_each(|axis| self.tell(axis));
    }

    pub(crate) fn tell_sample<V: Signal>(&mut self, sample: &PortSample<V>) {
        self.tell(sample.period);
        let PortSample { position, velocity, displacement, applied, work, .. } = *sample;
        for signal in [position, velocity, displacement, applied, work] {
            self.tell_all(signal);
        }
    }

    pub(crate) fn end(&self, name: &str, signal: &str) {
        println!("{name}_{signal} {:016x}", self.hash);
    }
}
