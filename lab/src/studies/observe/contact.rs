//! Contacts: stretches of a log in which a force acts.

use serde::Serialize;

use super::tally::Tally;
use crate::measure::sanity;

/// Number of contacts that are reported one by one.
const TOLD: usize = 10;

/// Contact threshold as a share of the largest force so far, where no threshold is given.
pub(super) const SHARE: f64 = sanity::SHARE;

/// The most consecutive rows below the threshold that do not end a contact.
const CHATTER: u32 = 3;

/// A stretch with the force above the threshold, from its first row until the force held over its last one ends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Contact {
    /// Start, s.
    pub start: f64,
    /// End, s.
    pub end: f64,
    /// Energy that went into the port, J.
    pub absorbed: f64,
    /// Energy that came out of the port, J.
    pub released: f64,
    /// `released − absorbed`, J: above 0 where the contact generated energy.
    pub generated: f64,
    /// Largest magnitude of the force, N.
    pub peak_force: f64,
    /// The constant damper that dissipates over the recorded contact what that generated, N·s/m: `generated / Σ v² T`,
    /// 0 where it generated nothing, none where nothing moved.
    pub damping: Option<f64>,
}

/// The contacts of a log.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Contacts {
    /// The threshold as given, or the last value of the default, N.
    pub threshold: f64,
    /// Whether the threshold is 1 % of the largest force so far instead of given.
    pub threshold_follows: bool,
    /// The number of contacts.
    pub count: u64,
    /// The number of contacts that generated energy.
    pub generating: u64,
    /// The ten contacts that generated most, worst first.
    pub worst: Vec<Contact>,
}

/// Finder of contacts, step by step.
#[derive(Clone, Debug)]
pub(super) struct Finder {
    given: Option<f64>,
    largest: f64,
    open: Option<Open>,
    found: Contacts,
}

/// A contact that has not ended.
#[derive(Clone, Copy, Debug)]
struct Open {
    start: f64,
    end: f64,
    peak: f64,
    tally: Tally,
    /// Energy and motion since the force was last above the threshold.
    pause: Tally,
    paused: u32,
}

/// Force, work and motion from one row to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Push {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) force: f64,
    pub(super) work: f64,
    pub(super) motion: f64,
}

impl Finder {
    /// Finder with the given threshold, N, or with the default.
    pub(super) fn new(given: Option<f64>) -> Self {
        Self { given, largest: 0.0, open: None, found: Contacts::default() }
    }

    fn threshold(&self) -> f64 {
        self.given.unwrap_or(SHARE * self.largest)
    }

    pub(super) fn add(&mut self, push: &Push) {
        let size = push.force.abs();
        self.largest = self.largest.max(size);
        let threshold = self.threshold();
        // Noise before the first real contact does not belong to a contact.
        if self.open.as_ref().is_some_and(|open| open.peak <= threshold) {
            self.open = None;
        }
        if size > threshold {
            let open = self.open.get_or_insert_with(|| Open::at(push.from));
            open.go_on(push);
        } else if let Some(open) = &mut self.open {
            open.pause.add(push.work, push.motion);
            open.paused += 1;
            if open.paused > CHATTER {
                self.close();
            }
        }
    }

    /// Whether a contact has not ended.
    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    fn close(&mut self) {
        let Some(open) = self.open.take() else { return };
        let contact = open.contact();
        self.found.count += 1;
        self.found.generating += u64::from(contact.generated > 0.0);
        let worst = &mut self.found.worst;
        let rank = worst.partition_point(|other| other.generated >= contact.generated);
        if rank < TOLD {
            worst.insert(rank, contact);
            worst.truncate(TOLD);
        }
    }

    /// All contacts, including one that the end of the log cuts off.
    pub(super) fn finish(mut self) -> Contacts {
        self.close();
        let threshold = self.threshold();
        Contacts { threshold, threshold_follows: self.given.is_none(), ..self.found }
    }
}

impl Open {
    fn at(start: f64) -> Self {
        let nothing = Tally::new();
        Self { start, end: start, peak: 0.0, tally: nothing, pause: nothing, paused: 0 }
    }

    fn go_on(&mut self, push: &Push) {
        if self.paused > 0 {
            self.tally.add_all(&self.pause);
            (self.pause, self.paused) = (Tally::new(), 0);
        }
        self.tally.add(push.work, push.motion);
        self.end = push.to;
        self.peak = self.peak.max(push.force.abs());
    }

    fn contact(&self) -> Contact {
        let generated = self.tally.generated();
        Contact {
            start: self.start,
            end: self.end,
            absorbed: self.tally.absorbed(),
            released: self.tally.released(),
            generated,
            peak_force: self.peak,
            damping: self.tally.damper(generated),
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    fn find(given: Option<f64>, forces: &[f64]) -> Contacts {
        let mut finder = Finder::new(given);
        for (n, force) in forces.iter().enumerate() {
            let (from, to) = (n as f64, n as f64 + 1.0);
            finder.add(&Push { from, to, force: *force, work: -*force, motion: 1.0 });
        }
        finder.finish()
    }

    #[test]
    fn a_contact_lasts_while_the_force_is_above_the_threshold() {
        let found = find(Some(1.0), &[0.0, 2.0, 3.0, 0.5, 0.0, 0.0, 0.0, 4.0]);
        assert_eq!(found.count, 2);
        let spans: Vec<_> = found.worst.iter().map(|one| (one.start, one.end)).collect();
        assert_eq!(spans, [(1.0, 3.0), (7.0, 8.0)]);
        let first = found.worst[0];
        assert_eq!((first.generated, first.peak_force, first.damping), (5.0, 3.0, Some(2.5)));
    }

    #[test]
    fn a_pause_of_three_rows_is_chatter_and_counts() {
        let found = find(Some(1.0), &[2.0, 0.5, 0.0, 0.5, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0]);
        assert_eq!(found.count, 2);
        assert_eq!((found.worst[0].end, found.worst[0].generated), (5.0, 5.0));
    }

    #[test]
    fn noise_before_the_first_contact_is_no_contact() {
        let found = find(None, &[0.01, 0.01, 0.01, 5.0, 6.0, 0.01, 0.01, 0.01, 0.01]);
        assert_eq!((found.count, found.worst[0].start, found.worst[0].end), (1, 3.0, 5.0));
        assert_abs_diff_eq!(found.threshold, 0.06, epsilon = 1e-12);
        assert!(found.threshold_follows);
    }

    #[test]
    fn only_the_worst_are_kept() {
        let mut forces = Vec::new();
        for n in 0..100 {
            forces.extend([f64::from((n * 37) % 100) + 1.0, 0.0, 0.0, 0.0, 0.0]);
        }
        let found = find(Some(0.0), &forces);
        assert_eq!((found.count, found.generating, found.worst.len()), (100, 100, 10));
        let kept: Vec<f64> = found.worst.iter().map(|one| one.generated).collect();
        assert_eq!(kept, (91..=100).rev().map(f64::from).collect::<Vec<_>>());
    }
}
