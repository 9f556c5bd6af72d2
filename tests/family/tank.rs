//! Energy tank: it gives what it holds, and no faster than allowed.

use approx::assert_abs_diff_eq;
use lyapunov::{
    PortEnergy, PortSample, Stabilizer,
    stabilizers::{Tank, TankLimits},
};

use crate::support::{Dice, PERIOD};

const STORE: TankLimits<f64> = TankLimits { start: 2e-3, floor: 5e-4, ceiling: 3e-3, power: 0.5 };

#[test]
fn follows_its_recursion() {
    let mut tank = Tank::new(PortEnergy, STORE).expect("a tank");
    let (mut dice, mut energy) = (Dice::of(1), STORE.start);
    let mut applied = 0.0;
    for _ in 0..5000 {
        let velocity = dice.within(0.2);
        let sample = PortSample::new(PERIOD, 0.0, velocity, velocity * PERIOD, applied);
        energy = energy.min(STORE.ceiling) + applied * velocity * PERIOD;
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
        sample = PortSample::new(PERIOD, 0.0, -0.3, moved, correction.effort);
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
