//! Measures along a run, lane by lane.

use lyapunov::Scalar;

use super::outcome::Measures;
use crate::measure::{Chatter, Energies, ForceFelt, Given, Settling, StiffnessFelt};

/// Meters of all measures of a run that does not grow.
#[derive(Clone, Debug)]
pub(super) struct Meters<T> {
    peak: T,
    active: T,
    settling: Settling<T>,
    energies: Energies<T>,
    given: Given<T>,
    force_felt: ForceFelt<T>,
    stiffness_felt: StiffnessFelt<T>,
    chatter: Option<Chatter<T>>,
}

/// What is metered at a tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant<T> {
    /// The plant's position, m.
    pub(super) position: T,
    /// Its displacement since the last tick, m.
    pub(super) moved: T,
    /// The work of the force on it since then, J.
    pub(super) work: T,
    /// The force on it from here on, N.
    pub(super) applied: T,
    /// The environment's share of that, N.
    pub(super) environment: T,
    /// The controller's share, N.
    pub(super) controller: T,
    /// The injected damping, N·s/m.
    pub(super) alpha: T,
    /// The force of the environment's own law on the true motion, N.
    pub(super) ideal: T,
    /// The depth in the wall, m.
    pub(super) depth: T,
}

/// What a reading needs besides what was metered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ran {
    /// The servo rate, Hz.
    pub(super) rate: f64,
    /// The number of ticks.
    pub(super) ticks: f64,
    /// The stiffness of the wall, N/m, if the environment is one.
    pub(super) stiffness: Option<f64>,
}

impl<T: Scalar> Meters<T> {
    /// Meters of runs at `rate` Hz about the place `rest` with a band, m, whose devices take `damper` N/m.
    pub(super) fn new(rate: f64, damper: T, (rest, band): (T, T)) -> Self {
        Self {
            peak: T::zero(),
            active: T::zero(),
            settling: Settling::new(rest, band),
            energies: Energies::new(),
            given: Given::new(damper),
            force_felt: ForceFelt::new(),
            stiffness_felt: StiffnessFelt::new(rate),
            chatter: Chatter::new(rate),
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, at: &Instant<T>) {
        self.peak = at.applied.magnitude().larger(self.peak);
        self.active += T::choose(at.alpha.above(T::zero()), T::one(), T::zero());
        self.settling.add(at.position);
        self.energies.add(at.position, at.environment, at.controller);
        self.given.add(at.work, at.moved);
        self.force_felt.add(at.applied, at.ideal);
        self.stiffness_felt.add(at.applied, at.environment, at.depth);
        if let Some(chatter) = &mut self.chatter {
            chatter.add(at.applied);
        }
    }

    /// Measures of a lane.
    pub(super) fn read(&self, lane: usize, ran: Ran) -> Measures {
        let chatter = self.chatter.as_ref().and_then(Chatter::root_mean_square);
        let millijoules = |energy: T| Some(1e3 * energy.lane(lane));
        let felt = self.stiffness_felt.stiffness(lane).zip(ran.stiffness);
        Measures {
            peak_force: Some(self.peak.lane(lane)),
            settling_time: self.settling.since(lane).map(|tick| tick / ran.rate),
            energy_injected: millijoules(self.energies.injected()),
            energy_taken: millijoules(self.energies.taken()),
            active: Some(100.0 * self.active.lane(lane) / ran.ticks),
            chatter: chatter.map(|chatter| chatter.lane(lane)),
            energy_given: millijoules(self.given.by_port()),
            energy_given_beyond_damper: millijoules(self.given.beyond_damper()),
            force_felt: self.force_felt.percent(lane),
            stiffness_felt: felt.map(|(felt, asked)| 100.0 * felt / asked),
        }
        .in_range()
    }
}
