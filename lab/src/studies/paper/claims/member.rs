//! Member of the ensemble: the paper's section IV with what it does not state drawn by chance.

use crate::files::scene::{Conflict, Finite, Positive, Scene};
use crate::simulate::ensemble::{Constant, Ensemble, Moves};
use crate::studies::paper::{Case, PaperError};
use crate::text::found;

/// The paper's start, m.
pub const START: f64 = -0.004;
/// The rates of the observer, Hz; the wall stays at the first.
pub const RATES: [f64; 4] = [100.0, 200.0, 500.0, 1000.0];
/// The least and the largest damping cap, as a share of m / T.
const CAPS: [f64; 2] = [0.25, 1.0];
/// The cap at the paper's numbers.
const USUAL_CAP: f64 = 0.5;
/// The largest change of the start, as a share of it.
const START_MOVES: f64 = 0.1;
/// Groups of a constant that is drawn evenly.
const EIGHTHS: usize = 8;

/// Draws of an ensemble that belong to this study.
mod draws {
    pub(super) const LIMIT_MASS: u64 = 17;
    pub(super) const CAP: u64 = 18;
    pub(super) const START: u64 = 19;
    /// A stiffness and a damping for each wall, from here on.
    pub(super) const WALLS: u64 = 32;
}

/// What the paper does not state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unstated {
    /// Time from the moment the plant reaches the wall to the wall's next tick. With everything else given it tells the
    /// phase of the clock at the release, and it is as evenly spread.
    ContactPhase,
    /// The operator's mass.
    OperatorMass,
    /// The device's mass.
    DeviceMass,
    /// The operator's damping.
    OperatorDamping,
    /// The device's damping.
    DeviceDamping,
    /// The stiffness of the operator's spring.
    HandStiffness,
    /// The rate of the observer.
    ObserverRate,
    /// The mass that limits the damping.
    LimitMass,
    /// The damping cap.
    Cap,
    /// The start.
    Start,
}

impl Unstated {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::ContactPhase,
        Self::OperatorMass,
        Self::DeviceMass,
        Self::OperatorDamping,
        Self::DeviceDamping,
        Self::HandStiffness,
        Self::ObserverRate,
        Self::LimitMass,
        Self::Cap,
        Self::Start,
    ];

    /// Its name in a verdict.
    pub fn name(self) -> &'static str {
        match self {
            Self::ContactPhase => "the clock's phase",
            Self::OperatorMass => "the operator's mass",
            Self::DeviceMass => "the device's mass",
            Self::OperatorDamping => "the operator's damping",
            Self::DeviceDamping => "the device's damping",
            Self::HandStiffness => "the hand's stiffness",
            Self::ObserverRate => "the observer's rate",
            Self::LimitMass => "the mass for the cap",
            Self::Cap => "the cap",
            Self::Start => "the start",
        }
    }

    /// The order of its groups, in words.
    pub(in super::super) fn order(self) -> &'static str {
        match self {
            Self::ContactPhase => "from touching the wall to its next tick, in eighths of a tick",
            Self::ObserverRate => "100, 200, 500 and 1000 Hz over a wall at 100 Hz",
            Self::LimitMass => "operator and device, device alone",
            Self::Cap => "from 0.25 to 1, in eighths",
            _ => "from -10 % to +10 %, in eighths",
        }
    }

    /// The groups of its values, in words.
    pub fn groups(self) -> Vec<String> {
        let (low, high) = match self {
            Self::ObserverRate => return RATES.map(|rate| format!("{rate} Hz")).to_vec(),
            Self::LimitMass => return ["total", "device alone"].map(str::to_owned).to_vec(),
            Self::ContactPhase => (0.0, 1.0),
            Self::Cap => (CAPS[0], CAPS[1]),
            _ => (0.9, 1.1),
        };
        let end = |index: usize| low + (high - low) * index as f64 / EIGHTHS as f64;
        (0..EIGHTHS)
            .map(|index| format!("{} to {}", found(end(index)), found(end(index + 1))))
            .collect()
    }
}

/// Section IV of the paper with everything given: masses, dampings, stiffness, rates, start and limit of the damping.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// Operator, device and rates, and the state in which the first tick finds the plant. The wall is no part of it.
    pub scene: Scene,
    /// Distance from the wall at which the plant is released, m.
    pub start: f64,
    /// The damping cap, as a share of m / T.
    pub cap: f64,
    /// The mass m for the cap, kg.
    pub limit_mass: f64,
    /// Stiffnesses, N/m, and dampings, N·s/m, of walls on which stabilizers are compared.
    pub walls: Vec<[f64; 2]>,
    groups: [usize; Unstated::ALL.len()],
}

impl Member {
    /// The member at the paper's numbers, in this repository's reading: the clock starts at the release, everything at
    /// 100 Hz, half of m / T with the mass of operator and device.
    ///
    /// # Errors
    /// None as long as the shipped scene files are valid.
    pub fn of_the_paper() -> Result<Self, PaperError> {
        let scene = Case::Plain8k.scene()?;
        let mass = scene.port_mass();
        Ok(Self::new(scene, -START, USUAL_CAP, mass))
    }

    /// `count` members, drawn with `seed`.
    ///
    /// # Errors
    /// None as long as the shipped scene files are valid.
    pub fn draw(seed: u64, count: u64) -> Result<Vec<Self>, PaperError> {
        let paper = Case::Plain8k.scene()?;
        let ensemble = Ensemble { seed, moves: Moves::default() };
        let draw = |member| Self::drawn(&ensemble, &paper, member).map_err(PaperError::Draw);
        (0..count).map(draw).collect()
    }

    fn drawn(ensemble: &Ensemble, paper: &Scene, member: u64) -> Result<Self, Conflict> {
        let uniform = |quantity| ensemble.uniform(member, quantity);
        // Every rate as often as the others: a share over all of them must not hang on how often one was drawn.
        let index = (member % RATES.len() as u64) as usize;
        let start = START * (1.0 + START_MOVES * (2.0 * uniform(draws::START) - 1.0));
        let mut draft = paper.to_draft();
        draft.environment_rate = Some(paper.servo_rate);
        let refused = |error: &dyn std::fmt::Display| {
            Conflict::new("servo_rate", format!("a drawn number {error}"), "report this")
        };
        draft.servo_rate = Positive::new(RATES[index]).map_err(|error| refused(&error))?;
        draft.initial.position = Finite::new(start).map_err(|error| refused(&error))?.into();
        let scene = ensemble.member(&draft, member)?;
        let alone = uniform(draws::LIMIT_MASS) < 0.5;
        let mass = if alone { scene.device.mass.get() } else { scene.port_mass() };
        let cap = CAPS[0] + (CAPS[1] - CAPS[0]) * uniform(draws::CAP);
        let mut drawn = Self::new(scene, -start, cap, mass);
        drawn.walls = (0..super::WALLS).map(|wall| wall_of(wall, &uniform)).collect();
        let eighth = |uniform: f64| (uniform * EIGHTHS as f64) as usize;
        drawn.groups = Unstated::ALL.map(|unstated| match unstated {
            Unstated::ContactPhase => eighth(drawn.contact_phase()),
            Unstated::OperatorMass => eighth(ensemble.drawn(member, Constant::OperatorMass)),
            Unstated::DeviceMass => eighth(ensemble.drawn(member, Constant::DeviceMass)),
            Unstated::OperatorDamping => eighth(ensemble.drawn(member, Constant::OperatorDamping)),
            Unstated::DeviceDamping => eighth(ensemble.drawn(member, Constant::DeviceDamping)),
            Unstated::HandStiffness => eighth(ensemble.drawn(member, Constant::OperatorStiffness)),
            Unstated::ObserverRate => index,
            Unstated::LimitMass => usize::from(alone),
            Unstated::Cap => eighth(uniform(draws::CAP)),
            Unstated::Start => eighth(uniform(draws::START)),
        });
        Ok(drawn)
    }

    fn new(scene: Scene, start: f64, cap: f64, limit_mass: f64) -> Self {
        let groups = [0; Unstated::ALL.len()];
        Self { scene, start, cap, limit_mass, walls: Vec::new(), groups }
    }

    /// The rate of the observer, Hz.
    pub fn rate(&self) -> f64 {
        self.scene.servo_rate.get()
    }

    /// The group of this member's value among [`Unstated::groups`].
    pub fn group(&self, unstated: Unstated) -> usize {
        self.groups[unstated as usize]
    }

    /// Time from the moment the plant reaches the wall to the wall's next tick, in periods of the wall.
    ///
    /// Free motion from `x`, `v` is `exp(−λ t) (x cos ω t + (v + λ x)/ω sin ω t)`, which first passes 0 at the angle
    /// `ω t` between 0 and π whose tangent is `−ω x / (v + λ x)`.
    pub fn contact_phase(&self) -> f64 {
        let scene = &self.scene;
        let decay =
            (scene.operator.damping.get() + scene.device.damping.get()) / (2.0 * scene.port_mass());
        let frequency = (scene.operator.stiffness.get() / scene.port_mass() - decay * decay).sqrt();
        let (x, v) = (scene.initial.position.get(), scene.initial.velocity.get());
        let time = libm::atan2(-frequency * x, v + decay * x) / frequency;
        let ticks = time * scene.environment_rate();
        ticks.ceil() - ticks
    }
}

/// The wall with this number, of a stiffness from 1 to 50 kN/m, in even ratios, each from its own part of the range, and
/// a damping from 0 to 100 N·s/m.
fn wall_of(wall: usize, uniform: &impl Fn(u64) -> f64) -> [f64; 2] {
    let draw = draws::WALLS + 2 * wall as u64;
    let part = (wall as f64 + uniform(draw)) / super::WALLS as f64;
    [1e3 * libm::pow(50.0, part), 100.0 * uniform(draw + 1)]
}
