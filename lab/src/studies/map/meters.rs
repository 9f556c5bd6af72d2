//! Measures along a run, lane by lane.

use lyapunov::{Scalar, Signal};

use super::outcome::Measures;
use crate::measure::{Chatter, Energies, ForceFelt, Given, Settling, StiffnessFelt};

/// Meters of all measures of a run that does not grow.
#[derive(Clone, Debug)]
pub(super) struct Meters<V: Signal> {
    peak: V::Scalar,
    active: V::Scalar,
    settling: Settling<V::Scalar>,
    energies: Energies<V>,
    given: Given<V>,
    force_felt: ForceFelt<V>,
    stiffness_felt: StiffnessFelt<V::Scalar>,
    chatter: Option<Chatter<V>>,
}

/// What is metered at a tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant<V: Signal> {
    /// The plant's position, m.
    pub(super) position: V,
    /// The coordinate that the motion is judged along, m.
    pub(super) coordinate: V::Scalar,
    /// The displacement since the last tick, m.
    pub(super) moved: V,
    /// The work of the force on it since then, J.
    pub(super) work: V::Scalar,
    /// The force on it from here on, N.
    pub(super) applied: V,
    /// The environment's share of that, N.
    pub(super) environment: V,
    /// The controller's share, N.
    pub(super) controller: V,
    /// The magnitudes of the force and of the environment's share, N.
    pub(super) magnitudes: [V::Scalar; 2],
    /// The injected damping, N·s/m.
    pub(super) alpha: V::Scalar,
    /// The force of the environment's own law on the true motion, N.
    pub(super) ideal: V,
    /// The depth below the surface of the environment, m, and the force against it, N.
    pub(super) pressed: [V::Scalar; 2],
}

/// What a reading needs besides what was metered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ran {
    /// The servo rate, Hz.
    pub(super) rate: f64,
    /// The number of ticks.
    pub(super) ticks: f64,
    /// The stiffness beyond the surface of the environment, N/m, if it has one.
    pub(super) stiffness: Option<f64>,
}

impl<V: Signal> Meters<V> {
    /// Meters of runs at `rate` Hz about the place `rest` with a band, m, whose devices take `damper` N/m.
    pub(super) fn new(rate: f64, damper: V::Scalar, (rest, band): (V::Scalar, V::Scalar)) -> Self {
        Self {
            peak: V::Scalar::of(0.0),
            active: V::Scalar::of(0.0),
            settling: Settling::new(rest, band),
            energies: Energies::new(),
            given: Given::new(damper),
            force_felt: ForceFelt::new(),
            stiffness_felt: StiffnessFelt::new(rate),
            chatter: Chatter::new(rate),
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, at: &Instant<V>) {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let ([force, environment], [depth, against]) = (at.magnitudes, at.pressed);
        self.peak = force.larger(self.peak);
        self.active += V::Scalar::choose(at.alpha.above(zero), one, zero);
        self.settling.add(at.coordinate);
        self.energies.add(at.position, at.environment, at.controller);
        self.given.add(at.work, at.moved);
        self.force_felt.add(at.applied, at.ideal);
        self.stiffness_felt.add(against, environment, depth);
        if let Some(chatter) = &mut self.chatter {
            chatter.add(at.applied);
        }
    }

    /// Measures of a lane.
    pub(super) fn read(&self, lane: usize, ran: Ran) -> Measures {
        let chatter = self.chatter.as_ref().and_then(Chatter::root_mean_square);
        let millijoules = |energy: V::Scalar| Some(1e3 * energy.lane(lane));
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
