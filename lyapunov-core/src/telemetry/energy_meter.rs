//! Energies at a port, summed while the loop runs.

use crate::{
    Accumulator, Compensated, Correction, Mask, ParameterError, PortSample, Requirement, Scalar,
    Signal, Snapshot,
};

/// Energies at a port since the start of the loop.
///
/// ```
/// use lyapunov_core::telemetry::EnergyMeter;
/// use lyapunov_core::{Correction, HeldTick};
/// let mut meter = EnergyMeter::new();
/// let tick = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: -2.0 };
/// let correction = Correction { observed_energy: -2e-4, alpha: 15.0, shortfall: 5e-5, ..Correction::none(1.5) };
/// meter.add(&tick.sample(), &correction); // the port gave 0.2 mJ away
/// let summary = meter.summary();
/// assert_eq!((summary.ticks, summary.active, summary.least), (1, 1.0, -2e-4));
/// assert_eq!((summary.absorbed, summary.asked), (-2e-4, 15.0 * (0.1 * 0.1 * 1e-3)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EnergySummary<T> {
    /// Number of ticks.
    pub ticks: u64,
    /// Number of ticks with an injected damping above 0; a scalar, since each lane counts its own.
    pub active: T,
    /// Number of ticks whose sample was not accepted, likewise.
    pub rejected: T,
    /// The observed energy `L` now, J.
    pub now: T,
    /// The least observed energy so far, J; where it is below 0 it is the largest debt, with its sign.
    pub least: T,
    /// The most observed energy so far, J.
    pub most: T,
    /// Energy that the injected damping was meant to dissipate, `Σ α v² T`, J; under a hold, a saturation or a delay it
    /// dissipates less.
    pub asked: T,
    /// Energy that flowed through the port into the environment, `Σ f_act Δx`, J: the physical energy, without what a
    /// candidate credits. Below 0 the port gave energy away.
    pub absorbed: T,
    /// The shortfall now, J.
    pub shortfall: T,
    /// The largest shortfall so far, J.
    pub largest_shortfall: T,
}

#[cfg(feature = "approx")]
impl<T> EnergySummary<T> {
    /// Whether both are of as many ticks.
    pub(crate) fn of_as_many_ticks(&self, other: &Self) -> bool {
        self.ticks == other.ticks
    }
}

/// Running sums behind an [`EnergySummary`], with compensation of rounding errors: in `f32` too they hold for a year.
///
/// Work or a dissipated energy that is not finite is left out, as a ledger leaves it out, and so is an observed energy of
/// NaN from the least and the most. Lanes are counted one by one.
///
/// ```
/// use lyapunov_core::telemetry::EnergyMeter;
/// use lyapunov_core::{Correction, HeldTick};
/// let mut meter = EnergyMeter::<f32>::new();
/// for applied in [2.0, f32::NAN, -2.0] {
///     let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 0.25, displacement: 0.25, applied };
///     meter.add(&tick.sample(), &Correction { accepted: applied.is_finite(), ..Correction::none(0.0) });
/// }
/// let summary = meter.summary();
/// assert_eq!((summary.ticks, summary.rejected, summary.absorbed), (3, 1.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyMeter<T> {
    ticks: u64,
    active: Compensated<T>,
    rejected: Compensated<T>,
    asked: Compensated<T>,
    absorbed: Compensated<T>,
    now: T,
    least: T,
    most: T,
    shortfall: T,
    largest_shortfall: T,
}

impl<T: Scalar> EnergyMeter<T> {
    /// A meter that has seen no tick.
    pub fn new() -> Self {
        let (zero, none) = (T::of(0.0), Compensated::zero());
        Self {
            ticks: 0,
            active: none,
            rejected: none,
            asked: none,
            absorbed: none,
            now: zero,
            least: zero,
            most: zero,
            shortfall: zero,
            largest_shortfall: zero,
        }
    }

    /// Adds a tick.
    #[inline]
    pub fn add<V: Signal<Scalar = T>>(
        &mut self,
        sample: &PortSample<V>,
        correction: &Correction<V>,
    ) {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        // Least and most are NaN together, as long as each energy is; every number has a magnitude above −1.
        let number = self.least.magnitude().above(-one);
        let first = T::Mask::of(self.ticks == 0) | !number;
        self.ticks = self.ticks.wrapping_add(1);
        self.now = correction.observed_energy;
        self.least = T::choose(first, self.now, self.now.smaller(self.least));
        self.most = T::choose(first, self.now, self.now.larger(self.most));
        self.shortfall = correction.shortfall;
        self.largest_shortfall = self.shortfall.larger(self.largest_shortfall);

        self.active.add(T::choose(correction.alpha.above(zero), one, zero));
        self.rejected.add(T::choose(correction.accepted, zero, one));
        let square = sample.velocity.inner(sample.velocity) * sample.period.larger(zero);
        self.asked.book(correction.alpha * square);
        self.absorbed.book(sample.work.sum());
    }

    /// The energies up to now.
    pub fn summary(&self) -> EnergySummary<T> {
        EnergySummary {
            ticks: self.ticks,
            active: self.active.value(),
            rejected: self.rejected.value(),
            now: self.now,
            least: self.least,
            most: self.most,
            asked: self.asked.value(),
            absorbed: self.absorbed.value(),
            shortfall: self.shortfall,
            largest_shortfall: self.largest_shortfall,
        }
    }
}

impl<T: Scalar> Default for EnergyMeter<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Scalar> Snapshot for EnergyMeter<T> {
    /// Ticks; the compensated sums of active and rejected ticks, of the energy asked for and absorbed; now, least, most,
    /// shortfall and the largest shortfall. An energy may be NaN.
    type State = (u64, [(T, T); 4], [T; 5]);

    fn state(&self) -> Self::State {
        let sums = [self.active, self.rejected, self.asked, self.absorbed];
        let last = [self.now, self.least, self.most, self.shortfall, self.largest_shortfall];
        (self.ticks, sums.map(|sum| sum.state()), last)
    }

    fn restored(self, (ticks, sums, last): Self::State) -> Result<Self, ParameterError> {
        for energy in last {
            Requirement::Finite.check_known("stored energy", energy)?;
        }
        let [now, least, most, shortfall, largest_shortfall] = last;
        let [active, rejected, asked, absorbed] = sums;
        Ok(Self {
            ticks,
            active: self.active.restored(active)?,
            rejected: self.rejected.restored(rejected)?,
            asked: self.asked.restored(asked)?,
            absorbed: self.absorbed.restored(absorbed)?,
            now,
            least,
            most,
            shortfall,
            largest_shortfall,
        })
    }
}
