//! What a cell came to under one stabilizer.

/// What a cell came to under one stabilizer; docs/compare.md defines every number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Whether the run was bounded and did not grow; none where no spring pulls the plant anywhere.
    pub stable: Option<bool>,
    /// What was measured; of an unstable run nothing, as that would tell how long it ran and no more.
    pub measures: Measures,
}

/// What was measured along a run. What does not apply is none, and so is what is out of range.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// Largest force on the plant, N.
    pub peak_force: Option<f64>,
    /// Since when the plant has been in the band about its equilibrium without a break, s.
    pub settling_time: Option<f64>,
    /// What the environment gave beyond all it had been given, mJ.
    pub energy_injected: Option<f64>,
    /// What the controller's force took out of the motion, mJ.
    pub energy_taken: Option<f64>,
    /// Share of the ticks on which damping was injected, percent.
    pub active: Option<f64>,
    /// Root mean square of the force on the plant between 5 and 50 Hz, N.
    pub chatter: Option<f64>,
}

/// A number of [`Measures`], by its key.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// Its key in the table, unit included.
    pub key: &'static str,
    /// What it is in words, with the unit.
    pub words: &'static str,
    of: fn(&Measures) -> Option<f64>,
}

impl Measure {
    /// All of them, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::new("peak_force_n", "peak force, N", |it| it.peak_force),
        Self::new("settling_time_s", "settling time, s", |it| it.settling_time),
        Self::new("energy_injected_mj", "energy injected by the loop, mJ", |it| it.energy_injected),
        Self::new("energy_taken_mj", "energy taken by the controller, mJ", |it| it.energy_taken),
        Self::new("active_percent", "ticks active, %", |it| it.active),
        Self::new("chatter_rms_n", "chatter, N rms", |it| it.chatter),
    ];

    const fn new(key: &'static str, words: &'static str, of: fn(&Measures) -> Option<f64>) -> Self {
        Self { key, words, of }
    }

    /// The number.
    pub fn of(self, measures: &Measures) -> Option<f64> {
        (self.of)(measures)
    }
}

impl Measures {
    /// From the numbers in the order of [`Measure::ALL`].
    pub(super) fn from_numbers(numbers: [Option<f64>; 6]) -> Self {
        let [peak_force, settling_time, energy_injected, energy_taken, active, chatter] = numbers;
        Self { peak_force, settling_time, energy_injected, energy_taken, active, chatter }
            .in_range()
    }

    /// Without what is out of range.
    pub(super) fn in_range(self) -> Self {
        let told =
            |value: Option<f64>| value.filter(|value| value.is_finite()).map(|value| value + 0.0);
        Self {
            peak_force: told(self.peak_force),
            settling_time: told(self.settling_time),
            energy_injected: told(self.energy_injected),
            energy_taken: told(self.energy_taken),
            active: told(self.active),
            chatter: told(self.chatter),
        }
    }
}
