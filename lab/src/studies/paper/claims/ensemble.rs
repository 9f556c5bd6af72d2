//! Ensemble: many runs at once, on lanes and cores.

use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, Observer, OnePort, ParameterError, Plant, PortEnergy,
    PortSample, Sampled, Scalar, Stabilizer, Work,
    accumulators::Plain,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
    stabilizers::NoStabilizer,
};
use pulp::NullaryFnOnce;
use rayon::prelude::*;

use super::measures::{Measures, WINDOW};
use super::member::Member;
use super::trace::{Point, Trace};
use crate::simulate::{F64x8, Instructions};

/// Stabilizer at the port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// Nothing.
    None,
    /// The passivity observer/controller.
    Popc,
    /// The Lyapunov observer/controller with the paper's candidate.
    Lolc,
}

/// The steps of a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// Ours: held work, and a damping of at most the cap times m / T.
    Ours,
    /// The paper's steps 4 to 6: sampled work, and any damping.
    Printed,
}

/// A controller in front of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loop {
    /// Stabilizer at the port.
    pub control: Control,
    /// Its steps.
    pub steps: Steps,
}

/// One run: a member of the ensemble in front of a wall.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    /// Everything but the wall.
    pub member: &'a Member,
    /// The wall's stiffness, N/m, and damping, N·s/m.
    pub wall: [f64; 2],
}

impl<'a> Run<'a> {
    /// Every member in front of the same wall.
    pub fn each(members: &'a [Member], wall: [f64; 2]) -> Vec<Self> {
        members.iter().map(|member| Self { member, wall }).collect()
    }
}

/// Measures of each run, in order.
///
/// # Errors
/// A number that a part rejects.
pub fn measured(looped: Loop, runs: &[Run<'_>]) -> Result<Vec<Measures>, ParameterError> {
    traced(looped, runs, WINDOW, Measures::of)
}

/// Trace of each run over `duration` s or until it is decided, in order.
///
/// # Errors
/// A number that a part rejects.
pub fn traces(looped: Loop, runs: &[Run<'_>], duration: f64) -> Result<Vec<Trace>, ParameterError> {
    traced(looped, runs, duration, Trace::clone)
}

/// The reading of each run's trace, in order. Runs at the same rate share lanes.
fn traced<R: Send>(
    looped: Loop,
    runs: &[Run<'_>],
    duration: f64,
    read: impl Fn(&Trace) -> R + Sync,
) -> Result<Vec<R>, ParameterError> {
    let mut order: Vec<usize> = (0..runs.len()).collect();
    order.sort_by(|one, other| runs[*one].member.rate().total_cmp(&runs[*other].member.rate()));
    let alike = order.chunk_by(|one, other| runs[*one].member.rate() == runs[*other].member.rate());
    let groups: Vec<&[usize]> = alike.flat_map(|places| places.chunks(Lanes::LANES)).collect();
    let read = |group: &&[usize]| -> Result<Vec<(usize, R)>, ParameterError> {
        let side_by_side: Vec<Run<'_>> = group.iter().map(|place| runs[*place]).collect();
        let traces = lanes(looped, &side_by_side, duration)?;
        Ok(group.iter().copied().zip(traces.iter().map(&read)).collect())
    };
    let readings: Result<Vec<_>, ParameterError> = groups.par_iter().map(read).collect();
    let mut readings: Vec<(usize, R)> = readings?.into_iter().flatten().collect();
    readings.sort_by_key(|(place, _)| *place);
    Ok(readings.into_iter().map(|(_, reading)| reading).collect())
}

type Lanes = F64x8;

/// The traces of runs at the same rate, no more than there are lanes.
fn lanes(looped: Loop, runs: &[Run<'_>], duration: f64) -> Result<Vec<Trace>, ParameterError> {
    let [first, ..] = runs else { return Ok(Vec::new()) };
    let ratio = first.member.scene.environment_ratio();
    let period = Lanes::of(first.member.scene.period());
    let (body, wall, limit) = parts(looped.steps, runs, period)?;
    let port = wall.held(u32::try_from(ratio).unwrap_or(u32::MAX))?;
    let credited = (PortEnergy, wall.dissipation());
    let (popc, lolc) = (Lolc::new(PortEnergy, limit), Lolc::new(credited, limit));
    let (work, with_credit) = (Observer::of(PortEnergy), Observer::of(credited));
    let sampled = work.over::<Sampled>();
    let sampled_credit = with_credit.over::<Sampled>();
    let start = Start { runs, duration, plant: body };
    Ok(match (looped.control, looped.steps) {
        (Control::None, _) => start.traces(port, NoStabilizer, work),
        (Control::Popc, Steps::Ours) => start.traces(port, popc, work),
        (Control::Popc, Steps::Printed) => start.traces(port, popc.sampled(), sampled),
        (Control::Lolc, Steps::Ours) => start.traces(port, lolc, with_credit),
        (Control::Lolc, Steps::Printed) => start.traces(port, lolc.sampled(), sampled_credit),
    })
}

type Parts = (Body<Lanes>, Wall<Lanes>, DampingLimit<Lanes>);

/// Plant, wall and damping limit with the numbers of each lane; lanes beyond the last run repeat it.
fn parts(steps: Steps, runs: &[Run<'_>], period: Lanes) -> Result<Parts, ParameterError> {
    let each = |number: &dyn Fn(&Run<'_>) -> f64| {
        Lanes::from_lanes(|lane| number(&runs[lane.min(runs.len() - 1)]))
    };
    let hand = Impedance {
        mass: each(&|run| run.member.scene.port_mass()),
        damping: each(&|run| {
            run.member.scene.operator.damping.get() + run.member.scene.device.damping.get()
        }),
        stiffness: each(&|run| run.member.scene.operator.stiffness.get()),
    };
    let place = each(&|run| run.member.scene.initial.position.get());
    let body = Body::new(hand, period)?
        .starting(place, each(&|run| run.member.scene.initial.velocity.get()));
    let wall = Wall::new(each(&|run| run.wall[0]), each(&|run| run.wall[1]))?;
    let cap = match steps {
        Steps::Ours => each(&|run| run.member.cap),
        Steps::Printed => Lanes::of(f64::INFINITY),
    };
    let limit = DampingLimit::of_mass(cap, each(&|run| run.member.limit_mass), period)?;
    Ok((body, wall, limit))
}

/// Runs side by side before their first tick.
struct Start<'a> {
    runs: &'a [Run<'a>],
    duration: f64,
    plant: Body<Lanes>,
}

impl Start<'_> {
    /// The traces, on the best instructions that the processor has.
    fn traces<C: LyapunovCandidate<Lanes>, W: Work>(
        self,
        port: impl OnePort<Lanes>,
        stabilizer: impl Stabilizer<Lanes>,
        observer: Observer<C, W, Plain<Lanes>>,
    ) -> Vec<Trace> {
        Instructions::best().run(Rollout { start: self, port, stabilizer, observer })
    }
}

/// Runs side by side in front of a port.
struct Rollout<'a, P, S, O> {
    start: Start<'a>,
    port: P,
    stabilizer: S,
    observer: O,
}

impl<P, S, C, W> NullaryFnOnce for Rollout<'_, P, S, Observer<C, W, Plain<Lanes>>>
where
    P: OnePort<Lanes>,
    S: Stabilizer<Lanes>,
    C: LyapunovCandidate<Lanes>,
    W: Work,
{
    type Output = Vec<Trace>;

    #[inline(always)]
    fn call(self) -> Vec<Trace> {
        let Self { start, mut port, mut stabilizer, mut observer } = self;
        let Start { runs, duration, mut plant } = start;
        let blank = |run: &Run<'_>| Trace::new(run.member.scene.period(), run.member.start);
        let mut traces: Vec<Trace> = runs.iter().map(blank).collect();
        let ticks = traces.first().map_or(0, |trace| trace.ticks(duration));
        let mut sample = plant.start();
        for _ in 0..=ticks {
            let velocity = sample.displacement / sample.period;
            let seen = PortSample { velocity, ..sample };
            let force = port.respond(&seen);
            let correction = stabilizer.stabilize(&seen, force);
            let booked = observer.decrease(&seen, force);
            for (lane, trace) in traces.iter_mut().enumerate() {
                trace.push(Point {
                    x: sample.position.lane(lane),
                    v: velocity.lane(lane),
                    force: force.lane(lane),
                    alpha: correction.alpha.lane(lane),
                    observed_energy: correction.observed_energy.lane(lane),
                    booked: booked.lane(lane),
                });
            }
            if traces.iter().all(Trace::is_decided) {
                break;
            }
            sample = plant.advance(correction.effort);
        }
        traces
    }
}
