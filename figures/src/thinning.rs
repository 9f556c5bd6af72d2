//! Thinning of points that the page cannot show apart.

use std::collections::HashSet;

use super::geometry::Place;

/// Largest number of points kept of a curve that runs back and forth.
const MOST_POINTS: usize = 4000;

/// Largest number of dots kept of a cloud.
const MOST_DOTS: usize = 6000;

/// The curve with at most four points for each unit of the abscissa: the first, the lowest, the
/// highest and the last, which leave the same ink on the page as all of them.
///
/// A curve that runs back and forth has no such columns; it loses points that hardly move, then
/// keeps the extremes of equal stretches.
pub(super) fn thinned(points: Vec<Place>, width: f64) -> Vec<Place> {
    if points.len() as f64 <= 4.0 * width {
        return points;
    }
    if points.windows(2).all(|pair| pair[0].0 <= pair[1].0) {
        return points
            .chunk_by(|first, second| first.0.floor() == second.0.floor())
            .flat_map(|column| extremes(column, |place| place.1))
            .collect();
    }
    let moving = moving(&points);
    if moving.len() <= MOST_POINTS {
        return moving;
    }
    let stretch = moving.len().div_ceil(MOST_POINTS / 6);
    moving
        .chunks(stretch)
        .flat_map(|stretch| {
            let mut kept = extreme_indices(stretch, |place| place.1);
            kept.extend(extreme_indices(stretch, |place| place.0));
            kept.sort_unstable();
            kept.dedup();
            kept.into_iter().map(|index| stretch[index])
        })
        .collect()
}

/// The dots with at most one for each cell of a grid, made coarser until they are few enough.
pub(super) fn thinned_dots(points: Vec<Place>) -> Vec<Place> {
    if points.len() <= MOST_DOTS {
        return points;
    }
    let mut outermost = extremes(&points, |place| place.0);
    outermost.extend(extremes(&points, |place| place.1));
    let mut cell = 0.5;
    loop {
        let mut taken = HashSet::new();
        let kept: Vec<Place> = outermost
            .iter()
            .chain(&points)
            .filter(|(x, y)| taken.insert(((x / cell).floor() as i64, (y / cell).floor() as i64)))
            .copied()
            .collect();
        if kept.len() <= MOST_DOTS {
            return kept;
        }
        cell *= 1.25;
    }
}

/// The points that lie apart from the last kept one, and the final point.
fn moving(points: &[Place]) -> Vec<Place> {
    const APART: f64 = 0.4;
    let mut kept: Vec<Place> = Vec::new();
    for &point in points {
        let moves = kept.last().is_none_or(|last| {
            (point.0 - last.0).abs() >= APART || (point.1 - last.1).abs() >= APART
        });
        if moves {
            kept.push(point);
        }
    }
    if let Some(last) = points.last().filter(|last| kept.last() != Some(last)) {
        kept.push(*last);
    }
    kept
}

fn extremes(points: &[Place], key: impl Fn(&Place) -> f64) -> Vec<Place> {
    extreme_indices(points, key).into_iter().map(|index| points[index]).collect()
}

/// Indices of the first, the lowest, the highest and the last point, in order, each once.
fn extreme_indices(points: &[Place], key: impl Fn(&Place) -> f64) -> Vec<usize> {
    if points.is_empty() {
        return Vec::new();
    }
    let (mut lowest, mut highest) = (0, 0);
    for (index, point) in points.iter().enumerate() {
        if key(point) < key(&points[lowest]) {
            lowest = index;
        }
        if key(point) > key(&points[highest]) {
            highest = index;
        }
    }
    let mut kept = vec![0, lowest, highest, points.len() - 1];
    kept.sort_unstable();
    kept.dedup();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(index: usize) -> f64 {
        (index.wrapping_mul(2_654_435_761) % 1000) as f64 / 10.0
    }

    #[test]
    fn a_million_points_keep_the_extremes_of_each_column() {
        let mut points: Vec<Place> =
            (0..1_000_000).map(|index| (index as f64 * 600.0 / 1e6, noise(index))).collect();
        points[123_456].1 = 500.0;
        points[654_321].1 = -500.0;
        let kept = thinned(points.clone(), 600.0);
        assert!(kept.len() <= 4 * 601);
        assert!(kept.contains(&points[123_456]) && kept.contains(&points[654_321]));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[999_999]));
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }

    #[test]
    fn few_points_are_left_alone() {
        let points = vec![(0.0, 1.0), (0.1, 2.0), (0.2, 1.0)];
        assert_eq!(thinned(points.clone(), 600.0), points);
    }

    #[test]
    fn a_curve_that_runs_back_and_forth_is_bounded_and_keeps_its_extent() {
        let mut points: Vec<Place> =
            (0..1_000_000).map(|index| (noise(index), noise(index / 7))).collect();
        points[77_777] = (900.0, 5.0);
        let kept = thinned(points.clone(), 600.0);
        assert!(kept.len() <= MOST_POINTS + 6);
        assert!(kept.contains(&(900.0, 5.0)));
        let resting = [(1.0, 1.0), (0.9, 1.0)].repeat(50_000);
        assert_eq!(thinned(resting, 600.0).len(), 2);
    }

    #[test]
    fn a_cloud_of_dots_is_bounded_and_keeps_its_outermost() {
        let mut points: Vec<Place> =
            (0..500_000).map(|index| (noise(index), noise(index / 1000))).collect();
        points[400_000] = (3.0, 777.0);
        let kept = thinned_dots(points);
        assert!(kept.len() <= MOST_DOTS && kept.contains(&(3.0, 777.0)));
    }
}
