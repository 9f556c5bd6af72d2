//! Rectangles on the page, and lines cut off at their edges.

/// Place on the page, in units of the drawing; the ordinate grows downwards.
pub(super) type Place = (f64, f64);

/// Rectangle on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl Rect {
    pub(super) const fn new(left: f64, top: f64, width: f64, height: f64) -> Self {
        Self { left, top, width, height }
    }

    pub(super) fn right(&self) -> f64 {
        self.left + self.width
    }

    pub(super) fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// The rectangle grown by `margin` on each side, or shrunk by a negative one.
    pub(super) fn grown(&self, margin: f64) -> Self {
        Self::new(
            self.left - margin,
            self.top - margin,
            self.width + 2.0 * margin,
            self.height + 2.0 * margin,
        )
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right()
            && other.left < self.right()
            && self.top < other.bottom()
            && other.top < self.bottom()
    }

    pub(super) fn contains(&self, (x, y): Place) -> bool {
        self.left <= x && x <= self.right() && self.top <= y && y <= self.bottom()
    }

    /// The part of the line from `from` to `to` that lies inside (Liang and Barsky).
    pub(super) fn cut(&self, from: Place, to: Place) -> Option<(Place, Place)> {
        if self.contains(from) && self.contains(to) {
            return Some((from, to));
        }
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let edges = [
            (-dx, from.0 - self.left),
            (dx, self.right() - from.0),
            (-dy, from.1 - self.top),
            (dy, self.bottom() - from.1),
        ];
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (outward, distance) in edges {
            if outward == 0.0 {
                if distance < 0.0 {
                    return None;
                }
            } else if outward < 0.0 {
                enters = enters.max(distance / outward);
            } else {
                leaves = leaves.min(distance / outward);
            }
        }
        let at = |share: f64| {
            let x = from.0 + share * dx;
            let y = from.1 + share * dy;
            // Rounding may leave a far point a hair outside.
            (x.clamp(self.left, self.right()), y.clamp(self.top, self.bottom()))
        };
        (enters <= leaves).then(|| (at(enters), at(leaves)))
    }

    /// The parts of a line through all the points that lie inside.
    pub(super) fn cut_all(&self, points: &[Place]) -> Vec<Vec<Place>> {
        let mut parts: Vec<Vec<Place>> = Vec::new();
        let mut connected = false;
        for pair in points.windows(2) {
            let Some((from, to)) = self.cut(pair[0], pair[1]) else {
                connected = false;
                continue;
            };
            match parts.last_mut() {
                Some(part) if connected => part.push(to),
                _ => parts.push(vec![from, to]),
            }
            connected = to == pair[1];
        }
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Rect = Rect::new(0.0, 0.0, 10.0, 10.0);

    #[test]
    fn a_line_is_cut_off_at_the_edges() {
        assert_eq!(BOX.cut((-5.0, 5.0), (15.0, 5.0)), Some(((0.0, 5.0), (10.0, 5.0))));
        assert_eq!(BOX.cut((5.0, 5.0), (5.0, 1e9)), Some(((5.0, 5.0), (5.0, 10.0))));
        assert_eq!(BOX.cut((-5.0, -1.0), (15.0, -1.0)), None);
        assert_eq!(BOX.cut((-5.0, 8.0), (3.0, 16.0)), None);
    }

    #[test]
    fn a_line_that_leaves_and_returns_becomes_two() {
        let parts = BOX.cut_all(&[(1.0, 5.0), (2.0, 50.0), (3.0, 5.0), (4.0, 6.0)]);
        assert_eq!(parts.len(), 2);
        assert!(parts.iter().flatten().all(|place| BOX.contains(*place)));
        assert_eq!(parts[1].len(), 3);
    }
}
