//! Time of one tick of a stabilizer, in ns: ours, generic over scalar, port, candidate and work, against straight
//! code on concrete types, and against the paper's steps 4 to 6 taken literally.
//!
//! `step/<sampled|held>/<f32|f64>/<1|3|6>dof/<idle|random|always>/<hand|generic|literal>`; the mix says how
//! often the controller acts. `latency/…` is the time from force in to force out ([`latency`]). Compare ids of one mix with one another, not with another machine.

mod hand;
mod latency;
mod samples;

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, PortEnergy, PortSample, Signal, Stabilizer,
};
use nalgebra::SVector;

use samples::{DAMPING, LIMIT, Mix, STEPS, Sample};

type Group<'a> = BenchmarkGroup<'a, WallTime>;

/// Timing of `block`, which does [`STEPS`] steps, so that one iteration of the report is one step.
fn time(group: &mut Group<'_>, id: &str, mut block: impl FnMut()) {
    group.bench_function(id, |bencher| {
        bencher.iter_custom(|steps| {
            let blocks = steps.div_ceil(STEPS as u64);
            let start = Instant::now();
            for _ in 0..blocks {
                block();
            }
            start.elapsed().mul_f64(steps as f64 / (blocks * STEPS as u64) as f64)
        });
    });
}

/// Our step over every sample, kept out of line as the hand-written loops are.
#[inline(never)]
fn generic<V: Signal>(
    stabilizer: &mut impl Stabilizer<V>,
    samples: &[(PortSample<V>, V)],
    corrections: &mut [Correction<V>],
) {
    for ((sample, effort), correction) in samples.iter().zip(corrections) {
        *correction = stabilizer.stabilize(sample, *effort);
    }
}

fn time_generic<V: Signal>(
    group: &mut Group<'_>,
    mut stabilizer: impl Stabilizer<V>,
    samples: &[(PortSample<V>, V)],
) {
    let mut corrections = vec![Correction::none(V::zero()); samples.len()];
    time(group, "generic", || {
        generic(black_box(&mut stabilizer), black_box(samples), black_box(&mut corrections));
    });
}

macro_rules! widths {
    ($criterion:ident, $real:ident, $hand:ident, $($n:literal),+) => {$(
        for mix in Mix::ALL {
            let limit = DampingLimit::at(LIMIT as $real).expect("a limit");
            let credit = Dissipation::of(DAMPING as $real).expect("a damping");
            let lolc = Lolc::new((PortEnergy, credit), limit);
            for work in ["sampled", "held"] {
                let samples: Vec<Sample<$real, $n>> = match work {
                    "sampled" => samples::sampled(mix),
                    _ => samples::held(mix),
                };
                let drives: Vec<_> = samples.iter().map(vector_sample).collect();
                let id = format!("step/{work}/{}/{}dof/{}", stringify!($real), $n, mix.name());
                let mut group = $criterion.benchmark_group(id);
                let mut state = hand::$hand::State::new();
                let mut out = vec![hand::$hand::Out::default(); samples.len()];
                match work {
                    "sampled" => {
                        time(&mut group, "hand", || {
                            hand::$hand::sampled::<$n, false>(black_box(&mut state), black_box(0.0), black_box(&samples), black_box(&mut out));
                        });
                        time_generic(&mut group, lolc.sampled(), &drives);
                    }
                    _ => {
                        time(&mut group, "hand", || {
                            hand::$hand::held::<$n, false>(black_box(&mut state), black_box(0.0), black_box(&samples), black_box(&mut out));
                        });
                        time_generic(&mut group, lolc, &drives);
                    }
                }
            }
        }
    )+};
}

macro_rules! scalars {
    ($criterion:ident, $real:ident, $hand:ident) => {
        for mix in Mix::ALL {
            let limit = DampingLimit::at(LIMIT as $real).expect("a limit");
            let credit = Dissipation::of(DAMPING as $real).expect("a damping");
            let lolc = Lolc::new((PortEnergy, credit), limit);
            for work in ["sampled", "held"] {
                let samples: Vec<Sample<$real, 1>> = match work {
                    "sampled" => samples::sampled(mix),
                    _ => samples::held(mix),
                };
                let drives: Vec<_> = samples.iter().map(scalar_sample).collect();
                let id = format!("step/{work}/{}/1dof/{}", stringify!($real), mix.name());
                let mut group = $criterion.benchmark_group(id);
                let mut state = hand::$hand::State::new();
                let mut out = vec![hand::$hand::Out::default(); samples.len()];
                match work {
                    "sampled" => {
                        time(&mut group, "hand", || {
                            hand::$hand::sampled::<1, false>(
                                black_box(&mut state),
                                black_box(0.0),
                                black_box(&samples),
                                black_box(&mut out),
                            );
                        });
                        time_generic(&mut group, lolc.sampled(), &drives);
                        let mut literal = hand::$hand::Literal::new();
                        let mut forces = vec![0.0; samples.len()];
                        time(&mut group, "literal", || {
                            hand::$hand::literal::<false>(
                                black_box(&mut literal),
                                black_box(0.0),
                                black_box(&samples),
                                black_box(&mut forces),
                            );
                        });
                    }
                    _ => {
                        time(&mut group, "hand", || {
                            hand::$hand::held::<1, false>(
                                black_box(&mut state),
                                black_box(0.0),
                                black_box(&samples),
                                black_box(&mut out),
                            );
                        });
                        time_generic(&mut group, lolc, &drives);
                    }
                }
            }
        }
    };
}

fn scalar_sample<T: lyapunov::Scalar>(s: &Sample<T, 1>) -> (PortSample<T>, T) {
    let sample = PortSample {
        period: s.period,
        position: s.position[0],
        velocity: s.velocity[0],
        displacement: s.displacement[0],
        applied: s.applied[0],
        work: s.work[0],
    };
    (sample, s.effort[0])
}

fn vector_sample<T: lyapunov::Scalar, const N: usize>(
    s: &Sample<T, N>,
) -> (PortSample<SVector<T, N>>, SVector<T, N>) {
    let sample = PortSample {
        period: s.period,
        position: s.position.into(),
        velocity: s.velocity.into(),
        displacement: s.displacement.into(),
        applied: s.applied.into(),
        work: s.work.into(),
    };
    (sample, s.effort.into())
}

fn step(criterion: &mut Criterion) {
    scalars!(criterion, f64, f64s);
    scalars!(criterion, f32, f32s);
    widths!(criterion, f64, f64s, 3, 6);
    widths!(criterion, f32, f32s, 3, 6);
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(1000))
        .sample_size(50);
    targets = step, latency::latency
}
criterion_main!(benches);
