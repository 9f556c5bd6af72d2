//! Stretches of a log that its figure marks, in bounded memory.

/// The most stretches that are kept: more than a figure can show.
const MOST: usize = 1024;

/// Stretches of time in order; those too close for a figure to part are joined.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks {
    stretches: Vec<(f64, f64)>,
    /// Time below which two stretches count as one, s.
    resolution: f64,
}

impl Marks {
    /// Adds a stretch that begins no earlier than those before.
    pub(super) fn add(&mut self, from: f64, to: f64) {
        match self.stretches.last_mut() {
            Some(last) if from - last.1 <= self.resolution => last.1 = last.1.max(to),
            _ => self.stretches.push((from, to)),
        }
        if self.stretches.len() > MOST {
            self.join();
        }
    }

    fn join(&mut self) {
        let (Some(first), Some(last)) = (self.stretches.first(), self.stretches.last()) else {
            return;
        };
        self.resolution = (2.0 * self.resolution).max((last.1 - first.0) / MOST as f64);
        let all = std::mem::take(&mut self.stretches);
        all.into_iter().for_each(|(from, to)| self.add(from, to));
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.stretches.is_empty()
    }

    /// The stretches as bars at the height `y`, each at least `width` wide.
    pub(super) fn bars(&self, y: f64, width: f64) -> Vec<(f64, f64, f64)> {
        let bar = |&(from, to): &(f64, f64)| {
            let missing = (0.5 * (width - (to - from))).max(0.0);
            (from - missing, to + missing, y)
        };
        self.stretches.iter().map(bar).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_stretches_are_kept_as_they_are() {
        let mut marks = Marks::default();
        marks.add(1.0, 2.0);
        marks.add(4.0, 4.0);
        assert_eq!(marks.bars(-1.0, 0.5), [(1.0, 2.0, -1.0), (3.75, 4.25, -1.0)]);
    }

    #[test]
    fn many_stretches_stay_few_and_cover_all() {
        let mut marks = Marks::default();
        let all: Vec<(f64, f64)> =
            (0..100_000).map(|n| (f64::from(n), f64::from(n) + 0.2)).collect();
        all.iter().for_each(|(from, to)| marks.add(*from, *to));
        let bars = marks.bars(0.0, 0.0);
        assert!(bars.len() <= MOST);
        // Each stretch lies within a bar, and no bar reaches over a time that a figure could tell apart.
        for (from, to) in all.iter().step_by(997) {
            assert!(bars.iter().any(|bar| bar.0 <= *from && *to <= bar.1));
        }
        let mut apart = Marks::default();
        (0..10_000).for_each(|n| apart.add(f64::from(n) * 1e-6, f64::from(n) * 1e-6));
        apart.add(1.0, 1.0);
        let bars = apart.bars(0.0, 0.0);
        assert!(bars.iter().all(|bar| bar.1 < 0.011 || bar.0 == 1.0), "{bars:?}");
    }
}
