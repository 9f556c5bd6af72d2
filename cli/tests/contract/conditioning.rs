//! Length for which a trace is determined by its scene and not by rounding.
//!
//! The same scene is run again with its start moved and every state rounded at random; where that moves a column by
//! more than a small part of its largest value, the scene is cut. In f64 the start moves by 1e-13 of the largest
//! position and nothing may move by more than 1e-10: rounding is amplified a thousandfold at most. In f32 the second
//! run also has the scene's numbers rounded, the start moves by 1e-7 and nothing may move by more than 1e-3.
//!
//! A few runs do not find every switch. Near rest the damper is one: there the last place of the observed energy, or
//! whether the velocity is exactly 0, switches it between nothing and its cap, so the scene is cut there too.

use crate::contract::reference::{self, Disturbance};
use crate::contract::row::Row;
use crate::contract::scene::{Scalar, Scene, Velocity};
use crate::contract::trace;

/// Least number of ticks of a comparison; in fewer nothing of the loop has happened yet.
const FEWEST_TICKS: usize = 8;

/// Error that the observed energy or a velocity may have, in units in the last place of its largest value so far.
const UNITS: f64 = 16.0;

pub(crate) fn shortened(scene: &Scene) -> Option<Scene> {
    let mut scene = scene.clone();
    while let Some(tick) = first_undetermined(&scene) {
        scene.duration = tick.checked_sub(1)? as f64 / scene.servo_rate;
    }
    (scene.ticks() >= FEWEST_TICKS).then_some(scene)
}

fn first_undetermined(scene: &Scene) -> Option<usize> {
    let (moved, limit) = match scene.scalar {
        Scalar::F64 => (1e-13, 1e-10),
        Scalar::F32 => (1e-7, 1e-3),
    };
    let rows = reference::run(scene);
    let scale = trace::largest(&rows);
    let rounded = scene.in_scalar();
    let differing = |(sign, seed)| {
        let disturbance = Disturbance {
            start: sign * moved * scale[1],
            rounding: 4.0 * scene.scalar.epsilon(),
            seed,
        };
        let other = reference::run_disturbed(&rounded, disturbance);
        let differs = |(a, b): (&Row, &Row)| {
            let pairs = a.columns().into_iter().zip(b.columns());
            let mut moves = pairs.map(|(a, b)| (a - b).abs()).zip(scale).skip(1);
            moves.any(|(change, scale)| change > limit * scale)
        };
        let shared = rows.len().min(other.len());
        let first = rows.iter().zip(&other).position(differs);
        first.or((shared <= scene.ticks()).then_some(shared))
    };
    let signs = [1.0, -1.0].into_iter().cycle();
    let moved = signs.zip(1..=6).filter_map(differing);
    moved.chain(first_switch(scene, &rows, trace::tolerance(scene.scalar) * scale[9])).min()
}

fn first_switch(scene: &Scene, rows: &[Row], alpha: f64) -> Option<usize> {
    let stabilizer = scene.stabilizer?;
    let cap = stabilizer.cap * scene.mass() * scene.servo_rate;
    let (mut largest_sum, mut largest_v): (f64, f64) = (0.0, 0.0);
    rows.iter().position(|row| {
        largest_sum = largest_sum.max(row.observer.abs());
        largest_v = largest_v.max(match scene.velocity {
            Velocity::Exact => row.v.abs(),
            Velocity::BackwardDifference => row.x_measured.abs() * scene.servo_rate,
        });
        let [sum_off, v_off] = [largest_sum, largest_v].map(|x| UNITS * scene.scalar.epsilon() * x);
        let weight = row.v * row.v / scene.servo_rate;
        let damper = |sum: f64| if sum < 0.0 { (-sum / weight).min(cap) } else { 0.0 };
        let low = damper(row.observer - sum_off);
        low - damper(row.observer + sum_off) > alpha || (low > alpha && row.v.abs() < v_off)
    })
}

#[cfg(test)]
mod tests {
    use super::shortened;
    use crate::contract::facts::first_contact;
    use crate::contract::generate::{self, without_encoder};
    use crate::contract::reference;
    use crate::contract::scene::{Kind, SOFT, STIFF, Scalar, Scene, Work};

    /// A trace that is cut before the controller acts would compare nothing of it.
    #[test]
    fn traces_reach_past_the_first_contact() {
        for wall in [SOFT, STIFF] {
            for (hold, scalar) in
                [(1, Scalar::F64), (1, Scalar::F32), (10, Scalar::F64), (10, Scalar::F32)]
            {
                let mut scene = Scene::paper(wall).with(Kind::Popc, Work::Held, 0.5);
                scene = scene.at(100.0 * hold as f64, hold);
                scene.scalar = scalar;
                let scene = shortened(&scene).expect("the free motion is determined");
                let rows = reference::run(&scene);
                assert!(scene.ticks() >= *first_contact(&rows).end());
                assert!(rows.iter().any(|row| row.alpha > 0.0));
            }
        }
    }

    #[test]
    fn few_scenes_have_nothing_left() {
        for (scalar, part) in [(Scalar::F64, 0.5), (Scalar::F32, 0.4)] {
            let mut scenes: Vec<Scene> =
                generate::known().into_iter().map(without_encoder).collect();
            scenes.iter_mut().for_each(|scene| scene.scalar = scalar);
            let whole: usize = scenes.iter().map(Scene::ticks).sum();
            let left: Vec<Scene> = scenes.iter().filter_map(shortened).collect();
            let kept: usize = left.iter().map(Scene::ticks).sum();
            assert!(kept as f64 > part * whole as f64, "{kept} of {whole} ticks");
            assert!(
                left.len() * 10 >= scenes.len() * 9,
                "{} of {} scenes",
                left.len(),
                scenes.len()
            );
        }
    }
}
