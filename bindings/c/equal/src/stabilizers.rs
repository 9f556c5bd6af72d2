//! Stabilizers over random ticks.

use lyapunov::accumulators::{Compensated, Plain};
use lyapunov::candidates::InContact;
use lyapunov::poses::Screw;
use lyapunov::stabilizers::{
    AlongDirection, AxisWeights, DirectedDamping, DriftCompensated, EnergyBounding, ForceBound,
    ForceBounding, InertiaLimit, InertiaMetric, JointInertia, LeastNorm, MemoryBased, PartLimits,
    PathMemory, PerAxis, PerPart, Plausibility, Sharing, SlopeBound, StabilizerExt, Tank,
    TankLimits, TwoLayer, TwoPortSide, WatchdogTimes, WindowedCredit,
};
use lyapunov::{
    DampingLimit, Dissipation, Lolc, LyapunovCandidate, ParameterError, Popc, PortEnergy,
    PortSample, Scalar, Signal, Stabilizer, StorageFunction,
};
use nalgebra::{SMatrix, SVector, Vector3, Vector6};

use crate::run::{MOST, Run};
use crate::signals::{Done, Named, Of, axes, bodies, each, every, line, n};

pub(crate) fn limit<T: Scalar>() -> Result<DampingLimit<T>, ParameterError> {
    DampingLimit::at(n(80.0))
}

pub(crate) type Inner<T> = Lolc<T, (PortEnergy, Dissipation<T>)>;

pub(crate) fn inner<T: Scalar>() -> Result<Inner<T>, ParameterError> {
    Lolc::new((PortEnergy, Dissipation::of(n(0.5))?), limit()?).budgeted(n(0.001))
}

/// Every tick of a stabilizer; `beside` is what is called once a tick after it.
pub(crate) fn run_with<V: Named, S: Stabilizer<V>>(
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

pub(crate) fn run<V: Named>(ticks: u64, name: &str, stabilizer: impl Stabilizer<V>) {
    run_with(ticks, name, stabilizer, |_, _| {});
}

/// The first number of a signal.
pub(crate) fn first<V: Signal>(signal: V) -> Of<V> {
    let mut found = None;
    signal.map(|axis| {
        found = found.or(Some(axis));
        axis
    });
    found.unwrap_or(Of::<V>::of(0.0))
}

/// Work and the credit of a quadratic drag, on the first axis.
pub(crate) struct Drag;

impl<V: Signal> LyapunovCandidate<V> for Drag {
    fn decrease(&mut self, sample: &PortSample<V>) -> Of<V> {
        let speed = first(sample.velocity);
        first(sample.work) + n::<Of<V>>(0.5) * speed * speed * sample.period
    }
}

pub(crate) fn energy<V: Signal>(position: V, velocity: V) -> Of<V> {
    let (place, speed) = (first(position), first(velocity));
    n::<Of<V>>(50.0) * place * place + n::<Of<V>>(0.5) * speed * speed
}

pub(crate) fn controllers(ticks: u64) -> Done {
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

pub(crate) fn refined(ticks: u64) -> Done {
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
    heavy(ticks)?;
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

pub(crate) fn plausibility<T: Scalar>() -> Plausibility<T> {
    Plausibility { speed: n(0.4), effort: n(9.0) }
}

pub(crate) fn times<T: Scalar>() -> WatchdogTimes<T> {
    WatchdogTimes { hold: n(0.003), rise: n(0.01) }
}

pub(crate) fn weighted<V: Named>(ticks: u64, weights: V) -> Done {
    let metric = AxisWeights::new(weights)?;
    run::<V>(ticks, "axis_weights", DirectedDamping::new(inner()?, metric, limit()?));
    Ok(())
}

pub(crate) fn along<V: Named>(ticks: u64, direction: V) -> Done {
    let metric = AlongDirection::new(direction)?;
    run::<V>(ticks, "along_direction", DirectedDamping::new(inner()?, metric, limit()?));
    Ok(())
}

pub(crate) fn directed(ticks: u64) -> Done {
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

/// Axes that an inertia couples, of which the lower triangle is given.
pub(crate) fn heavy(ticks: u64) -> Done {
    let three = [vec![0.5], vec![0.125, 0.25], vec![-0.0625, 0.03125, 0.125]];
    let six = [
        vec![2.0],
        vec![0.5, 1.5],
        vec![0.25, -0.125, 1.0],
        vec![0.0, 0.125, 0.25, 0.5],
        vec![0.0625, 0.0, 0.0, -0.0625, 0.25],
        vec![0.0, 0.03125, 0.0, 0.0, 0.015625, 0.125],
    ];
    fn of<T: Scalar, const N: usize>(rows: &[Vec<f32>; N]) -> SMatrix<T, N, N> {
        SMatrix::from_fn(|row, column| n(rows[row.max(column)][row.min(column)]))
    }
    fn metric<T: Scalar, const N: usize>(ticks: u64, inertia: SMatrix<T, N, N>) -> Done
    where
        SVector<T, N>: Named<Scalar = T>,
    {
        let damping = DirectedDamping::new(inner()?, InertiaMetric::new(inertia)?, limit()?);
        run::<SVector<T, N>>(ticks, "inertia_metric", damping);
        Ok(())
    }
    fn within<T: Scalar, const N: usize>(ticks: u64, inertia: SMatrix<T, N, N>) -> Done
    where
        SVector<T, N>: Named<Scalar = T>,
    {
        let inertia = JointInertia::new(inertia)?;
        let limited = InertiaLimit::new(inner()?, inertia, n(0.5), n(0.001))?.delayed(1);
        run::<SVector<T, N>>(ticks, "inertia_limit", limited);
        Ok(())
    }
    each!(T in [f32, f64] { metric::<T, 3>(ticks, of(&three))? });
    each!(T in [f32, f64] { metric::<T, 6>(ticks, of(&six))? });
    each!(T in [f32, f64] { within::<T, 3>(ticks, of(&three))? });
    each!(T in [f32, f64] { within::<T, 6>(ticks, of(&six))? });
    Ok(())
}

pub(crate) fn family(ticks: u64) -> Done {
    every!(V { run::<V>(ticks, "force_bound", ForceBound::<Of<V>>::new(n(0.5))?) });
    every!(V { run::<V>(ticks, "force_bounding", ForceBounding::<Of<V>>::of_damping(n(0.5))?) });
    every!(V {
        let store = TankLimits { start: n(0.01), floor: n(0.001), ceiling: n(0.02), power: n(1.0) };
        run::<V>(ticks, "tank", Tank::new((PortEnergy, Dissipation::of(n(0.5))?), store)?)
    });
    every!(V { run::<V>(ticks, "energy_bounding", EnergyBounding::<V>::of_damping(n(0.5), n(0.001))?.delayed(2)?) });
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
