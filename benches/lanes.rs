//! Several rollouts in one number: the paper's wall of 8 kN/m under LOLC, from one generic source, in ns per
//! tick of one rollout.
//!
//! `lanes/<f64|f64x4|f64x8|f32x8>`; compare them with one another, not with another machine.

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use lyapunov::lanes::{AutoF64x4, AutoF64x8, WideF32x8};
use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant, PortEnergy, Scalar,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
};

const PERIOD: f64 = 0.01;
const TICKS: usize = 1000;

/// The largest position over [`TICKS`] ticks, from starts a little apart in every lane.
#[inline(never)]
fn rollout<T: Scalar>(start: T) -> Result<T, ParameterError> {
    let of = T::of;
    let operator = Impedance { mass: of(0.1), damping: of(0.2), stiffness: of(50.0) };
    let device = Impedance { mass: of(0.2), damping: of(0.001), stiffness: of(0.0) };
    let mut plant = Body::new(operator + device, of(PERIOD))?.starting(start, of(0.0));
    let wall = Wall::new(of(8000.0), of(2.0))?;
    let limit = DampingLimit::of_mass(of(0.5), of(0.3), of(PERIOD))?;
    let lolc = Lolc::new((PortEnergy, wall.dissipation()), limit);
    let mut port = wall.stabilized(lolc).differenced();

    let mut sample = plant.start();
    let mut largest = start;
    for _ in 0..TICKS {
        sample = plant.advance(port.respond(&sample));
        largest = sample.position.larger(largest);
    }
    Ok(largest)
}

fn time<T: Scalar>(criterion: &mut Criterion, id: &str) {
    let start = T::from_lanes(|lane| -0.004 - 1e-5 * lane as f64);
    let steps = (TICKS * T::LANES) as u64;
    criterion.benchmark_group("lanes").bench_function(id, |bencher| {
        bencher.iter_custom(|count| {
            let rollouts = count.div_ceil(steps);
            let clock = Instant::now();
            for _ in 0..rollouts {
                black_box(rollout(black_box(start))).expect("the paper's numbers");
            }
            clock.elapsed().mul_f64(count as f64 / (rollouts * steps) as f64)
        });
    });
}

fn lanes(criterion: &mut Criterion) {
    time::<f64>(criterion, "f64");
    time::<AutoF64x4>(criterion, "f64x4");
    time::<AutoF64x8>(criterion, "f64x8");
    time::<WideF32x8>(criterion, "f32x8");
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(1000))
        .sample_size(50);
    targets = lanes
}
criterion_main!(benches);
