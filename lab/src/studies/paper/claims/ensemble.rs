//! Ensemble: many starts of one loop at once, on lanes and cores.

use lyapunov::lanes::AutoF64x8;
use lyapunov::{
    DampingLimit, Lolc, LyapunovCandidate, Observer, OnePort, ParameterError, Plant, PortEnergy,
    PortSample, Sampled, Scalar, Stabilizer, Work,
    accumulators::Plain,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
    stabilizers::NoStabilizer,
};
use rayon::prelude::*;

/// Simulated time of every run, s.
pub const DURATION: f64 = 30.0;
/// The paper's start, m.
pub const START: f64 = -0.004;

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

/// A loop of the paper's section IV: its operator, its device and a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// The wall's stiffness, N/m.
    pub stiffness: f64,
    /// The wall's damping, N·s/m.
    pub damping: f64,
    /// Stabilizer at the port.
    pub control: Control,
    /// Whether the observer books the paper's sampled work instead of held work.
    pub printed: bool,
    /// The damping cap, as a share of m / T.
    pub cap: f64,
    /// The servo rate, Hz; the wall stays at 100 Hz.
    pub servo_rate: f64,
}

impl Setting {
    /// Setting in this repository's reading of the paper: held work, half of m / T, everything at 100 Hz.
    pub fn read(stiffness: f64, damping: f64, control: Control) -> Self {
        Self { stiffness, damping, control, printed: false, cap: 0.5, servo_rate: 100.0 }
    }

    /// The period, s.
    pub fn period(&self) -> f64 {
        self.servo_rate.recip()
    }

    fn ticks(&self) -> usize {
        (DURATION * self.servo_rate).round() as usize
    }
}

/// Trace of one run, one number per tick, from tick 0 on.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// The period, s.
    pub period: f64,
    /// Position, m.
    pub x: Vec<f64>,
    /// The velocity that the observer sees, m/s.
    pub v: Vec<f64>,
    /// The wall's force, N.
    pub force: Vec<f64>,
    /// The damping injected, N·s/m.
    pub alpha: Vec<f64>,
    /// The observed energy, J.
    pub observed_energy: Vec<f64>,
    /// The energy that the tick adds to the observed energy, J, also where the observed energy is too large to show it.
    pub booked: Vec<f64>,
}

/// The `count` starts, evenly spaced within 10 % of the paper's.
pub fn starts(count: usize) -> Vec<f64> {
    let share = |index: usize| 2.0 * index as f64 / (count.max(2) - 1) as f64 - 1.0;
    (0..count).map(|index| START * (1.0 + 0.1 * share(index))).collect()
}

/// One trace for each start.
///
/// # Errors
/// A number of the setting that a part rejects.
pub fn run(setting: &Setting, starts: &[f64]) -> Result<Vec<Trace>, ParameterError> {
    let chunks: Result<Vec<Vec<Trace>>, ParameterError> =
        starts.par_chunks(AutoF64x8::LANES).map(|chunk| lanes(setting, chunk)).collect();
    Ok(chunks?.into_iter().flatten().collect())
}

type Lanes = AutoF64x8;

fn lanes(setting: &Setting, starts: &[f64]) -> Result<Vec<Trace>, ParameterError> {
    let of = Lanes::of;
    let start = Lanes::from_lanes(|lane| starts.get(lane).copied().unwrap_or(START));
    let period = of(setting.period());
    let operator = Impedance { mass: of(0.1), damping: of(0.2), stiffness: of(50.0) };
    let device = Impedance { mass: of(0.2), damping: of(0.001), stiffness: of(0.0) };
    let hand = operator + device;
    let plant = Body::new(hand, period)?.starting(start, of(0.0));
    let wall = Wall::new(of(setting.stiffness), of(setting.damping))?;
    let limit = DampingLimit::of_mass(of(setting.cap), hand.mass, period)?;
    let port = wall.held((setting.servo_rate / 100.0).round() as u32)?;
    let credited = (PortEnergy, wall.dissipation());
    let (popc, lolc) = (Lolc::new(PortEnergy, limit), Lolc::new(credited, limit));
    let (work, with_credit) = (Observer::of(PortEnergy), Observer::of(credited));
    let sampled = work.booking::<Sampled, Plain<Lanes>, Lanes>();
    let sampled_credit = with_credit.booking::<Sampled, Plain<Lanes>, Lanes>();
    let mut traces = match (setting.control, setting.printed) {
        (Control::None, _) => gather(setting, plant, port, NoStabilizer, work),
        (Control::Popc, false) => gather(setting, plant, port, popc, work),
        (Control::Popc, true) => gather(setting, plant, port, popc.sampled(), sampled),
        (Control::Lolc, false) => gather(setting, plant, port, lolc, with_credit),
        (Control::Lolc, true) => gather(setting, plant, port, lolc.sampled(), sampled_credit),
    };
    traces.truncate(starts.len());
    Ok(traces)
}

fn gather<C: LyapunovCandidate<Lanes>, W: Work>(
    setting: &Setting,
    mut plant: Body<Lanes>,
    mut port: impl OnePort<Lanes>,
    mut stabilizer: impl Stabilizer<Lanes>,
    mut observer: Observer<C, W, Plain<Lanes>>,
) -> Vec<Trace> {
    let blank = Trace { period: setting.period(), ..Trace::default() };
    let mut traces = vec![blank; Lanes::LANES];
    let mut sample = plant.start();
    for _ in 0..=setting.ticks() {
        let velocity = sample.displacement / sample.period;
        let seen = PortSample { velocity, ..sample };
        let force = port.respond(&seen);
        let correction = stabilizer.stabilize(&seen, force);
        let booked = observer.decrease(&seen, force);
        for (lane, trace) in traces.iter_mut().enumerate() {
            trace.x.push(sample.position.lane(lane));
            trace.v.push(velocity.lane(lane));
            trace.force.push(force.lane(lane));
            trace.alpha.push(correction.alpha.lane(lane));
            trace.observed_energy.push(correction.observed_energy.lane(lane));
            trace.booked.push(booked.lane(lane));
        }
        sample = plant.advance(correction.effort);
    }
    traces
}
