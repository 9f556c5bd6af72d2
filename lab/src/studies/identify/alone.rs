//! Device without the hand, of which a log tells the sum with it only.

use super::report::Report;
use crate::files::log::LogError;
use crate::text::given;

/// Mass and damping of the device without the hand, as far as they were measured; the rest of the fitted sum is the hand's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Alone {
    /// Mass, kg.
    pub mass: Option<f64>,
    /// Damping, N·s/m.
    pub damping: Option<f64>,
}

impl Alone {
    /// # Errors
    /// A mass not above 0, a damping below 0, or one above the sum.
    pub(super) fn check(self, report: &Report) -> Result<(), LogError> {
        let (masses, dampings) = (report.mass.value, report.damping.value);
        let mass = self.mass.map(|own| ("mass", "kg", own, masses, own > 0.0));
        let damping = self.damping.map(|own| ("damping", "N.s/m", own, dampings, own >= 0.0));
        for (key, unit, own, sum, is_sound) in mass.into_iter().chain(damping) {
            if is_sound && own <= sum {
                continue;
            }
            let told = format!("--device-{key} is {} {unit}", given(own));
            let both = format!("hand and device have {} {unit} together", given(sum));
            return Err(LogError::about(&report.log, format!("{told}, and {both}"))
                .with_help("give what the device has without the hand, which is part of that"));
        }
        Ok(())
    }

    /// A sentence about the sums that the scene does not tell apart; none where everything is told.
    pub(super) fn note(self) -> Option<String> {
        let (parts, options) = match (self.mass, self.damping) {
            (None, None) => ("masses and dampings", "--device-mass and --device-damping"),
            (None, Some(_)) => ("masses", "--device-mass"),
            (Some(_), None) => ("dampings", "--device-damping"),
            (Some(_), Some(_)) => return None,
        };
        Some(format!(
            "hand and device move as one here: a log of one position does not tell their {parts} apart. All is the device's, and \
             limits and stabilizers that count on the device alone promise too much; {options} tell what it has without the hand"
        ))
    }
}
