//! Path memory: energy pressed in comes out cell by cell, and no more.

use approx::abs_diff_eq;
use lyapunov::{
    HeldTick, OnePort, PortSample, Stabilizer, bodies::Impedance, environments::Wall,
    stabilizers::PathMemory,
};

use crate::support::{Dice, HELD, PERIOD, held_tick, swing};

/// 0.12 mm, a power of two: the ways of the first test end on edges.
const CELL: f64 = 1.0 / 8192.0;

fn memory() -> PathMemory<f64, 64> {
    PathMemory::beyond(0.0, 64.0 * CELL).expect("a memory")
}

/// Without a debt the observed energy is 0, and not −0.
#[test]
fn no_debt_is_zero() {
    let energy = memory().stabilize(&PortSample::starting(PERIOD, 0.0, 0.0), 1.0).observed_energy;
    assert_eq!(format!("{energy:?}"), "0.0");
}

/// A cell a tick in and out again: a held spring takes `k x(n−1)` over a cell, and gives as much over the same one.
#[test]
fn a_held_spring_gives_what_it_took_cell_by_cell() {
    let mut port = Wall::new(0.1 / CELL, 0.0).expect("a wall").stabilized(memory());
    let mut sample = PortSample::starting(PERIOD, 0.0, 0.0);
    let (mut energy, mut debts) = (0.0, 0);
    for tick in 0..80i32 {
        let force = port.respond(&sample);
        let at = f64::from(if tick <= 40 { tick } else { 80 - tick });
        // Turned round within a period, it gives the force of the next cell once, and a cell later that much less.
        let expected = match tick {
            0..=40 => 0.1 * at,
            41 => 0.1 * (at - 1.0) - 0.1,
            _ => 0.1 * (at - 1.0),
        };
        assert!(
            abs_diff_eq!(force, expected.max(0.0), epsilon = 1e-9),
            "{force} N for {expected} on {tick}"
        );
        let inwards = if tick < 40 { CELL } else { -CELL };
        energy += force * inwards;
        debts += i32::from(port.correction().shortfall > 1e-12);
        let position = sample.position + inwards;
        sample = held_tick(position, inwards, force);
    }
    assert!(debts == 1 && energy.abs() < 1e-12, "{debts} debts, {energy:e} J");
}

/// The memory of the test: the last loading of each micrometre, and what unloading gave beyond it.
#[test]
fn energy_is_kept_stretch_by_stretch() {
    const STEP: f64 = 1e-6;
    for seed in 0..50 {
        let (mut memory, mut dice) = (memory(), Dice::of(seed));
        let (mut at, mut sample) = (0i32, PortSample::starting(PERIOD, 0.0, 0.0));
        let (mut path, mut beyond) = (vec![0.0f64; 20_000], 0.0f64);
        for _ in 0..500 {
            let force = memory.stabilize(&sample, dice.within(20.0)).effort;
            let to = (at + dice.within(300.0) as i32).clamp(-1000, 9_000);
            for micron in at.min(to)..at.max(to) {
                let place = &mut path[(micron + 1000) as usize];
                let work = if to > at { force * STEP } else { -force * STEP };
                if work < 0.0 {
                    // Energy that this very place has, and then energy from nowhere.
                    let paid = place.min(-work);
                    *place -= paid;
                    beyond += -work - paid;
                } else {
                    *place += work;
                }
            }
            let moved = f64::from(to - at) * STEP;
            at = to;
            let position = f64::from(at) * STEP;
            sample = held_tick(position, moved, force);
        }
        let told = memory.stabilize(&sample, 0.0).shortfall;
        let held: f64 = path.iter().sum();
        assert!(held - beyond >= -told - 1e-12, "{beyond:e} J beyond {held:e} J, {told:e} J told");
    }
}

#[test]
fn a_wall_that_a_hold_makes_active_settles() {
    let light = Impedance { damping: 0.1, ..HELD };
    let wall = || Wall::new(20_000.0, 0.0).expect("a wall").at(-2e-3);
    let (alone, _) = swing(light, wall(), 20_000);
    let wall = Wall::new(20_000.0, 0.0).expect("a wall").at(-2e-3);
    let memory = PathMemory::<f64, 64>::beyond(-2e-3, 64.0 * CELL).expect("a memory");
    let (most, late) = swing(light, wall.stabilized(memory), 20_000);
    assert!(alone > 10.0 * most, "{alone} m and {most} m");
    assert!(late < 2e-3, "{most} m, then {late} m");
}

/// What a deep place took does not pay at a shallow one.
#[test]
fn nothing_pays_elsewhere() {
    let mut memory = memory();
    // A long way under no force, then much energy far inside.
    memory.stabilize(
        &HeldTick {
            period: PERIOD,
            position: 3e-3,
            velocity: 3.0,
            displacement: 3e-3,
            applied: 0.0,
        }
        .sample(),
        0.0,
    );
    memory.stabilize(
        &HeldTick {
            period: PERIOD,
            position: 4e-3,
            velocity: 1.0,
            displacement: 1e-3,
            applied: 50.0,
        }
        .sample(),
        0.0,
    );
    let mut effort = |from: f64| {
        let back = HeldTick {
            period: PERIOD,
            position: from,
            velocity: -0.2,
            displacement: 0.0,
            applied: 0.0,
        }
        .sample();
        memory.stabilize(&back, 10.0).effort
    };
    assert_eq!(effort(3.9e-3), 10.0);
    assert_eq!(effort(2.9e-3), 0.0);
    assert_eq!(effort(-1e-3), 10.0);
}

#[test]
fn what_cannot_be_right_is_refused() {
    assert!(PathMemory::<f64, 8>::beyond(f64::NAN, 1.0).is_err());
    assert!(PathMemory::<f64, 8>::beyond(0.0, 0.0).is_err());
    assert!(PathMemory::<f64, 8>::beyond(0.0, f64::INFINITY).is_err());
    let error = PathMemory::<f64, 0>::beyond(0.0, 1.0).expect_err("no cells");
    assert_eq!((error.parameter, error.value), ("memory depth", 1.0));
    assert!(PathMemory::<f64, 8>::beyond(0.0, 1e-323).is_err());
}
