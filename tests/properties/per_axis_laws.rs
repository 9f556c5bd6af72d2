//! Laws of a sum for each axis, in several scalars and on lanes.

use lyapunov::lanes::{AutoF32x8, AutoF64x4};
use lyapunov::laws::{self, Samples};
use lyapunov::{DampingLimit, Popc, PortEnergy, Scalar, stabilizers::PerAxis};
use nalgebra::SVector;

fn keeps_the_laws<T: Scalar, const N: usize>(cap: f64) {
    for seed in 0..10 {
        let limit = DampingLimit::of_mass(T::of(cap), T::of(0.2), T::of(1e-3)).expect("a limit");
        let each = PerAxis::of([Popc::new(PortEnergy, limit); N]);
        let samples = Samples::<SVector<T, N>>::new(T::of(1e-3)).seeded(seed);
        laws::stabilizer(&each, samples).expect("lawful");
    }
}

#[test]
fn a_sum_per_axis_keeps_the_laws() {
    for cap in [0.0, 0.5, f64::INFINITY] {
        keeps_the_laws::<f64, 1>(cap);
        keeps_the_laws::<f64, 3>(cap);
        keeps_the_laws::<f32, 6>(cap);
        keeps_the_laws::<AutoF64x4, 3>(cap);
        keeps_the_laws::<AutoF32x8, 2>(cap);
    }
}
