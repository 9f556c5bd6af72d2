//! Memories of the way: where cells begin and end, and what is told.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, HeldTick, ParameterError, PortSample, Stabilizer,
    stabilizers::{Account, MemoryBased, PathMemory},
};

use crate::support::Dice;

const PERIOD: f64 = 0.25; // s
const SURFACE: f64 = 1.0; // m

/// A motion from one place to another beyond the surface, under a force.
fn way(from: f64, to: f64, applied: f64) -> PortSample<f64> {
    let displacement = to - from;
    let (position, velocity) = (SURFACE + to, displacement / PERIOD);
    HeldTick { period: PERIOD, position, velocity, displacement, applied }.sample()
}

/// Four cells of half a metre.
fn forces() -> MemoryBased<f64, 4> {
    MemoryBased::beyond(SURFACE, 2.0).expect("a memory")
}

fn energies() -> PathMemory<f64, 4> {
    PathMemory::beyond(SURFACE, 2.0).expect("a memory")
}

/// The most that a stabilizer gives on a way.
fn most(one: &(impl Stabilizer<f64> + Clone), from: f64, to: f64) -> f64 {
    one.clone().stabilize(&way(from, to, 0.0), 1e9).effort
}

/// The way of the first tick is known by its displacement, and each cell that it touches has its force.
#[test]
fn a_first_way_is_remembered() {
    let mut memory = forces();
    assert_eq!(memory.stabilize(&way(0.25, 1.25, 3.0), 7.0).effort, 7.0);
    // Cells 0, 1 and 2 are touched; the look ahead is as long as the last motion.
    for (from, to, given) in
        [(1.25, 1.125, 3.0), (0.5, 0.25, 3.0), (1.75, 1.5, 0.0), (0.25, -0.25, 0.0)]
    {
        let mut one = memory;
        one.stabilize(&way(from, from, 0.0), 0.0);
        assert_eq!(most(&one, from, to), given, "{from} to {to}");
    }
}

/// The last cell reaches on without an end.
#[test]
fn beyond_the_last_cell_is_the_last_cell() {
    let mut memory = forces();
    memory.stabilize(&way(0.0, 0.0, 0.0), 0.0);
    memory.stabilize(&way(0.0, 10.0, 3.0), 0.0);
    assert_eq!(most(&memory, 10.0, 9.0), 3.0);
    let mut path = energies();
    path.stabilize(&way(0.0, 10.0, 3.0), 0.0);
    assert_relative_eq!(most(&path, 10.0, 9.0), 3.0, max_relative = 1e-14);
    // What was pressed further in with less force has less, as the cell is one.
    path.stabilize(&way(10.0, 12.0, 2.0), 0.0);
    assert_relative_eq!(most(&path, 12.0, 11.0), 2.0, max_relative = 1e-14);
}

/// A pull on the way in takes nothing: nothing comes out there.
#[test]
fn a_pull_leaves_nothing() {
    let mut memory = forces();
    memory.stabilize(&way(0.0, 2.0, 3.0), 0.0);
    memory.stabilize(&way(0.0, 0.0, 0.0), 0.0);
    memory.stabilize(&way(0.0, 1.25, -3.0), 0.0);
    let told = memory.stabilize(&way(1.25, 1.25, 0.0), 5.0);
    assert_eq!((told.effort, told.observed_energy, told.shortfall), (5.0, 2.25, 0.0));
    assert_eq!(most(&memory, 1.25, 1.125), 0.0);
}

/// What the port gave more than it took is told.
#[test]
fn what_was_given_beyond_is_told() {
    let mut memory = forces();
    let told: Correction<f64> = memory.stabilize(&way(1.0, 0.5, 4.0), 1.0);
    assert_eq!((told.observed_energy, told.shortfall, told.alpha), (-2.0, 2.0, 0.0));
    let told = energies().stabilize(&way(1.0, 0.5, 4.0), 1.0);
    assert_eq!((told.observed_energy, told.shortfall, told.alpha), (-2.0, 2.0, 0.0));
}

/// A spoilt sample is no way, and a way goes on from the last place that was known.
#[test]
fn a_spoilt_sample_is_no_way() {
    let spoil: [fn(&mut PortSample<f64>); 6] = [
        |it| it.position = f64::NAN,
        |it| it.displacement = f64::NAN,
        |it| it.velocity = f64::INFINITY,
        |it| it.work = f64::NAN,
        |it| it.period = -PERIOD,
        |it| it.position = f64::INFINITY,
    ];
    let pressed = [way(0.0, 0.5, 2.0), way(0.5, 1.5, 3.0)];
    for spoilt in spoil {
        let (mut memory, mut path) = (forces(), energies());
        for sample in &pressed {
            memory.stabilize(sample, 1.0);
            path.stabilize(sample, 1.0);
        }
        let (before, kept) = (memory, path);
        let mut sample = way(1.5, 2.0, 9.0);
        spoilt(&mut sample);
        let told = [memory.stabilize(&sample, 1.0), path.stabilize(&sample, 1.0)];
        assert!(told.iter().all(|it| !it.accepted && it.effort == 0.0), "{told:?}");
        for (from, to) in [(1.5, 1.25), (1.0, 0.75)] {
            assert_eq!(most(&memory, from, to), most(&before, from, to));
            assert_eq!(most(&path, from, to), most(&kept, from, to));
        }
    }
    // Nor is a place that cannot be counted from the surface.
    let far = MemoryBased::<f64, 4>::beyond(-1e308, 2.0)
        .map(|mut it| it.stabilize(&PortSample::starting(PERIOD, 1e308, 0.0), 1.0));
    assert!(far.is_ok_and(|told| !told.accepted && told.effort == 0.0));
    // An effort that is not finite is rejected, and the motion is remembered.
    let mut memory = forces();
    assert!(!memory.stabilize(&way(0.0, 1.0, 2.0), f64::NAN).accepted);
    assert_eq!(most(&memory, 1.0, 0.75), 2.0);
}

/// `A(a, b) = Σ Mᵢ |cell i ∩ [a, b]|` of the way in, whatever the number of cells.
fn gives_what_it_took<const N: usize>() {
    const CELL: f64 = 0.125;
    let mut dice = Dice::of(41);
    for _ in 0..300 {
        let mut path = PathMemory::<f64, N>::beyond(SURFACE, CELL * N as f64).expect("a memory");
        let (mut at, mut cells) = (0.0, vec![]);
        // Pressed in cell by cell, each under a force of its own.
        for _ in 0..N - 1 {
            let force = 5.0 + dice.within(4.0);
            path.stabilize(&way(at, at + CELL, force), 0.0);
            cells.push(force);
            at += CELL;
        }
        let from = at * (0.5 + dice.within(0.5));
        let to = from * (0.5 + dice.within(0.5));
        let held: f64 = (0..N - 1)
            .map(|cell| {
                let start = cell as f64 * CELL;
                cells[cell] * (from.min(start + CELL) - to.max(start)).max(0.0)
            })
            .sum();
        // On the way it gives a part more than there is, and owes that.
        let given = held * 1.5;
        let told = path.stabilize(&PortSample { work: -given, ..way(from, to, 0.0) }, 0.0);
        assert_relative_eq!(told.shortfall, given - held, max_relative = 1e-9);
        assert_relative_eq!(path.debt(), 0.5 * held, max_relative = 1e-9);
        // Moving on as fast, it gives over that way what is there less the debt.
        let (length, debt) = ((from - to).max(CELL), path.debt());
        let ahead = to - length;
        let there: f64 = (0..N - 1)
            .map(|cell| {
                let start = cell as f64 * CELL;
                cells[cell] * (to.min(start + CELL) - ahead.max(start)).max(0.0)
            })
            .sum();
        let velocity = -(from - to) / PERIOD;
        let next = PortSample::starting(PERIOD, SURFACE + to, velocity);
        let most = ((there - debt) / length).max(0.0);
        let effort = path.stabilize(&next, 1e9).effort;
        assert!((effort - most).abs() <= 1e-9 * (1.0 + most), "{effort} N for {most} N");
    }
}

#[test]
fn every_cell_counts_whatever_their_number() {
    gives_what_it_took::<2>();
    gives_what_it_took::<7>();
    gives_what_it_took::<8>();
    gives_what_it_took::<13>();
    gives_what_it_took::<24>();
}

/// A debt is carried over, and forgiven; what was pressed in stays.
#[test]
fn a_debt_is_carried_over() {
    let mut path = energies();
    path.stabilize(&way(0.0, 2.0, 3.0), 0.0);
    path.owe(0.5).expect("a debt");
    path.owe(0.25).expect("a debt");
    assert_eq!(
        (path.debt(), path.clone().stabilize(&way(2.0, 2.0, 0.0), 0.0).shortfall),
        (0.75, 0.75)
    );
    // 3 N over half a metre of the way ahead, less the debt.
    let out = PortSample::starting(PERIOD, SURFACE + 2.0, -2.0);
    assert_relative_eq!(path.clone().stabilize(&out, 9.0).effort, 1.5, max_relative = 1e-14);
    path.reset();
    assert_eq!(path.debt(), 0.0);
    assert_relative_eq!(path.stabilize(&out, 9.0).effort, 3.0, max_relative = 1e-14);
    // What is given on the way in, or at rest, is owed too.
    path.stabilize(&way(2.0, 2.5, -4.0), 0.0);
    assert_eq!(path.debt(), 2.0);
    path.stabilize(&PortSample { work: -1.0, ..way(2.5, 2.5, 0.0) }, 0.0);
    assert_eq!(path.debt(), 3.0);
    let mut memory = forces();
    memory.owe(2.0).expect("a debt");
    assert_eq!(memory.observed_energy(), -2.0);
}

#[test]
fn what_cannot_be_right_is_named() {
    fn refused<T>(made: Result<T, ParameterError>) -> (&'static str, f64) {
        let error = made.err().expect("refused");
        (error.parameter, error.value)
    }
    let (inf, tiny) = (f64::INFINITY, 5e-324);
    for (surface, depth, told) in [
        (inf, 1.0, ("surface", inf)),
        (0.0, -1.0, ("memory depth", -1.0)),
        (0.0, inf, ("memory depth", inf)),
        (0.0, tiny, ("memory depth", tiny)),
    ] {
        assert_eq!(refused(MemoryBased::<f64, 4>::beyond(surface, depth)), told);
        assert_eq!(refused(PathMemory::<f64, 4>::beyond(surface, depth)), told);
    }
    let mut path = energies();
    assert_eq!(refused(path.owe(-1.0)), ("debt carried over", -1.0));
}
