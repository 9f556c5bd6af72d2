//! Which settings are worth their time.

/// Marks what no other beats: nobody is at once no dearer and no worse, and better in one of the two.
pub(super) fn front(points: &[(f64, Option<f64>)]) -> Vec<bool> {
    let worst = |error: Option<f64>| error.unwrap_or(f64::INFINITY);
    let beats = |(cost, error): &(f64, Option<f64>), than: &(f64, Option<f64>)| {
        let (error, other) = (worst(*error), worst(than.1));
        *cost <= than.0 && error <= other && (*cost < than.0 || error < other)
    };
    let kept = |point: &(f64, Option<f64>)| {
        point.1.is_some() && !points.iter().any(|other| beats(other, point))
    };
    points.iter().map(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nobody_beats() {
        let points = [
            (1.0, Some(1e-3)),
            (2.0, Some(1e-6)),
            (2.0, Some(1e-5)),
            (3.0, Some(1e-6)),
            (0.5, None),
            (9.0, Some(0.0)),
        ];
        assert_eq!(front(&points), [true, true, false, false, false, true]);
    }
}
