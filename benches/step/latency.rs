//! Time from force in to force out, in ns: each force waits for the one that the step before gave out, while position,
//! velocity and period are known long before.
//!
//! `latency/<sampled|held>/<f32|f64>/<idle|random|always>/<link|hand|generic|literal>`. `link` is the chain without a
//! step, one multiplication and one addition, which is in the other times too.

use std::hint::black_box;

use criterion::Criterion;
use lyapunov::{DampingLimit, Dissipation, Lolc, PortEnergy, PortSample, Scalar, Stabilizer};

use super::hand;
use super::samples::{self, DAMPING, LIMIT, Mix, Sample};
use super::{scalar_sample, time};

/// Our step over every sample, each with a force that waits for the last one; `none` is 0, unknown to the compiler.
#[inline(never)]
fn generic<T: Scalar>(
    stabilizer: &mut impl Stabilizer<T>,
    none: T,
    samples: &[(PortSample<T>, T)],
) -> T {
    let mut out = T::of(0.0);
    for (sample, effort) in samples {
        out = stabilizer.stabilize(sample, *effort + none * out).effort;
    }
    out
}

#[inline(never)]
fn link<T: Scalar>(none: T, samples: &[(PortSample<T>, T)]) -> T {
    let mut out = T::of(0.0);
    for (_, effort) in samples {
        out = *effort + none * out;
    }
    out
}

macro_rules! latencies {
    ($criterion:ident, $real:ident, $hand:ident) => {
        for mix in Mix::ALL {
            let limit = DampingLimit::at(LIMIT as $real).expect("a limit");
            let credit = Dissipation::of(DAMPING as $real).expect("a damping");
            let mut held = Lolc::new((PortEnergy, credit), limit);
            let mut sampled = held.sampled();
            for work in ["sampled", "held"] {
                let samples: Vec<Sample<$real, 1>> = match work {
                    "sampled" => samples::sampled(mix),
                    _ => samples::held(mix),
                };
                let drives: Vec<_> = samples.iter().map(scalar_sample).collect();
                let id = format!("latency/{work}/{}/{}", stringify!($real), mix.name());
                let mut group = $criterion.benchmark_group(id);
                let mut state = hand::$hand::State::new();
                let mut literal = hand::$hand::Literal::new();
                let mut corrections = vec![hand::$hand::Out::default(); samples.len()];
                time(&mut group, "link", || {
                    black_box(link::<$real>(black_box(0.0), black_box(&drives)));
                });
                let run = if work == "sampled" {
                    hand::$hand::sampled::<1, true>
                } else {
                    hand::$hand::held::<1, true>
                };
                time(&mut group, "hand", || {
                    run(
                        black_box(&mut state),
                        black_box(0.0),
                        black_box(&samples),
                        &mut corrections,
                    );
                });
                match work {
                    "sampled" => {
                        time(&mut group, "generic", || {
                            black_box(generic(
                                black_box(&mut sampled),
                                black_box(0.0),
                                black_box(&drives),
                            ));
                        });
                        let mut forces = vec![0.0; samples.len()];
                        time(&mut group, "literal", || {
                            hand::$hand::literal::<true>(
                                black_box(&mut literal),
                                black_box(0.0),
                                black_box(&samples),
                                black_box(&mut forces),
                            );
                        });
                    }
                    _ => time(&mut group, "generic", || {
                        black_box(generic(
                            black_box(&mut held),
                            black_box(0.0),
                            black_box(&drives),
                        ));
                    }),
                }
            }
        }
    };
}

pub(crate) fn latency(criterion: &mut Criterion) {
    latencies!(criterion, f64, f64s);
    latencies!(criterion, f32, f32s);
}
