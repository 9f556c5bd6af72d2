//! Force that one spring and one damper make in all rows of a log.

use nalgebra::{Matrix4, Vector4};

use super::least_squares::inverse;
use super::stretch::Stretch;
use super::wall::LAGS;

/// Share of the force's deviation that such a spring and damper may leave, root mean square.
const LEFT: f64 = 0.01;

/// Whether `f = K x + B v + c` in all rows, at most [`LAGS`] rows late, with the backward difference or the log's velocity: such a
/// force follows from the motion, and bends every motion of a larger mass with a larger damping and spring as it bends this one.
pub(super) fn is_feedback(stretches: &[Stretch]) -> bool {
    (0..=LAGS).any(|lag| {
        let rows: Vec<_> = stretches.iter().flat_map(|it| rows(it, lag)).collect();
        fits(&rows, [true; 4]) || fits(&rows, [true, true, true, false])
    })
}

/// Each row's position and velocities, from which its force may follow, and that force.
fn rows(stretch: &Stretch, lag: usize) -> impl Iterator<Item = (Vector4<f64>, f64)> + '_ {
    (lag + 1..stretch.len()).map(move |row| {
        let at = row - lag;
        let [last, now] = [at - 1, at].map(|row| stretch.positions[row]);
        let difference = (now - last) / (stretch.times[at] - stretch.times[at - 1]);
        let velocity = stretch.velocities.get(at).copied().unwrap_or_default();
        (Vector4::new(now, difference, 1.0, velocity), stretch.forces[row])
    })
}

fn fits(rows: &[(Vector4<f64>, f64)], free: [bool; 4]) -> bool {
    let middle = rows.iter().map(|it| it.1).sum::<f64>() / rows.len() as f64;
    let squares = |law: Vector4<f64>| {
        let left = rows.iter().map(|(seen, force)| force - middle - seen.dot(&law));
        left.map(|it| it * it).sum::<f64>()
    };
    let all = squares(Vector4::zeros());
    // A constant force tells no mass either, but for another reason.
    if all <= f64::EPSILON * middle * middle * rows.len() as f64 {
        return false;
    }
    let known: Matrix4<f64> = rows.iter().map(|it| it.0 * it.0.transpose()).sum();
    let told: Vector4<f64> = rows.iter().map(|it| it.0 * (it.1 - middle)).sum();
    inverse(&known, free).is_some_and(|inverse| squares(inverse * told) <= LEFT * LEFT * all)
}
