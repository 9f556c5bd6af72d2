//! Ticks of any numbers, one after the other.

use lyapunov_core::{HeldTick, PortSample, Scalar, Signal};

use crate::{Bytes, Real};

/// A tick: what the other side did, and the effort that is asked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tick<V: Signal> {
    pub(crate) sample: PortSample<V>,
    pub(crate) asked: V,
}

impl<V: Signal<Scalar: Real>> Tick<V> {
    /// A tick at rest, before any byte.
    pub(crate) fn quiet() -> Self {
        let period = V::Scalar::of(1e-3);
        Self { sample: PortSample::starting(period, V::zero(), V::zero()), asked: V::zero() }
    }

    /// Whether a device could have done this: what is finite is no larger than any machine, and time is of its scale. What is
    /// not finite can be told by anyone.
    pub(crate) fn believable(&self) -> bool {
        let large = V::Scalar::of(1e6);
        let PortSample { period, position, velocity, displacement, applied, work } = self.sample;
        let mut believable = !period.finite()
            || period <= V::Scalar::of(0.0)
            || (period >= V::Scalar::of(1e-6) && period <= V::Scalar::of(1e3));
        for signal in [position, velocity, displacement, applied, work, self.asked] {
            signal.map(|axis| {
                believable &= !axis.finite() || axis.magnitude() <= large;
                axis
            });
        }
        believable
    }

    /// The next tick: a byte tells which fields are new, the others stay.
    pub(crate) fn after(self, bytes: &mut Bytes<'_>) -> Self {
        let changed = bytes.byte();
        let Self { sample, asked } = self;
        let PortSample { period, position, velocity, displacement, applied, work } = sample;
        let mut renewed =
            |bit: u8, old: V| if changed >> bit & 1 == 1 { signal(bytes) } else { old };
        let [position, velocity, displacement, applied, asked] =
            [(1, position), (2, velocity), (3, displacement), (4, applied), (5, asked)]
                .map(|(bit, old)| renewed(bit, old));
        let work = renewed(6, work);
        let period = if changed & 1 == 1 { bytes.number() } else { period };
        let held = HeldTick { period, position, velocity, displacement, applied }.sample();
        // Mostly the work is that of the applied effort.
        let sample = if changed >> 7 == 1 { PortSample { work, ..held } } else { held };
        Self { sample, asked }
    }
}

/// A signal of any numbers.
pub(crate) fn signal<V: Signal<Scalar: Real>>(bytes: &mut Bytes<'_>) -> V {
    V::zero().map(|_| bytes.number())
}
