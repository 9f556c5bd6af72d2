//! Long runs in single precision: terms far smaller than a sum are not lost in it.

use approx::assert_abs_diff_eq;
use lyapunov::{
    HeldTick, Popc, PortEnergy, PortSample, Stabilizer,
    accumulators::{Compensated, Plain},
    stabilizers::{
        Account, EnergyBounding, EnergyTank, MemoryBased, PathMemory, TankLimits, WindowedCredit,
    },
};

use crate::support::limit;

const TICKS: u32 = 1_000_000;

/// A tick that gives 10⁻⁶ J, outside of any wall.
const GAVE: HeldTick<f32> =
    HeldTick { period: 1e-3, position: -1.0, velocity: 1e-3, displacement: 1e-6, applied: -1.0 };

/// A draw of 10⁻⁷ J of 10 J, which is less than the rounding of the tank.
#[test]
fn a_full_tank_is_drawn_from() {
    let store = TankLimits { start: 10.0_f32, floor: 0.0, ceiling: 20.0, power: f32::INFINITY };
    let mut tank = EnergyTank::new(store).expect("a tank").summed_in::<Compensated<f32>>();
    let mut given = 0.0;
    for _ in 0..TICKS {
        given += f64::from(tank.pass(1e-3, 0.0, 1e-3_f32, 0.1)) * 0.1 * 1e-3;
    }
    assert_abs_diff_eq!(f64::from(tank.energy()), 10.0 - given, epsilon = 1e-6);
    assert_abs_diff_eq!(given, 0.1, epsilon = 1e-4);
}

/// A debt of 40 J to which 10⁻⁶ J come on every tick.
#[test]
fn a_large_debt_grows() {
    let mut path = PathMemory::<f32, 8>::beyond(0.0, 0.01).expect("a path");
    path.owe(40.0).expect("a debt");
    let mut path = path.summed_in::<Compensated<f32>>();
    // Outside of the wall and inwards: what the port gives there no memory allows.
    for _ in 0..TICKS {
        path.stabilize(&GAVE.sample(), 0.0);
    }
    assert_abs_diff_eq!(path.debt(), 41.0, epsilon = 1e-4);
}

/// 50 J of credit from which 10⁻⁶ J are taken on every tick.
#[test]
fn what_is_told_keeps_small_works() {
    let told = |mut one: Box<dyn Both>| {
        one.grant(50.0).expect("credit");
        (0..TICKS).map(|_| one.stabilize(&GAVE.sample(), 0.0).observed_energy).last()
    };
    let memory = MemoryBased::<f32, 8>::beyond(0.0, 0.01).expect("a memory");
    let bounding = EnergyBounding::<f32>::new(1e-3, 1e-3).expect("constants");
    let energies = [
        told(Box::new(memory.summed_in::<Compensated<f32>>())),
        told(Box::new(bounding.summed_in::<Compensated<f32>>())),
    ];
    for energy in energies {
        assert_abs_diff_eq!(energy.expect("ticks"), 49.0, epsilon = 1e-3);
    }
}

trait Both: Stabilizer<f32> + Account<f32> {}

impl<S: Stabilizer<f32> + Account<f32>> Both for S {}

/// Credit of a window of 300 to 400 ticks, whichever work is booked.
#[test]
fn a_window_stays_over_sampled_work() {
    let window = WindowedCredit::<f64, Plain<f64>, 4>::of_ticks(100).expect("a window");
    let mut popc = Popc::new(PortEnergy, limit()).summed_by(window).sampled();
    let absorbs = PortSample::starting(1e-3, 0.0, 1.0);
    popc.stabilize(&absorbs, 2.0);
    let still = PortSample::starting(1e-3, 0.0, 0.0);
    let energies = [299, 200].map(|ticks| {
        (0..ticks).map(|_| popc.stabilize(&still, 0.0).observed_energy).last().expect("ticks")
    });
    assert_eq!(energies, [2e-3, 0.0]);
}
