//! Outcome of a cell under one stabilizer.

use crate::measure::verdict::{Verdict, Yardstick};

/// Outcome of a cell under one stabilizer; docs/compare.md defines every number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The verdict on the run.
    pub verdict: Verdict,
    /// The quantity that the run is judged by.
    pub verdict_by: Yardstick,
    /// The measures; of a run that grows none, because they would only show how long it ran.
    pub measures: Measures,
}

impl Outcome {
    /// The outcome of a run with these measures, as far as they go with its verdict: only what settles has a settling time, as
    /// others are within the band by the phase of their last swing.
    pub(crate) fn of(verdict: Verdict, verdict_by: Yardstick, measures: Measures) -> Self {
        let settling_time = measures.settling_time.filter(|_| verdict == Verdict::Settles);
        Self { verdict, verdict_by, measures: Measures { settling_time, ..measures } }
    }
}

/// Measures of a run; none where one does not apply or is out of range.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// Largest force on the plant, N.
    pub peak_force: Option<f64>,
    /// Time from which on the plant stays in the band about its equilibrium, s; of an [`Outcome`] none unless it settles.
    pub settling_time: Option<f64>,
    /// The energy that the environment gave out beyond what it absorbed, mJ.
    pub energy_injected: Option<f64>,
    /// The energy that the controller's force took out of the motion, mJ.
    pub energy_taken: Option<f64>,
    /// Share of the ticks on which damping was injected, percent; none under a law that adds no damping.
    pub active: Option<f64>,
    /// Root mean square of the force on the plant between 5 and 50 Hz, N.
    pub chatter: Option<f64>,
    /// The most that the port had physically given beyond all it had taken, mJ.
    pub energy_given: Option<f64>,
    /// The most that the port had given beyond what it and the device's damper had taken, mJ.
    pub energy_given_beyond_damper: Option<f64>,
    /// Force on the plant, in percent of the environment's own law on the true motion.
    pub force_felt: Option<f64>,
    /// Stiffness felt in contacts of half a second or more, in percent of the wall's.
    pub stiffness_felt: Option<f64>,
}

/// The number of measures.
const COUNT: usize = 10;

/// A number of [`Measures`], by its key.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// Its key in the table, unit included.
    pub key: &'static str,
    /// Its name in words, with the unit.
    pub words: &'static str,
    of: fn(&Measures) -> Option<f64>,
}

impl Measure {
    /// All measures, in the order of the table.
    pub const ALL: [Self; COUNT] = [
        Self::new("peak_force_n", "peak force, N", |it| it.peak_force),
        Self::new("settling_time_s", "settling time, s", |it| it.settling_time),
        Self::new("energy_injected_mj", "energy injected by the loop, mJ", |it| it.energy_injected),
        Self::new("energy_taken_mj", "energy taken by the controller, mJ", |it| it.energy_taken),
        Self::new("active_percent", "ticks active, %", |it| it.active),
        Self::new("chatter_rms_n", "chatter, N rms", |it| it.chatter),
        Self::new("energy_given_mj", "energy given by the port, mJ", |it| it.energy_given),
        Self::new(
            "energy_given_beyond_damper_mj",
            "energy given beyond the device's damper, mJ",
            |it| it.energy_given_beyond_damper,
        ),
        Self::new("force_felt_percent", "force felt, % of the environment's", |it| it.force_felt),
        Self::new("stiffness_felt_percent", "stiffness felt, % of asked", |it| it.stiffness_felt),
    ];

    const fn new(key: &'static str, words: &'static str, of: fn(&Measures) -> Option<f64>) -> Self {
        Self { key, words, of }
    }

    /// This number of `measures`.
    pub fn of(self, measures: &Measures) -> Option<f64> {
        (self.of)(measures)
    }
}

impl Measures {
    /// Measures from the numbers in the order of [`Measure::ALL`], without those that are out of range.
    pub(crate) fn from_numbers(numbers: [Option<f64>; COUNT]) -> Self {
        let told = |number: f64| number.is_finite().then_some(number + 0.0);
        let [
            peak_force,
            settling_time,
            energy_injected,
            energy_taken,
            active,
            chatter,
            physical @ ..,
        ] = numbers.map(|number| number.and_then(told));
        let [energy_given, energy_given_beyond_damper, force_felt, stiffness_felt] = physical;
        Self {
            peak_force,
            settling_time,
            energy_injected,
            energy_taken,
            active,
            chatter,
            energy_given,
            energy_given_beyond_damper,
            force_felt,
            stiffness_felt,
        }
    }

    /// Whether a run with this verdict may have these measures.
    pub(crate) fn are_possible(&self, verdict: Verdict) -> bool {
        let magnitudes = [self.peak_force, self.settling_time, self.active, self.chatter];
        let is_whole = magnitudes.into_iter().flatten().all(|it| it >= 0.0);
        let is_share = self.active.is_none_or(|percent| percent <= 100.0);
        is_whole && is_share && (verdict != Verdict::Grows || *self == Self::default())
    }

    /// The measures without numbers that are out of range.
    pub(crate) fn in_range(self) -> Self {
        Self::from_numbers(Measure::ALL.map(|it| it.of(&self)))
    }
}
