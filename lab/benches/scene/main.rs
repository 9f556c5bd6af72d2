//! Cost of choosing the parts of a loop at run time: a scene built from a file against the same chain composed by type,
//! in ns per tick of one rollout.
//!
//! `scene/<built|typed>/<f64|f64x8>/<k>`, with `k` effects; compare ids of one `k` on one machine only. There are two
//! sets of eight effects, since random numbers take most of the time.

mod typed;

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use lyapunov::{OnePort, ParameterError, Plant, Scalar};
use lyapunov_lab::{Assembly, F64x8, Scene, Space};

/// Ticks of a run: the way to the wall and the first bounces.
const TICKS: usize = 1000;

/// The loop without effects.
const BARE: &str = r#"
duration = 1.0
servo_rate = 1000.0
environment_rate = 100.0
operator.mass = 0.1
operator.damping = 0.2
operator.stiffness = 50.0
device = { mass = 0.2, damping = 0.001 }
initial = { position = -0.004 }
environment.wall = { stiffness = 2000.0, damping = 1.0 }
stabilizer.popc = { damping_cap = 0.5 }
"#;

const TWO: &str = "
effects.encoder = { resolution = 1e-5 }
effects.delay = { ticks = 2 }
";

const FOUR: &str = "
effects.saturation = { force = 8.0 }
effects.filter = { cutoff = 200.0 }
";

const EIGHT: &str = r#"
effects.load = { force = 0.2 }
effects.pulse = { start = 0.1, duration = 0.1, force = 1.0 }
operator.motion = { kind = "step", at = 0.3, to = 0.001 }
operator.grip = { times = [0.5], stiffness = [100.0], damping = [0.4] }
"#;

const RANDOM: &str = r#"
effects.load = { force = 0.2 }
effects.pulse = { start = 0.1, duration = 0.1, force = 1.0 }
effects.dropout = { probability = 0.1, seed = 7, policy = "hold" }
effects.noise = { deviation = 2e-6, seed = 7 }
"#;

/// Timed loop that advances tick by tick.
trait Rolling<T> {
    /// Runs the loop and writes every position.
    fn roll(&mut self, positions: &mut [T]);
}

impl<T: Space> Rolling<T> for Assembly<T> {
    #[inline(never)]
    fn roll(&mut self, positions: &mut [T]) {
        let mut sample = self.plant.start();
        for position in positions {
            self.tick(&mut sample);
            *position = sample.position;
        }
    }
}

/// Plant and port composed by type.
impl<T: Scalar, P: Plant<T>, Q: OnePort<T>> Rolling<T> for (P, Q) {
    #[inline(never)]
    fn roll(&mut self, positions: &mut [T]) {
        let (plant, port) = self;
        let mut sample = plant.start();
        for position in positions {
            sample = plant.advance(port.respond(&sample));
            *position = sample.position;
        }
    }
}

/// Times fresh loops, one after the other, so that one iteration of the report is one tick of one rollout.
fn time<T: Scalar, L: Rolling<T>>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    id: String,
    fresh: impl Fn() -> Result<L, ParameterError>,
) -> Vec<T> {
    let mut positions = vec![T::of(0.0); TICKS];
    let steps = TICKS * T::LANES;
    group.bench_function(id, |bencher| {
        bencher.iter_custom(|count| {
            let runs = count.div_ceil(steps as u64);
            let mut elapsed = Duration::ZERO;
            for _ in 0..runs {
                let mut rolling = black_box(fresh()).expect("the numbers");
                let start = Instant::now();
                rolling.roll(black_box(&mut positions));
                elapsed += start.elapsed();
            }
            elapsed.mul_f64(count as f64 / (runs * steps as u64) as f64)
        });
    });
    positions
}

fn times<T: Space + Scalar>(criterion: &mut Criterion, scalar: &str) {
    let mut group = criterion.benchmark_group("scene");
    macro_rules! contest {
        ($name:literal, $typed:path, $($part:expr),+) => {
            let scene = Scene::parse(&[$($part),+].concat(), $name).expect("a scene");
            let built = || Assembly::<T>::of(&scene);
            let built = time(&mut group, format!("built/{scalar}/{}", $name), built);
            let typed = time(&mut group, format!("typed/{scalar}/{}", $name), $typed);
            assert!(built.is_empty() || typed.is_empty() || built == typed, "{}", $name);
        };
    }
    contest!("0", typed::bare::<T>, BARE);
    contest!("2", typed::two::<T>, BARE, TWO);
    contest!("4", typed::four::<T>, BARE, TWO, FOUR);
    contest!("8", typed::eight::<T>, BARE, TWO, FOUR, EIGHT);
    contest!("8-random", typed::random::<T>, BARE, TWO, FOUR, RANDOM);
}

fn scenes(criterion: &mut Criterion) {
    times::<f64>(criterion, "f64");
    times::<F64x8>(criterion, "f64x8");
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(600))
        .sample_size(50);
    targets = scenes
}
criterion_main!(benches);
