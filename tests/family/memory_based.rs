//! Memory-based passivation against its worked rows, and place by place.

use std::collections::VecDeque;

use lyapunov::{HeldTick, PortSample, Scalar, Stabilizer, stabilizers::MemoryBased};

use crate::support::{Dice, PERIOD, held_tick};
use crate::worked::{A, B, felt, near};

const CELL: f64 = 1e-4;

fn memory<T: Scalar>() -> MemoryBased<T, 32> {
    MemoryBased::beyond(T::of(0.0), T::of(32.0 * CELL)).expect("a memory")
}

fn rows<T: Scalar>() {
    near(&felt::<T>(memory(), A), &[0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 1.5, 0.0, 0.0, 0.0]);
    near(&felt::<T>(memory(), B), &[2.0, 2.0, 2.0, -1.0, -1.0, 3.0, 0.0, 0.0, 0.0, 0.0]);
}

crate::worked::each_scalar!(the_worked_rows, rows);

/// After the way in of the row, at 0.6 mm and on the way out by 0.1 mm: cells 6, 5 and 4 hold 3, 1.5 and 1.5 N.
#[test]
fn a_late_force_looks_further_ahead() {
    for (ticks, most) in [(0, 1.5), (1, 1.5), (2, 1.5), (3, 0.5), (6, 0.0)] {
        let mut memory = memory::<f64>().delayed(ticks);
        let (mut last, mut force) = (0.0, 0.0);
        for (position, asked) in [(0.0, 0.0), (1.0, 0.5), (3.0, 1.5), (6.0, 3.0), (8.0, 4.0)] {
            let moved = (position - last) * CELL;
            last = position;
            let sample = held_tick(position * CELL, moved, force);
            force = memory.stabilize(&sample, asked).effort;
        }
        // Half a cell on, so that no edge is a matter of rounding.
        let out = HeldTick {
            period: PERIOD,
            position: 6.5 * CELL,
            velocity: -0.1,
            displacement: -CELL,
            applied: 0.0,
        }
        .sample();
        assert_eq!(memory.stabilize(&out, 9.0).effort, most, "{ticks} ticks");
    }
}

/// The worst that a place gives beyond what it took, on a spring that is pressed and let go a cell a tick, its force `late`
/// ticks late; the turn itself left out.
fn beyond(late: u32, looking: u32) -> f64 {
    let mut memory = memory::<f64>().delayed(looking);
    let mut pipe = VecDeque::from(vec![0.0; late as usize]);
    let mut sample = PortSample::starting(PERIOD, 0.5 * CELL, 0.0);
    let (mut took, mut worst) = ([0f64; 32], 0f64);
    for tick in 0..40u32 {
        let asked = 5000.0 * sample.position;
        pipe.push_back(memory.stabilize(&sample, asked).effort);
        let force = pipe.pop_front().unwrap_or(0.0);
        let inwards = tick < 20;
        let moved = if inwards { CELL } else { -CELL };
        let place = if inwards { tick } else { 39 - tick } as usize;
        if inwards {
            took[place] = force;
        } else if tick > 21 + late {
            worst = worst.max(force - took[place]);
        }
        let position = sample.position + moved;
        sample = held_tick(position, moved, force);
    }
    worst
}

/// No more comes out than went in, if it looks as far ahead as the force is late.
#[test]
fn place_by_place() {
    for late in 0..4 {
        let found = beyond(late, late);
        assert!(found <= 1e-12, "{found} N at {late} ticks");
        assert!(late == 0 || beyond(late, late - 1) > 0.1);
    }
}

/// The excess of what comes out over what went in, on a way in by 0.1 mm a tick under `forces` and out again as fast under as much as the
/// memory lets through; the place of the turning tick is left out.
fn too_much(cell: f64, forces: &[f64]) -> f64 {
    let (step, count) = (1e-4, forces.len());
    let mut memory = MemoryBased::<f64, 32>::beyond(0.0, 32.0 * cell).expect("a memory");
    let (mut applied, mut energy) = (forces[0], 0.0);
    memory.stabilize(&PortSample::starting(PERIOD, 0.0, 0.0), applied);
    for tick in 0..2 * count {
        let (moved, place) =
            if tick < count { (step, tick + 1) } else { (-step, 2 * count - tick - 1) };
        let turning = tick == count - 1 || tick == count;
        energy += if turning { 0.0 } else { applied * moved };
        let sample = held_tick(place as f64 * step, moved, applied);
        let asked = forces.get(tick + 1).copied().unwrap_or(100.0);
        applied = memory.stabilize(&sample, asked).effort;
    }
    -energy
}

/// A cell keeps the last force for all of its width: 0.9 mm of 1 N and 0.1 mm of 10 N come out as 10 N. In all that is the cell
/// times what the force rose by at most.
#[test]
fn a_cell_gives_its_last_force() {
    let mut forces = vec![1.0; 9];
    forces.push(10.0);
    let found = too_much(1.001e-3, &forces);
    assert!((found - 9.0 * 0.9e-3).abs() < 1e-12, "{found} J");
    let (mut dice, mut most) = (Dice::of(5), 0f64);
    for _ in 0..3000 {
        let cell = 10f64.powf(dice.within(1.0) - 3.5);
        let deepest = (30.0 * cell / 1e-4).min(40.0);
        let depth = 3 + (dice.within(1.0).powi(2) * (deepest - 3.0)) as usize;
        let forces: Vec<f64> = (0..depth).map(|_| 5.0 + dice.within(5.0)).collect();
        let rises: f64 = forces.windows(2).map(|pair| (pair[1] - pair[0]).max(0.0)).sum();
        let found = too_much(cell, &forces);
        assert!(found <= cell * rises + 1e-12, "{found} J, cells of {cell} m, {rises} N");
        most = most.max(found / (cell * rises).max(1e-12));
    }
    assert!(most > 0.5, "{most}");
}

#[test]
fn what_cannot_be_right_is_refused() {
    assert!(MemoryBased::<f64, 8>::beyond(f64::NAN, 1.0).is_err());
    assert!(MemoryBased::<f64, 8>::beyond(0.0, 0.0).is_err());
    let error = MemoryBased::<f64, 0>::beyond(0.0, 1.0).expect_err("no cells");
    assert_eq!((error.parameter, error.value), ("memory depth", 1.0));
}
