//! Envelope of a curve of any length, in a bounded number of points.

/// The most buckets of a curve; even, so that they merge in pairs.
const MOST: usize = 2048;

type Point = (f64, f64);

/// The first, the lowest, the highest and the last point of each of equally long runs of rows.
///
/// When there is no room for another bucket, neighbours merge and buckets are twice as long from then on. The points
/// that are kept draw the same curve as all points.
#[derive(Clone, Debug)]
pub(crate) struct Envelope {
    buckets: Vec<Bucket>,
    /// Points in a full bucket, and in the last one.
    size: u64,
    filled: u64,
}

#[derive(Clone, Copy, Debug)]
struct Bucket {
    first: Point,
    lowest: Point,
    highest: Point,
    last: Point,
}

impl Bucket {
    fn of(point: Point) -> Self {
        Self { first: point, lowest: point, highest: point, last: point }
    }

    fn and(self, later: Self) -> Self {
        Self {
            first: self.first,
            lowest: if later.lowest.1 < self.lowest.1 { later.lowest } else { self.lowest },
            highest: if later.highest.1 > self.highest.1 { later.highest } else { self.highest },
            last: later.last,
        }
    }
}

impl Envelope {
    pub(crate) fn new() -> Self {
        Self { buckets: Vec::with_capacity(MOST), size: 1, filled: 0 }
    }

    pub(crate) fn add(&mut self, x: f64, y: f64) {
        let bucket = Bucket::of((x, y));
        if self.filled < self.size
            && let Some(last) = self.buckets.last_mut()
        {
            *last = last.and(bucket);
            self.filled += 1;
            return;
        }
        if self.buckets.len() == MOST {
            for index in 0..MOST / 2 {
                self.buckets[index] = self.buckets[2 * index].and(self.buckets[2 * index + 1]);
            }
            self.buckets.truncate(MOST / 2);
            self.size *= 2;
        }
        self.buckets.push(bucket);
        self.filled = 1;
    }

    /// The points that are kept, in order.
    pub(crate) fn points(&self) -> impl Iterator<Item = Point> {
        self.buckets.iter().flat_map(|bucket| {
            let mut middle = [bucket.lowest, bucket.highest];
            middle.sort_by(|one, other| one.0.total_cmp(&other.0));
            let mut points = vec![bucket.first, middle[0], middle[1], bucket.last];
            points.dedup();
            points
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_points_are_all_kept() {
        let mut envelope = Envelope::new();
        let points: Vec<Point> = (0..MOST).map(|n| (n as f64, ((n * n) % 17) as f64)).collect();
        points.iter().for_each(|(x, y)| envelope.add(*x, *y));
        assert_eq!(envelope.points().collect::<Vec<_>>(), points);
    }

    #[test]
    fn many_points_keep_their_ends_and_extremes_in_order_and_in_bounds() {
        let mut envelope = Envelope::new();
        let y = |n: u32| match n {
            123_457 => 9.0,
            654_321 => -9.0,
            n => f64::from(n.wrapping_mul(2_654_435_761) % 100) / 100.0,
        };
        let last = 1_000_003;
        (0..=last).for_each(|n| envelope.add(f64::from(n), y(n)));
        let kept: Vec<Point> = envelope.points().collect();
        assert!(kept.len() <= 4 * MOST && kept.len() > MOST);
        assert!(kept.windows(2).all(|pair| pair[0].0 < pair[1].0));
        assert!(kept.iter().all(|point| point.1 == y(point.0 as u32)));
        for n in [0, 123_457, 654_321, last] {
            assert!(kept.contains(&(f64::from(n), y(n))), "{n}");
        }
    }
}
