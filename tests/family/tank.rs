//! Energy tank: it gives what it holds, and no faster than allowed.

use approx::assert_abs_diff_eq;
use lyapunov::{
    DampingLimit, HeldTick, LyapunovCandidate, PortEnergy, PortSample, Scalar, Snapshot,
    Stabilizer,
    stabilizers::{EnergyTank, LeastNorm, Sharing, Tank, TankLimits, TwoLayer, Valve},
};

use crate::support::{Dice, PERIOD};
use crate::worked::near;

const STORE: TankLimits<f64> = TankLimits { start: 2e-3, floor: 5e-4, ceiling: 3e-3, power: 0.5 };

/// A candidate that does not know how much a place before the surface stores.
#[derive(Clone, Copy)]
struct Halved;

impl LyapunovCandidate<f64> for Halved {
    fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
        if sample.position < 0.0 { f64::NAN } else { sample.work }
    }
}

#[test]
fn what_its_candidate_cannot_tell_is_rejected() {
    let moved = |position| {
        let applied = 0.5;
        HeldTick { period: PERIOD, position, velocity: 0.1, displacement: 1e-4, applied }.sample()
    };
    let limit = DampingLimit::at(100.0).expect("a limit");
    let filter = LeastNorm::new(Halved, limit, 1.0).expect("a filter");
    let tank = Tank::new(Halved, STORE).expect("a tank");
    let mut all: [Box<dyn Stabilizer<f64>>; 2] = [Box::new(filter), Box::new(tank)];
    for stabilizer in &mut all {
        let known = stabilizer.stabilize(&moved(1e-3), 1.0);
        let lost = stabilizer.stabilize(&moved(-1e-3), 1.0);
        assert!(known.accepted && !lost.accepted);
        assert_eq!((lost.effort, lost.observed_energy), (0.0, known.observed_energy));
    }
}

/// A tank with a bounded valve holds no more than its ceiling, whatever was stored; the published one goes on overfull.
#[test]
fn what_is_stored_above_the_ceiling_is_forfeited() {
    let tank = EnergyTank::new(STORE).expect("a tank");
    let restored = |energy| tank.restored(energy).expect("an energy").energy();
    assert_eq!([1.0, 2e-3, 1e-4].map(restored), [3e-3, 2e-3, 1e-4]);
    assert_eq!(tank.opening().restored(1.0).expect("an energy").energy(), 1.0);
}

#[test]
fn follows_its_recursion() {
    let mut tank = Tank::new(PortEnergy, STORE).expect("a tank");
    let (mut dice, mut energy) = (Dice::of(1), STORE.start);
    let mut applied = 0.0;
    for _ in 0..5000 {
        let velocity = dice.within(0.2);
        let sample = HeldTick {
            period: PERIOD,
            position: 0.0,
            velocity,
            displacement: velocity * PERIOD,
            applied,
        }
        .sample();
        energy = (energy + applied * velocity * PERIOD).min(STORE.ceiling);
        let wanted = dice.within(20.0);
        let correction = tank.stabilize(&sample, wanted);
        let available = (energy - STORE.floor).max(0.0);
        let most = (available / PERIOD).min(STORE.power);
        let asked = -wanted * velocity;
        let allowed = if asked > most { wanted * most / asked } else { wanted };
        assert_abs_diff_eq!(correction.effort, allowed, epsilon = 1e-9 * wanted.abs());
        assert_abs_diff_eq!(correction.observed_energy, energy - STORE.floor, epsilon = 1e-12);
        assert_abs_diff_eq!(correction.shortfall, (STORE.floor - energy).max(0.0), epsilon = 1e-12);
        applied = correction.effort;
    }
}

/// Where the next period is as this one, the floor is never passed.
#[test]
fn keeps_its_floor_in_a_steady_motion() {
    let mut tank = Tank::new(PortEnergy, STORE).expect("a tank");
    let mut sample = PortSample::starting(PERIOD, 0.0, -0.3);
    let mut given = 0.0;
    for _ in 0..1000 {
        let correction = tank.stabilize(&sample, 50.0);
        let moved = -0.3 * PERIOD;
        sample = HeldTick {
            period: PERIOD,
            position: 0.0,
            velocity: -0.3,
            displacement: moved,
            applied: correction.effort,
        }
        .sample();
        assert!(correction.effort * 0.3 <= STORE.power * (1.0 + 1e-12));
        given -= correction.effort * moved;
    }
    let available = STORE.start - STORE.floor;
    assert!(given <= available * (1.0 + 1e-12) && given > 0.999 * available);
}

#[test]
fn what_cannot_be_right_is_refused() {
    let refused = |store| Tank::new(PortEnergy, store).is_err();
    assert!(refused(TankLimits { start: 0.0, ..STORE }));
    assert!(refused(TankLimits { floor: -1.0, ..STORE }));
    assert!(refused(TankLimits { ceiling: 1e-3, ..STORE }));
    assert!(refused(TankLimits { power: -1.0, ..STORE }));
    assert!(!refused(TankLimits { ceiling: f64::INFINITY, power: f64::INFINITY, ..STORE }));
}

/// Of the row: dissipated power, W, wished input, N, and flow, m/s.
const DISSIPATED: [f64; 7] = [0.1, 0.1, 0.0, 0.0, 0.3, 2.0, 2.0];
const WISHED: [f64; 7] = [1.0, 2.0, 4.0, 4.0, 4.0, 0.0, 0.0];
const FLOW: [f64; 7] = [0.05, 0.1, 0.1, 0.1, -0.1, 0.0, 0.0];

/// The inputs that pass, and what the tank holds then, mJ.
fn row<T: Scalar, L: Valve<T>>(mut tank: EnergyTank<T, L>) -> (Vec<f64>, Vec<f64>) {
    let period = T::of(PERIOD);
    let ticks = DISSIPATED.iter().zip(WISHED).zip(FLOW).map(|((dissipated, wished), flow)| {
        let given = tank.pass(period, T::of(*dissipated), T::of(wished), T::of(flow));
        (given.lane(0), 1e3 * tank.energy().lane(0))
    });
    ticks.unzip()
}

fn rows<T: Scalar>() {
    let [start, floor, ceiling, power] = [2e-4, 1e-4, 1e-3, f64::INFINITY].map(T::of);
    let tank = EnergyTank::new(TankLimits { start, floor, ceiling, power }).expect("a tank");
    // The published valve overdraws on the third tick and overfills on the sixth, by one tick each.
    let (given, energy) = row(tank.opening());
    near(&given, &[1.0, 2.0, 4.0, 0.0, 4.0, 0.0, 0.0]);
    near(&energy, &[0.25, 0.15, -0.25, -0.25, 0.45, 2.45, 2.45]);
    // The bounded one gives of the 4 N what 0.05 mJ over 0.1 mm pay for, and then nothing.
    let (given, energy) = row(tank);
    near(&given, &[1.0, 1.5, 1.0, 0.0, 4.0, 0.0, 0.0]);
    near(&energy, &[0.25, 0.2, 0.1, 0.1, 0.8, 1.0, 1.0]);
}

crate::worked::each_scalar!(the_worked_row_in_joules, rows);

/// Explicit steps of the published state, the root of the energy, create energy; joules do not.
#[test]
fn the_root_creates_what_joules_keep() {
    let (mut root, mut energies) = ((2.0 * 0.2e-3_f64).sqrt(), vec![]);
    for tick in 0..7 {
        let open = root * root / 2.0 > 1e-4;
        let asked = WISHED[tick] * FLOW[tick];
        let drawn = if asked > 0.0 && !open { 0.0 } else { asked };
        let filled = if root * root / 2.0 <= 1e-3 { DISSIPATED[tick] } else { 0.0 };
        root += PERIOD * (filled - drawn) / root;
        energies.push(1e3 * root * root / 2.0);
    }
    let expected = [0.253125, 0.163002, 0.00839799, 0.00839799, 15.2952, 15.2952, 15.2952];
    for (found, expected) in energies.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-4, "{energies:?}");
    }
}

/// Whatever is wished, `floor ≤ E ≤ ceiling`, and no more is handed out than came in and was there.
#[test]
fn a_bounded_valve_is_never_overdrawn_or_overfilled() {
    for seed in 0..50 {
        let mut tank = EnergyTank::new(STORE).expect("a tank");
        let mut dice = Dice::of(seed);
        let mut source = STORE.start;
        for _ in 0..2000 {
            let (dissipated, wished, flow) =
                (dice.within(1.0).max(0.0), dice.within(20.0), dice.within(0.5));
            let given = tank.pass(PERIOD, dissipated, wished, flow);
            source += (dissipated - given * flow) * PERIOD;
            let energy = tank.energy();
            assert!((STORE.floor..=STORE.ceiling).contains(&energy), "{energy:e} J");
            assert!(energy <= source + 1e-12 && given * flow <= STORE.power * (1.0 + 1e-12));
            source = energy;
        }
    }
}

/// A draw of far more than is there, and of all that is there to the last digits, in `f32`, with any numbers.
#[test]
fn rounding_keeps_the_floor() {
    let mut dice = Dice::of(3);
    for _ in 0..200_000 {
        let mut any = || (dice.within(1.0).abs() + 1e-3) as f32;
        let (floor, above) = (1e-2 * any(), any());
        let limits =
            TankLimits { start: floor + above, floor, ceiling: 10.0, power: f32::INFINITY };
        let (period, much, flow) = (1e-2 * any(), 1e6 * any(), any());
        let all = (limits.start - floor) / period / flow;
        for wished in [much, all, all * (1.0 - 2.0 * f32::EPSILON)] {
            let mut tank = EnergyTank::new(limits).expect("a tank");
            let given = tank.pass(period, 0.0, wished, flow);
            assert!(tank.energy() >= floor, "{:e} J of {limits:?}", tank.energy());
            assert!(given >= wished.min(all) * (1.0 - 8.0 * f32::EPSILON), "{given} of {wished}");
            assert!(tank.set_limits(tank.limits()).is_ok());
        }
    }
}

/// Energy left after a step and the move that its velocity tells, J.
fn left<T: Scalar>(mut end: impl Stabilizer<T>, period: T, velocity: T, wished: T) -> f64 {
    let sample = PortSample::starting(period, T::of(0.0), velocity);
    let applied = end.stabilize(&sample, wished).effort;
    let (position, displacement) = (T::of(0.0), velocity * period);
    let sample = HeldTick { period, position, velocity, displacement, applied }.sample();
    end.stabilize(&sample, T::of(0.0)).observed_energy.lane(0)
}

/// As [`rounding_keeps_the_floor`], at ports.
fn ports<T: Scalar>() {
    let mut dice = Dice::of(4);
    for _ in 0..100_000 {
        let mut any = || T::of(dice.within(1.0).abs() + 1e-3);
        let (floor, above) = (any(), any());
        let (start, ceiling, power) = (floor + above, T::of(10.0), T::of(f64::INFINITY));
        let limits = TankLimits { start, floor, ceiling, power };
        let (period, much, speed) = (any() * T::of(1e-2), any() * T::of(1e6), any());
        let all = (start - floor) / period / speed;
        for wished in [much, all, all * T::of(1.0 - 2.0 * T::epsilon().lane(0))] {
            let tank = Tank::new(PortEnergy, limits).expect("a tank");
            let sharing = Sharing { start: start - floor, share: T::of(0.0) };
            let end = TwoLayer::slave(sharing).expect("an end");
            let left = [left(tank, period, -speed, wished), left(end, period, -speed, wished)];
            assert!(left.iter().all(|&energy| energy >= 0.0), "{left:?} J of {limits:?}");
        }
    }
}

crate::worked::each_scalar!(rounding_takes_no_more_than_is_there, ports);

#[test]
fn a_tank_with_a_port_answers_what_is_not_finite() {
    let mut tank = EnergyTank::new(STORE).expect("a tank");
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(tank.pass(PERIOD, 0.0, bad, 0.1), 0.0);
        assert_eq!(tank.pass(PERIOD, 0.0, 1.0, bad), 0.0);
        assert_eq!(tank.pass(PERIOD, bad, 1.0, 0.1), 0.0);
        assert_eq!(tank.pass(bad, 0.0, 1.0, 0.1), 0.0);
    }
    assert_eq!(tank.energy(), STORE.start);
    assert!(EnergyTank::new(TankLimits { ceiling: 1e-3, ..STORE }).is_err());
}
