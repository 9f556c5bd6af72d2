//! The common inputs of the worked examples: a way in and out, and what is asked for on it.

use lyapunov::{HeldTick, OnePort, PortSample, Scalar, Stabilizer};

use crate::support::PERIOD;

/// The positions of ten ticks, m.
pub(crate) const PATH: [f64; 10] = [0.0, 1e-4, 3e-4, 6e-4, 8e-4, 8e-4, 6e-4, 3e-4, 1e-4, 0.0];
/// A spring of 5 kN/m on that path, N.
pub(crate) const A: [f64; 10] = [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 3.0, 1.5, 0.5, 0.0];
/// Anything, N.
pub(crate) const B: [f64; 10] = [2.0, 2.0, 2.0, -1.0, -1.0, 3.0, 0.0, 0.0, 2.0, 2.0];

/// Responses of `port` on [`PATH`], tick by tick, its answers acting at once.
pub(crate) fn answers<T: Scalar>(mut port: impl OnePort<T>) -> [f64; 10] {
    let (mut last, mut force) = (PATH[0], T::of(0.0));
    PATH.map(|position| {
        let moved = position - last;
        last = position;
        let [period, x, v, u] = [PERIOD, position, moved / PERIOD, moved].map(T::of);
        force = port.respond(
            &HeldTick { period, position: x, velocity: v, displacement: u, applied: force }
                .sample(),
        );
        force.lane(T::LANES - 1)
    })
}

/// A port that asks for given forces.
struct Asks {
    forces: [f64; 10],
    tick: usize,
}

impl<T: Scalar> OnePort<T> for Asks {
    fn respond(&mut self, _drive: &PortSample<T>) -> T {
        self.tick += 1;
        T::of(self.forces[self.tick - 1])
    }
}

/// Efforts that `stabilizer` makes of the forces `asked` for on [`PATH`].
pub(crate) fn felt<T: Scalar>(stabilizer: impl Stabilizer<T>, asked: [f64; 10]) -> [f64; 10] {
    answers(OnePort::<T>::stabilized(Asks { forces: asked, tick: 0 }, stabilizer))
}

/// Each number within 1e-5 of what it should be.
#[track_caller]
pub(crate) fn near(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found_one, one) in found.iter().zip(expected) {
        assert!((found_one - one).abs() < 1e-5, "{found:?} for {expected:?}");
    }
}

/// Makes a test of a worked example that is generic over the scalar.
macro_rules! each_scalar {
    ($test:ident, $example:ident) => {
        #[test]
        fn $test() {
            $example::<f64>();
            $example::<f32>();
            $example::<lyapunov::lanes::AutoF64x4>();
        }
    };
}

pub(crate) use each_scalar;
