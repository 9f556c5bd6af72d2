//! The reference for tests/c/equal.c, by the library in Rust alone: every block over random ticks, as a hash of its answers.
//!
//! Nothing here goes through the functions of C. `cargo run --release -p lyapunov-equal --bin lyapunov-equal -- 1000000`

use lyapunov::accumulators::{Compensated, Plain};
use lyapunov::candidates::InContact;
use lyapunov::poses::Screw;
use lyapunov::stabilizers::{
    AlongDirection, AxisWeights, DirectedDamping, DriftCompensated, EnergyBounding, ForceBound,
    ForceBounding, LeastNorm, MemoryBased, PartLimits, PathMemory, PerAxis, PerPart, Plausibility,
    Sharing, SlopeBound, StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide, WatchdogTimes,
    WindowedCredit,
};
use lyapunov::{
    CheckedSample, DampingLimit, Dissipation, Lolc, LyapunovCandidate, MovingReading, Observer,
    ParameterError, Popc, PortEnergy, PortSample, Reading, Readings, Scalar, Signal, Stabilizer,
    StorageFunction,
};
use nalgebra::{SVector, Vector3, Vector6};

type Done = Result<(), ParameterError>;

/// The largest numbers of a sample's fields: m, m/s, m, N, J.
const MOST: [f64; 5] = [0.01, 0.5, 5e-4, 10.0, 5e-3];

struct Run {
    ticks: u64,
    state: u64,
    hash: u64,
}

impl Run {
    fn begin(ticks: u64) -> Self {
        Self { ticks, state: 0x9e37_79b9_7f4a_7c15, hash: 0xcbf2_9ce4_8422_2325 }
    }

    fn bits(&mut self) -> u64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.state
    }

    fn unit(&mut self) -> f64 {
        self.bits() as i64 as f64 / 9_223_372_036_854_775_808.0
    }

    fn number(&mut self, most: f64) -> f64 {
        match self.bits() >> 50 {
            20.. => most * self.unit(),
            16.. => 1e30 * self.unit(),
            chance => [0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN][chance as usize % 4],
        }
    }

    fn period(&mut self) -> f64 {
        if self.bits() >> 56 == 0 { self.number(1e-3) } else { 1e-3 * (1.0 + 0.25 * self.unit()) }
    }

    fn signal<V: Signal>(&mut self, most: f64) -> V {
        let zero = V::splat(V::Scalar::of(0.0));
        zero.map(|_| V::Scalar::of(self.number(most)))
    }

    fn sample<V: Signal>(&mut self) -> PortSample<V> {
        PortSample {
            period: V::Scalar::of(self.period()),
            position: self.signal(MOST[0]),
            velocity: self.signal(MOST[1]),
            displacement: self.signal(MOST[2]),
            applied: self.signal(MOST[3]),
            work: self.signal(MOST[4]),
        }
    }

    fn hash(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn tell<T: Scalar>(&mut self, number: T) {
        let number = number.lane(0);
        self.hash(if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() });
    }

    fn tell_all<V: Signal>(&mut self, signal: V) {
        let mut axes = Vec::new();
        signal.map(|axis| {
            axes.push(axis);
            axis
        });
        axes.into_iter().for_each(|axis| self.tell(axis));
    }

    fn tell_sample<V: Signal>(&mut self, sample: &PortSample<V>) {
        self.tell(sample.period);
        let PortSample { position, velocity, displacement, applied, work, .. } = *sample;
        for signal in [position, velocity, displacement, applied, work] {
            self.tell_all(signal);
        }
    }

    fn end(&self, name: &str, signal: &str) {
        println!("{name}_{signal} {:016x}", self.hash);
    }
}

/// A signal of C.
trait Named: Signal<Scalar: Scalar<Mask = bool>> {
    const NAME: &'static str;
}

macro_rules! named {
    ($($type:ty = $name:literal),+ $(,)?) => {
        $(impl Named for $type { const NAME: &'static str = $name; })+
    };
}

named! {
    f32 = "f32", f64 = "f64", Vector3<f32> = "f32x3", Vector3<f64> = "f64x3",
    Vector6<f32> = "f32x6", Vector6<f64> = "f64x6", Screw<f32> = "f32screw", Screw<f64> = "f64screw",
}

type Of<V> = <V as Signal>::Scalar;

/// A number as C wrote it: in `float`.
fn n<T: Scalar>(number: f32) -> T {
    T::of(f64::from(number))
}

fn limit<T: Scalar>() -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::at(n(80.0))
}

type Inner<T> = Lolc<T, (PortEnergy, Dissipation<T>)>;

fn inner<T: Scalar>() -> Result<Inner<T>, ParameterError> {
    Lolc::new((PortEnergy, Dissipation::of(n(0.5))?), limit()?).budgeted(n(0.001))
}

/// Every tick of a stabilizer; `beside` is what is called once a tick after it.
fn run_with<V: Named, S: Stabilizer<V>>(
    ticks: u64,
    name: &str,
    mut stabilizer: S,
    mut beside: impl FnMut(&mut Run, &mut S),
) {
    let mut run = Run::begin(ticks);
    for _ in 0..run.ticks {
        let sample = run.sample();
        let effort = run.signal(MOST[3]);
        let told = stabilizer.stabilize(&sample, effort);
        run.tell_all(told.effort);
        run.tell(told.observed_energy);
        run.tell(told.alpha);
        run.tell(told.shortfall);
        run.hash(u64::from(told.accepted));
        beside(&mut run, &mut stabilizer);
    }
    run.end(name, V::NAME);
}

fn run<V: Named>(ticks: u64, name: &str, stabilizer: impl Stabilizer<V>) {
    run_with(ticks, name, stabilizer, |_, _| {});
}

/// `$body` with `$v` each of the signals.
macro_rules! each {
    ($v:ident in [$($signal:ty),+] $body:block) => {
        $({ type $v = $signal; $body })+
    };
}
macro_rules! line {
    ($v:ident $body:block) => { each!($v in [f32, f64] $body) };
}
macro_rules! bodies {
    ($v:ident $body:block) => { each!($v in [Screw<f32>, Screw<f64>] $body) };
}
macro_rules! axes {
    ($v:ident $body:block) => {
        each!($v in [f32, f64, Vector3<f32>, Vector3<f64>, Vector6<f32>, Vector6<f64>] $body)
    };
}
macro_rules! every {
    ($v:ident $body:block) => {{ axes!($v $body); bodies!($v $body); }};
}

/// The first number of a signal.
fn first<V: Signal>(signal: V) -> Of<V> {
    let mut found = None;
    signal.map(|axis| {
        found = found.or(Some(axis));
        axis
    });
    found.unwrap_or(Of::<V>::of(0.0))
}

/// Work and the credit of a quadratic drag, on the first axis.
struct Drag;

impl<V: Signal> LyapunovCandidate<V> for Drag {
    fn decrease(&mut self, sample: &PortSample<V>) -> Of<V> {
        let speed = first(sample.velocity);
        first(sample.work) + n::<Of<V>>(0.5) * speed * speed * sample.period
    }
}

fn energy<V: Signal>(position: V, velocity: V) -> Of<V> {
    let (place, speed) = (first(position), first(velocity));
    n::<Of<V>>(50.0) * place * place + n::<Of<V>>(0.5) * speed * speed
}

fn controllers(ticks: u64) -> Done {
    every!(V { run::<V>(ticks, "popc", Popc::new(PortEnergy, limit()?).budgeted(n(0.001))?) });
    every!(V { run::<V>(ticks, "lolc", inner()?) });
    line!(V {
        let credit = Dissipation::of(n(2.0))?.gated(InContact { position: n(0.0) });
        run::<V>(ticks, "lolc_in_contact", Lolc::new((PortEnergy, credit), limit()?).budgeted(n(0.001))?)
    });
    every!(V { run::<V>(ticks, "lolc_custom", Lolc::new(Drag, limit()?).budgeted(n(0.001))?) });
    every!(V {
        let started = StorageFunction::starting(energy::<V>, V::splat(n(0.0)), V::splat(n(0.0)));
        let started = lyapunov::Snapshot::restored(started, n(0.001))?;
        run::<V>(ticks, "lolc_storage", Lolc::new(started, limit()?))
    });
    every!(V { run::<V>(ticks, "lolc_sampled", inner()?.sampled()) });
    every!(V {
        let unbudgeted = Lolc::new((PortEnergy, Dissipation::of(n(0.5))?), limit()?);
        let summed = unbudgeted.summed_in::<Compensated<Of<V>>>().budgeted(n(0.001))?;
        run::<V>(ticks, "lolc_compensated", summed)
    });
    Ok(())
}

fn refined(ticks: u64) -> Done {
    every!(V { run::<V>(ticks, "bounded_credit", inner()?.bounded(n(0.002))?) });
    every!(V {
        let unbudgeted = Lolc::new((PortEnergy, Dissipation::of(n(0.5))?), limit()?);
        let window = WindowedCredit::<Of<V>, Plain<Of<V>>, 8>::of_ticks(3)?;
        run::<V>(ticks, "windowed_credit", unbudgeted.summed_by(window).budgeted(n(0.001))?)
    });
    line!(V { run::<V>(ticks, "contact_reset", inner::<V>()?.reset_at::<_, V>(InContact { position: n(0.001) })) });
    every!(V { run::<V>(ticks, "velocity_threshold", inner::<Of<V>>()?.above_velocity(n(0.25))?) });
    every!(V { run::<V>(ticks, "spread", inner::<Of<V>>()?.spread_over(5)?) });
    every!(V { run::<V>(ticks, "soft_start", inner::<Of<V>>()?.rising_over(5)?) });
    every!(V { run::<V>(ticks, "rate_limit", inner::<Of<V>>()?.rate_limited(n(2000.0))?) });
    line!(V { weighted::<V>(ticks, n(0.5))? });
    line!(V { along::<V>(ticks, n(2.0))? });
    every!(V { run::<V>(ticks, "plausible", inner::<Of<V>>()?.plausible(plausibility())?) });
    every!(V { run::<V>(ticks, "watchdog", inner::<Of<V>>()?.watched::<V>(times())?) });
    every!(V {
        let bounded = inner::<Of<V>>()?.bounded(n(0.002))?.rate_limited::<V>(n(2000.0))?;
        run::<V>(ticks, "safeguarded", bounded.plausible(plausibility())?.watched::<V>(times())?)
    });
    directed(ticks)?;
    each!(T in [f32, f64] { run::<Vector3<T>>(ticks, "per_axis", PerAxis::of([inner::<T>()?; 3])) });
    each!(T in [f32, f64] { run::<Vector6<T>>(ticks, "per_axis", PerAxis::of([inner::<T>()?; 6])) });
    bodies!(V {
        let turning = Dissipation::of(n(0.01))?;
        let rotation = Lolc::new((PortEnergy, turning), DampingLimit::at(n(0.25))?);
        run::<V>(ticks, "per_part", PerPart::of(inner::<Of<V>>()?, rotation))
    });
    bodies!(V {
        let credit = PerPart::of(Dissipation::of(n(0.5))?, Dissipation::of(n(0.01))?);
        let limits = PartLimits { translation: limit()?, rotation: DampingLimit::at(n(0.25))? };
        let unlimited = DampingLimit::at(n(f32::INFINITY))?;
        let lolc = Lolc::new((PortEnergy, credit), unlimited).budgeted(n(0.001))?;
        run::<V>(ticks, "part_limits", DirectedDamping::<_, AxisWeights<V>, _>::within(lolc, limits))
    });
    Ok(())
}

fn plausibility<T: Scalar>() -> Plausibility<T> {
    Plausibility { speed: n(0.4), effort: n(9.0) }
}

fn times<T: Scalar>() -> WatchdogTimes<T> {
    WatchdogTimes { hold: n(0.003), rise: n(0.01) }
}

fn weighted<V: Named>(ticks: u64, weights: V) -> Done {
    let metric = AxisWeights::new(weights)?;
    run::<V>(ticks, "axis_weights", DirectedDamping::new(inner()?, metric, limit()?));
    Ok(())
}

fn along<V: Named>(ticks: u64, direction: V) -> Done {
    let metric = AlongDirection::new(direction)?;
    run::<V>(ticks, "along_direction", DirectedDamping::new(inner()?, metric, limit()?));
    Ok(())
}

fn directed(ticks: u64) -> Done {
    fn of<T: Scalar, const N: usize>(axes: [f32; N]) -> SVector<T, N> {
        axes.map(n).into()
    }
    fn screw<T: Scalar>(axes: [f32; 6]) -> Screw<T> {
        let [x, y, z, a, b, c] = axes;
        Screw::new(of([x, y, z]), of([a, b, c]))
    }
    let (three, six) = ([1.0, 0.5, 0.0], [1.0, 0.5, 0.0, 1.0, 0.25, 1.0]);
    each!(T in [f32, f64] { weighted::<Vector3<T>>(ticks, of(three))? });
    each!(T in [f32, f64] { weighted::<Vector6<T>>(ticks, of(six))? });
    each!(T in [f32, f64] { weighted::<Screw<T>>(ticks, screw(six))? });
    let (three, six) = ([1.0, 2.0, -1.0], [1.0, 2.0, -1.0, 1.0, 0.0, 4.0]);
    each!(T in [f32, f64] { along::<Vector3<T>>(ticks, of(three))? });
    each!(T in [f32, f64] { along::<Vector6<T>>(ticks, of(six))? });
    each!(T in [f32, f64] { along::<Screw<T>>(ticks, screw(six))? });
    Ok(())
}

fn family(ticks: u64) -> Done {
    every!(V { run::<V>(ticks, "force_bound", ForceBound::<Of<V>>::new(n(0.5))?) });
    every!(V { run::<V>(ticks, "force_bounding", ForceBounding::<Of<V>>::of_damping(n(0.5))?) });
    every!(V {
        let store = TankLimits { start: n(0.01), floor: n(0.001), ceiling: n(0.02), power: n(1.0) };
        run::<V>(ticks, "tank", Tank::new((PortEnergy, Dissipation::of(n(0.5))?), store)?)
    });
    every!(V { run::<V>(ticks, "energy_bounding", EnergyBounding::<V>::delayed(n(0.5), n(0.001), 2)?) });
    every!(V {
        let candidate = (PortEnergy, Dissipation::of(n(0.5))?);
        let filter = LeastNorm::new(candidate, limit()?, n(0.5))?.budgeted(n(0.001))?;
        run::<V>(ticks, "least_norm", filter)
    });
    every!(V { run::<V>(ticks, "slope_bound", SlopeBound::<V>::new(n(1000.0))?.creeping(n(0.5))?) });
    line!(V { run::<V>(ticks, "memory_based", MemoryBased::<V, 64>::beyond(n(0.0), n(0.01))?.delayed(1)) });
    line!(V { run::<V>(ticks, "path_memory", PathMemory::<V, 64>::beyond(n(0.0), n(0.01))?) });
    every!(V {
        run_with::<V, _>(ticks, "two_port_side", TwoPortSide::<V>::new(limit()?), |run, side| {
            side.receive(Scalar::of(run.number(0.1)));
            run.tell(side.absorbed());
        })
    });
    every!(V {
        let side = TwoPortSide::<V>::new(DampingLimit::at(n(0.5))?);
        let side = DriftCompensated::new(side, n(0.25))?.meeting(n(2.0))?;
        run_with::<V, _>(ticks, "drift_compensated", side, |run, side| {
            side.receive(Scalar::of(run.number(0.1)));
            run.tell(side.absorbed());
        })
    });
    every!(V {
        let sharing = Sharing { start: n(0.01), share: n(0.125) };
        let side = TwoLayer::<Of<V>>::master(sharing, n(0.02), n(4.0))?;
        run_with::<V, _>(ticks, "two_layer", side, |run, side| {
            side.receive(Scalar::of(run.number(0.1)));
            run.tell(side.sent());
        })
    });
    Ok(())
}

/// Every tick of readings: `read` is told the time, the position, the velocity and the applied effort.
fn read<V: Named>(ticks: u64, name: &str, mut read: impl FnMut(f64, V, V, V) -> CheckedSample<V>) {
    let mut run = Run::begin(ticks);
    let mut now = 0.0;
    for _ in 0..run.ticks {
        let (position, velocity) = (run.signal(MOST[0]), run.signal(MOST[1]));
        let applied = run.signal(MOST[3]);
        now += run.period();
        let told = read(now, position, velocity, applied);
        run.tell_sample(&told.sample);
        let flags = [told.accepted, told.jumped, told.late, told.timed];
        run.hash(flags.iter().rev().fold(0, |sum, &flag| 2 * sum + u64::from(flag)));
    }
    run.end(name, V::NAME);
}

fn watching(ticks: u64) -> Done {
    every!(V {
        let mut observer = Observer::of((PortEnergy, Dissipation::of(n(0.5))?));
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let sample: PortSample<V> = run.sample();
            let sum: Of<V> = observer.observe(&sample, V::splat(n(0.0)));
            run.tell(sum);
        }
        run.end("observer", V::NAME)
    });
    fn fresh<V: Named>() -> Result<Readings<V>, ParameterError> {
        Readings::every(n(0.001))?.no_faster_than(n(16.0))
    }
    axes!(V {
        let mut it = fresh::<V>()?;
        read::<V>(ticks, "readings", |_, position, _, applied| it.read(Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.measured();
        read::<V>(ticks, "readings_measured", |_, position, velocity, applied| {
            it.read_moving(MovingReading { position, velocity, applied })
        })
    });
    axes!(V {
        let mut it = fresh::<V>()?.low_passed(n(30.0))?;
        read::<V>(ticks, "readings_low_passed", |_, position, _, applied| it.read(Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.windowed::<16>(8, n(0.001))?;
        read::<V>(ticks, "readings_windowed", |_, position, _, applied| it.read(Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.clocked();
        read::<V>(ticks, "readings_clocked", |now, position, _, applied| it.read_at(now, Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.measured().clocked();
        read::<V>(ticks, "readings_measured_clocked", |now, position, velocity, applied| {
            it.read_moving_at(now, MovingReading { position, velocity, applied })
        })
    });
    Ok(())
}

fn main() -> Done {
    let ticks = std::env::args().nth(1).and_then(|ticks| ticks.parse().ok()).unwrap_or(10_000);
    controllers(ticks)?;
    refined(ticks)?;
    family(ticks)?;
    watching(ticks)
}
