//! Rollout-steps per second of a stability map, on one core: the paper's wall, a 1 kHz servo over a 100 Hz
//! environment, 2 s, LOLC with a cap of 0.5, stiffness 100 to 50,000 N/m by damping 0 to 100 N·s/m.
//!
//! `map/scalar` runs the cells one by one, `map/lanes` as many at once as fill two vectors, on the best instructions
//! that the processor has; both run each cell to its end, unless its verdict is certain before. `map/measures-scalar` and
//! `map/measures-lanes` measure the same cells, each to its end.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use lyapunov_lab::Scene;
use lyapunov_lab::map::{BasicName, Grid, Instructions, Kernel, Lanes};

const SIDE: u64 = 256;

fn scene(scalar: &str) -> Scene {
    let text = format!(
        "duration = 2.0\nservo_rate = 1000.0\nenvironment_rate = 100.0\nscalar = \"{scalar}\"\n\
         operator = {{ mass = 0.1, damping = 0.2, stiffness = 50.0 }}\n\
         device = {{ mass = 0.2, damping = 0.001 }}\ninitial.position = -0.004\n\
         environment.wall = {{ stiffness = 8000.0, damping = 2.0 }}\n\
         stabilizer.lolc.damping_cap = 0.5\n"
    );
    Scene::parse(&text, "map").expect("a scene")
}

fn kernel(scalar: &str, lanes: Lanes, instructions: Instructions) -> Kernel {
    let x = format!("environment.wall.stiffness=100..50000:{SIDE}").parse().expect("an axis");
    let y = format!("environment.wall.damping=0..100:{SIDE}").parse().expect("an axis");
    let grid = Grid::new(scene(scalar), x, y, vec![BasicName::Lolc]).expect("a grid");
    Kernel::of(&grid, instructions, lanes).expect("values").expect("a scene of the kernel")
}

/// The cells of every `step`-th row.
fn cells(step: usize) -> Vec<u64> {
    let rows = (0..SIDE).step_by(step);
    rows.flat_map(|row| row * SIDE..(row + 1) * SIDE).collect()
}

/// The ticks of the runs of `cells`.
fn steps(cells: &[u64]) -> Throughput {
    Throughput::Elements(cells.len() as u64 * 2001)
}

fn map(c: &mut Criterion) {
    let mut group = c.benchmark_group("map");
    group.sample_size(10);
    for scalar in ["f32", "f64"] {
        for (name, lanes) in [("scalar", Lanes::One), ("lanes", Lanes::Many)] {
            // One by one, and to the end, every sixteenth row is enough.
            let few = cells(16);
            let judged = if lanes == Lanes::One { few.clone() } else { cells(1) };
            let instructions = match lanes {
                Lanes::One => vec![Instructions::Base],
                Lanes::Many => Instructions::all(),
            };
            for (index, set) in instructions.into_iter().enumerate() {
                let kernel = kernel(scalar, lanes, set);
                let id =
                    if index == 0 { scalar.to_owned() } else { format!("{scalar}/{}", set.name()) };
                group.throughput(steps(&judged));
                group.bench_function(BenchmarkId::new(name, &id), |b| {
                    b.iter(|| kernel.verdicts(BasicName::Lolc, &judged, &|| true));
                });
                group.throughput(steps(&few));
                group.bench_function(BenchmarkId::new(format!("measures-{name}"), id), |b| {
                    b.iter(|| kernel.measures(BasicName::Lolc, &few, &|| true));
                });
            }
        }
    }
    group.finish();
}

criterion_group!(benches, map);
criterion_main!(benches);
