//! Comparison of the command's rows with those of the reference.

use crate::effects::reference::{Loop, Row, column};
use crate::effects::run::rows;
use crate::effects::scene::Scene;

/// Factor by which the command may be off more than another start and other roundings move the trace.
const FACTOR: f64 = 30.0;

/// Size of numbers at which a loop has run away, and its trace is cut.
const RUNAWAY: f64 = 1e5;

/// Tolerances for a scene's scalar: `base` and `undetermined` as parts of the largest value of each column, `start` of
/// the largest position.
struct Precision {
    /// Difference of the second start.
    start: f64,
    /// A unit in the last place.
    epsilon: f64,
    /// Error that is allowed in any row.
    base: f64,
    /// Spread of the runs at which the trace is cut.
    undetermined: f64,
}

impl Precision {
    fn of(scene: &Scene) -> Self {
        if scene.single {
            Self { start: 1e-6, epsilon: f64::from(f32::EPSILON), base: 2e-5, undetermined: 1e-3 }
        } else {
            Self { start: 1e-14, epsilon: f64::EPSILON, base: 1e-12, undetermined: 1e-8 }
        }
    }
}

/// Random factors near 1, from a fixed seed.
struct Rounding {
    size: f64,
    state: u64,
}

impl Rounding {
    fn factor(&mut self) -> f64 {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        1.0 + self.size * ((self.state >> 40) as f64 / f64::from(1 << 23) - 1.0)
    }
}

pub(crate) fn reference(scene: &Scene) -> Vec<Row> {
    disturbed(scene, 0.0, 0.0, 0)
}

fn disturbed(scene: &Scene, start: f64, rounding: f64, seed: u64) -> Vec<Row> {
    let mut machine = Loop::new(scene);
    let mut rounding = Rounding { size: rounding, state: seed };
    for axis in 0..scene.dimensions {
        machine.state[axis][0] += start;
        machine.state[axis][2] += start;
    }
    let mut rows = vec![];
    for n in 0..=scene.ticks() {
        let mut row = machine.tick(n);
        if !row.iter().all(|number| number.abs() < RUNAWAY) {
            break;
        }
        row[8] *= rounding.factor();
        machine.disturb(row[8]);
        rows.push(row);
        machine.advance(n);
        for number in machine.state.iter_mut().flatten() {
            *number *= rounding.factor();
        }
    }
    rows
}

/// Largest value of each column; the shortfall has the scale of the observed energy.
fn scales(rows: &[Row]) -> Row {
    let mut scales = vec![0.0_f64; rows[0].len()];
    for row in rows {
        scales.iter_mut().zip(row).for_each(|(scale, number)| *scale = scale.max(number.abs()));
    }
    scales[10] = scales[10].max(scales[8]);
    scales
}

/// Distance of two rows, in parts of the scales.
fn apart(one: &Row, other: &Row, scales: &Row) -> f64 {
    let pairs = one.iter().zip(other).zip(scales);
    let parts = pairs.map(|((one, other), scale)| match (one - other).abs() {
        0.0 => 0.0,
        apart => apart / scale,
    });
    parts.fold(0.0, f64::max)
}

/// Compares the trace for as long as it is determined; returns the number of those ticks.
pub(crate) fn agrees(scene: &Scene) -> Result<usize, String> {
    let precision = Precision::of(scene);
    let ours = reference(scene);
    let scales = scales(&ours);
    let others: Vec<Vec<Row>> = (1..=4)
        .map(|seed| {
            let start = precision.start * scales[1] * if seed % 2 == 0 { 1.0 } else { -1.0 };
            disturbed(scene, start, 4.0 * precision.epsilon, seed)
        })
        .collect();
    let theirs = rows(scene)?;
    let mut spread: f64 = 0.0;
    for (n, row) in ours.iter().enumerate() {
        for other in &others {
            spread = spread.max(other.get(n).map_or(1.0, |other| apart(row, other, &scales)));
        }
        if spread > precision.undetermined {
            return Ok(n);
        }
        let their = theirs.get(n).ok_or_else(|| format!("{n} rows\n{}", scene.toml()))?;
        let allowed = FACTOR * spread + precision.base;
        wrong(scene, n, row, their, |column| allowed * scales[column])?;
    }
    if theirs.len() == scene.ticks() + 1 || ours.len() <= scene.ticks() {
        Ok(ours.len())
    } else {
        Err(format!("{} rows of {}\n{}", theirs.len(), scene.ticks() + 1, scene.toml()))
    }
}

/// Compares every row with the one that follows from the rows before it.
pub(crate) fn follows(scene: &Scene) -> Result<(), String> {
    let told = rows(scene)?;
    let base = if scene.single { 1e-4 } else { 1e-11 };
    let scales = scales(&told);
    let mut machine = Loop::new(scene);
    for (n, row) in told.iter().enumerate() {
        if n > 0 && !scene.exact {
            // Where the rows do not hold the plant's velocity, the position is taken from them.
            for axis in 0..scene.dimensions {
                machine.state[axis][0] = row[column(axis, 0)];
            }
        }
        let ours = machine.tick(n);
        // The injected damping is the debt over v² T: where the motion is slow, it has fewer digits than the debt.
        let speed = (0..scene.dimensions).map(|axis| row[column(axis, 2)]).fold(0.0, f64::hypot);
        let weight = speed * speed * scene.period();
        let damper = if weight > 0.0 { base * scales[8] / weight } else { 0.0 };
        wrong(scene, n, &ours, row, |index| match scene.columns()[index].as_str() {
            name if name.ends_with("operator") && !scene.exact => f64::INFINITY,
            "alpha" => base * scales[index] + damper,
            name if ["f_ctl", "f_out", "f_act"].iter().any(|force| name.ends_with(force)) => {
                base * scales[index] + damper * speed
            }
            _ => base * scales[index],
        })?;
        machine.believe(n, row);
        if scene.exact {
            machine.advance(n);
        }
    }
    Ok(())
}

fn wrong(
    scene: &Scene,
    n: usize,
    want: &Row,
    got: &Row,
    allowed: impl Fn(usize) -> f64,
) -> Result<(), String> {
    for (index, (want, got)) in want.iter().zip(got).enumerate() {
        let allowed = allowed(index);
        if (want - got).abs() > allowed {
            let name = &scene.columns()[index];
            let off = (want - got).abs();
            return Err(format!(
                "row {n}: {name} is {got:e}, not {want:e}: off by {off:e}, {allowed:e} allowed\n{}",
                scene.toml()
            ));
        }
    }
    Ok(())
}
