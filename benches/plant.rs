//! One period of a plant, in ns: the increment form of the exact map, `x += (Φ − I) x + Γ f`, against the naive form,
//! `x = Φ x + Γ f`, which in `f32` gains energy by rounding.
//!
//! `plant/<f32|f64>/<increment|naive>`. Compare ids with one another, not with another machine.

use std::hint::black_box;
use std::time::Instant;

use criterion::{Criterion, criterion_group, criterion_main};
use lyapunov::{
    Plant, Scalar,
    bodies::{Body, Impedance},
};

/// Periods of one lap.
const LAP: u32 = 10_000;

/// Naive form of the map, made from the increments.
struct Naive<T> {
    map: [[T; 3]; 2],
    position: T,
    velocity: T,
}

impl<T: Scalar> Naive<T> {
    fn of(body: Body<T>) -> Self {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let after = |position, velocity, effort| {
            let sample = { body }.starting(position, velocity).advance(effort);
            [sample.position, sample.velocity]
        };
        let columns = [after(one, zero, zero), after(zero, one, zero), after(zero, zero, one)];
        let row = |at: usize| columns.map(|column| column[at]);
        Self { map: [row(0), row(1)], position: T::of(0.004), velocity: zero }
    }

    #[inline]
    fn advance(&mut self, effort: T) -> T {
        let (position, velocity) = (self.position, self.velocity);
        let of = |row: [T; 3]| row[0] * position + row[1] * velocity + row[2] * effort;
        let displacement = of(self.map[0]) - position;
        (self.position, self.velocity) = (of(self.map[0]), of(self.map[1]));
        displacement
    }
}

fn forms<T: Scalar>(criterion: &mut Criterion, scalar: &str) {
    let hand = Impedance { mass: T::of(0.3), damping: T::of(0.0), stiffness: T::of(50.0) };
    let body = Body::<T>::new(hand, T::of(1e-3)).expect("a body");
    let mut group = criterion.benchmark_group(format!("plant/{scalar}"));
    let mut time = |id: &str, step: &mut dyn FnMut(u32)| {
        group.bench_function(id, |bencher| {
            bencher.iter_custom(|steps| {
                let laps = steps.div_ceil(LAP.into());
                let start = Instant::now();
                (0..laps).for_each(|_| step(LAP));
                start.elapsed().mul_f64(steps as f64 / (laps * u64::from(LAP)) as f64)
            });
        });
    };
    let mut moving = body.starting(T::of(0.004), T::of(0.0));
    time("increment", &mut |steps| {
        for _ in 0..steps {
            black_box(moving.advance(T::of(0.0)).displacement);
        }
    });
    let mut naive = Naive::of(body);
    time("naive", &mut |steps| {
        for _ in 0..steps {
            black_box(naive.advance(T::of(0.0)));
        }
    });
}

fn plants(criterion: &mut Criterion) {
    forms::<f32>(criterion, "f32");
    forms::<f64>(criterion, "f64");
}

criterion_group!(benches, plants);
criterion_main!(benches);
