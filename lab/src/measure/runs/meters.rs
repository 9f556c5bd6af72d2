//! Measures along a run, lane by lane.

use lyapunov::{Scalar, Signal};

use super::outcome::Measures;
use crate::measure::chatter::Chatter;
use crate::measure::energies::Energies;
use crate::measure::force_felt::ForceFelt;
use crate::measure::given::Given;
use crate::measure::settling::Settling;
use crate::measure::stiffness_felt::StiffnessFelt;

/// Meter along runs side by side.
pub(crate) trait Meter<V: Signal> {
    /// Result of a lane.
    type Reading;

    /// A meter of runs at `rate` Hz about the place `rest` with a band, m, whose devices take `damper` N/m.
    fn new(rate: f64, damper: V::Scalar, rest_and_band: (V::Scalar, V::Scalar)) -> Self;

    /// Adds one more tick.
    fn add(&mut self, at: &Instant<V>);

    /// Result of a lane.
    fn read(&self, lane: usize, ran: Ran) -> Self::Reading;
}

/// Choice of a meter, whatever signal the runs have.
pub(crate) trait Metering {
    /// Result of a run.
    type Reading: Clone;

    /// The meter.
    type Meter<V: Signal>: Meter<V, Reading = Self::Reading>;
}

/// All measures of a map.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AllMeasures;

impl Metering for AllMeasures {
    type Reading = Measures;
    type Meter<V: Signal> = Meters<V>;
}

/// Meters of all measures of a run that does not grow.
#[derive(Clone, Debug)]
pub(crate) struct Meters<V: Signal> {
    peak: V::Scalar,
    active: V::Scalar,
    settling: Settling<V::Scalar>,
    energies: Energies<V>,
    given: Given<V>,
    force_felt: ForceFelt<V>,
    stiffness_felt: StiffnessFelt<V::Scalar>,
    chatter: Option<Chatter<V>>,
}

/// Quantities that are metered at a tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant<V: Signal> {
    /// The plant's position, m.
    pub(crate) position: V,
    /// The coordinate that the motion is judged along, m.
    pub(crate) coordinate: V::Scalar,
    /// The displacement since the last tick, m.
    pub(crate) moved: V,
    /// The work of the force on it since then, J.
    pub(crate) work: V::Scalar,
    /// The force on it from here on, N.
    pub(crate) applied: V,
    /// The environment's share of that, N.
    pub(crate) environment: V,
    /// The controller's share, N.
    pub(crate) controller: V,
    /// The magnitudes of the force and of the environment's share, N.
    pub(crate) magnitudes: [V::Scalar; 2],
    /// The injected damping, N·s/m.
    pub(crate) alpha: V::Scalar,
    /// The force of the environment's own law on the true motion, N.
    pub(crate) ideal: V,
    /// The depth below the surface of the environment, m, and the force against it, N.
    pub(crate) pressed: [V::Scalar; 2],
}

/// Facts about a run that a reading needs besides the metered quantities.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ran {
    /// The servo rate, Hz.
    pub(crate) rate: f64,
    /// The number of ticks.
    pub(crate) ticks: f64,
    /// The stiffness beyond the surface of the environment, N/m, if it has one.
    pub(crate) stiffness: Option<f64>,
}

impl<V: Signal> Meter<V> for Meters<V> {
    type Reading = Measures;

    fn new(rate: f64, damper: V::Scalar, (rest, band): (V::Scalar, V::Scalar)) -> Self {
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
    fn add(&mut self, at: &Instant<V>) {
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

    fn read(&self, lane: usize, ran: Ran) -> Measures {
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
