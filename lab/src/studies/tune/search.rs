//! Search of a box for the best place, with a fixed number of trials.

/// Radii of the boxes about the best place so far, as shares of the whole box.
const RADII: [f64; 3] = [0.2, 0.07, 0.025];

/// Bases of the Halton sequence, one for each dimension.
const BASES: [u32; 8] = [2, 3, 5, 7, 11, 13, 17, 19];

/// Search of the unit cube: half of the trials, and what does not divide by three, spread over all of it, the rest in ever smaller
/// boxes about the best.
///
/// The places are a Halton sequence, so a search is the same each time. Places of a batch do not depend on each other and
/// may be tried at once.
#[derive(Clone, Debug)]
pub(super) struct Search {
    dimensions: usize,
    /// The number of trials of each batch.
    batches: Vec<usize>,
    /// Places drawn so far.
    drawn: u32,
    done: usize,
    best: Vec<f64>,
}

impl Search {
    /// Search with `trials` trials after the one of `start`, a place in the unit cube.
    pub(super) fn from(start: Vec<f64>, trials: usize) -> Self {
        let dimensions = start.len();
        let close = trials / 2 / RADII.len();
        let mut batches = vec![close; RADII.len()];
        batches.insert(0, trials - close * RADII.len());
        if dimensions == 0 {
            batches.clear();
        }
        Self { dimensions, batches, drawn: 0, done: 0, best: start }
    }

    /// The places to try next, given the best of all tried so far; none at the end.
    pub(super) fn next(&mut self, best: &[f64]) -> Option<Vec<Vec<f64>>> {
        self.best.copy_from_slice(best);
        let count = *self.batches.get(self.done)?;
        let radius = self.done.checked_sub(1).map(|batch| RADII[batch]);
        self.done += 1;
        Some((0..count).map(|_| self.place(radius)).collect())
    }

    fn place(&mut self, radius: Option<f64>) -> Vec<f64> {
        self.drawn += 1;
        let spread = (0..self.dimensions).map(|axis| radical_inverse(self.drawn, BASES[axis]));
        let Some(radius) = radius else { return spread.collect() };
        let near = spread.zip(&self.best).map(|(share, best)| {
            // A box that would leave the cube is moved into it, so that no trial is lost at an edge.
            let middle = best.clamp(radius, 1.0 - radius);
            middle + radius * (2.0 * share - 1.0)
        });
        near.collect()
    }
}

/// The digits of `number` in `base`, mirrored at the point: evenly spread over 0 to 1.
fn radical_inverse(mut number: u32, base: u32) -> f64 {
    let (mut share, mut digit) = (0.0, 1.0);
    while number > 0 {
        digit /= f64::from(base);
        share += digit * f64::from(number % base);
        number /= base;
    }
    share
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The best place that a search finds for `cost`, and the number of its trials.
    fn found(start: &[f64], trials: usize, cost: impl Fn(&[f64]) -> f64) -> (Vec<f64>, usize) {
        let mut search = Search::from(start.to_vec(), trials);
        let (mut best, mut tried) = (start.to_vec(), 0);
        while let Some(places) = search.next(&best) {
            tried += places.len();
            for place in places {
                assert!(place.iter().all(|share| (0.0..=1.0).contains(share)), "{place:?}");
                if cost(&place) < cost(&best) {
                    best = place;
                }
            }
        }
        (best, tried)
    }

    #[test]
    fn a_valley_is_found_with_the_promised_number_of_trials() {
        let valley = |to: f64| move |place: &[f64]| (place[0] - to).powi(2);
        for to in [0.0, 0.3, 0.77, 1.0] {
            let (best, tried) = found(&[0.5], 48, valley(to));
            assert_eq!(tried, 48);
            assert!((best[0] - to).abs() < 0.01, "{best:?} for {to}");
        }
        let bowl = |place: &[f64]| (place[0] - 0.2).powi(2) + (place[1] - 0.9).powi(2);
        let (best, tried) = found(&[0.5, 0.5], 96, bowl);
        assert_eq!(tried, 96);
        assert!(bowl(&best).sqrt() < 0.05, "{best:?}");
    }

    #[test]
    fn without_a_number_to_choose_nothing_is_tried() {
        assert_eq!(found(&[], 48, |_| 0.0), (vec![], 0));
    }
}
