//! Numbers to try, and ports to try them on.

use lyapunov::{
    DampingLimit, HeldTick, OnePort, Plant, Popc, PortEnergy, PortSample, Scalar, Signal,
    bodies::{Body, Impedance},
};

pub(crate) use crate::dice::Dice;

pub(crate) const PERIOD: f64 = 1e-3;

pub(crate) fn limit<T: Scalar>() -> DampingLimit<T> {
    DampingLimit::of_mass(T::of(0.5), T::of(0.2), T::of(PERIOD)).expect("a limit")
}

pub(crate) fn popc<T: Scalar>() -> Popc<T> {
    Popc::new(PortEnergy, limit())
}

impl Dice {
    pub(crate) fn signal<V: Signal>(&mut self, size: f64) -> V {
        V::zero().map(|_| V::Scalar::of(self.within(size)))
    }
}

/// A sample over [`PERIOD`] of a displacement at a steady velocity.
pub(crate) fn held_tick<V: Signal>(position: V, displacement: V, applied: V) -> PortSample<V> {
    let period = V::Scalar::of(PERIOD);
    let velocity = displacement.map(|it| it / period);
    HeldTick { period, position, velocity, displacement, applied }.sample()
}

/// A device of 0.2 kg and 1 N·s/m in a hand of 200 N/m.
pub(crate) const HELD: Impedance<f64> = Impedance { mass: 0.2, damping: 1.0, stiffness: 200.0 };

/// Largest distance of `hand` from the origin over `ticks` from 1 mm on, and over the last tenth of them; it ends beyond 1 km.
pub(crate) fn swing(hand: Impedance<f64>, mut port: impl OnePort<f64>, ticks: usize) -> (f64, f64) {
    let mut body = Body::<f64>::new(hand, PERIOD).expect("a body").starting(1e-3, 0.0);
    let (mut sample, mut most, mut late) = (body.start(), 0f64, 0f64);
    for tick in 0..ticks {
        sample = body.advance(port.respond(&sample));
        most = most.max(sample.position.abs());
        if tick >= ticks - ticks / 10 {
            late = late.max(sample.position.abs());
        }
        if most > 1e3 {
            return (most, most);
        }
    }
    (most, late)
}
