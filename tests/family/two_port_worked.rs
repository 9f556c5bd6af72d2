//! The published two-port account against its worked rows, sampled and held, and energy that is never counted twice.

use lyapunov::{
    AdmittanceSample, Correction, DampingLimit, HeldFlow, Popc, PortEnergy, PortSample, Sampled,
    Scalar, Snapshot, Stabilizer,
    stabilizers::{Account, DriftCompensated, TwoPortSide},
};
use nalgebra::Vector2;

use crate::support::{Dice, PERIOD, held_tick};
use crate::worked::near;

fn limit<T: Scalar>(most: f64) -> DampingLimit<T> {
    DampingLimit::at(T::of(most)).expect("a limit")
}

fn lane<T: Scalar>(values: &[T]) -> Vec<f64> {
    values.iter().map(|value| value.lane(T::LANES - 1)).collect()
}

/// A mJ is 1e-3 J: the rows are in mJ, and 1e-5 of what they tell is meant.
fn millijoules<T: Scalar>(found: &[T], expected: &[f64]) {
    near(&lane(found).iter().map(|it| 1e3 * it).collect::<Vec<_>>(), expected);
}

fn sampled<T: Scalar>() {
    let mut side = TwoPortSide::<T>::new(limit(f64::INFINITY)).sampled();
    let flows = [0.1, 0.1, -0.1, -0.2, -0.1, 0.1, -0.1, -0.1];
    let asked = [2.0, 2.0, 3.0, 2.0, 2.0, 1.0, 1.0, -1.0];
    let received = [0.0, 0.0, 0.1, 0.1, 0.1, 0.6, 0.6, 0.6];
    let (mut out, mut sums, mut came, mut burnt) = (vec![], vec![], vec![], vec![T::of(0.0)]);
    for tick in 0..8 {
        side.receive(T::of(1e-3 * received[tick]));
        let velocity = T::of(flows[tick]);
        let sample = PortSample::starting(T::of(PERIOD), T::of(0.0), velocity);
        let correction: Correction<T> = side.stabilize(&sample, T::of(asked[tick]));
        out.push(correction.effort);
        sums.push(correction.observed_energy);
        came.push(side.absorbed());
        burnt.push(burnt[tick] + correction.alpha * velocity * velocity * T::of(PERIOD));
    }
    near(&lane(&out), &[2.0, 2.0, 1.0, 0.0, 0.0, 1.0, 1.0, -1.0]);
    millijoules(&sums, &[0.0, 0.0, -0.2, -0.4, -0.2, 0.5, 0.4, 0.4]);
    millijoules(&came, &[0.2, 0.4, 0.4, 0.4, 0.4, 0.5, 0.5, 0.6]);
    millijoules(&burnt[1..], &[0.0, 0.0, 0.2, 0.6, 0.8, 0.8, 0.8, 0.8]);
    // out = received + burnt before this tick − W
    let gave: Vec<_> = (0..8).map(|n| T::of(1e-3 * received[n]) + burnt[n] - sums[n]).collect();
    millijoules(&gave, &[0.0, 0.0, 0.3, 0.7, 0.9, 0.9, 1.0, 1.0]);
}

fn held<T: Scalar>() {
    let mut side = TwoPortSide::<T>::new(limit(200.0));
    let moves = [0.0, 1.0, 1.0, -1.0, -2.0, -1.0, 1.0, -1.0];
    let asked = [2.0, 2.0, 3.0, 2.0, 2.0, 1.0, 1.0, 1.0];
    let received = [0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.1, 0.6];
    let (mut applied, mut sums, mut came, mut burnt) = (vec![], vec![], vec![], vec![]);
    let (mut force, mut kept, mut wished) = (T::of(0.0), T::of(0.0), T::of(0.0));
    for tick in 0..8 {
        side.receive(T::of(1e-3 * received[tick]));
        let moved = T::of(1e-4 * moves[tick]);
        let sample = held_tick(T::of(0.0), moved, force);
        kept += (force - wished) * moved;
        wished = T::of(asked[tick]);
        let correction: Correction<T> = side.stabilize(&sample, wished);
        force = correction.effort;
        applied.push(force);
        sums.push(correction.observed_energy);
        came.push(side.absorbed());
        burnt.push(kept);
    }
    near(&lane(&applied), &[2.0, 2.0, 3.0, -1.0, 1.5, -0.5, 4.0, -1.0]);
    millijoules(&sums, &[0.0, 0.0, 0.0, -0.3, -0.1, -0.15, -0.3, -0.2]);
    millijoules(&came, &[0.0, 0.2, 0.4, 0.4, 0.4, 0.4, 0.5, 0.5]);
    millijoules(&burnt, &[0.0, 0.0, 0.0, 0.0, 0.6, 0.65, 0.5, 0.2]);
    let gave: Vec<_> = (0..8).map(|n| T::of(1e-3 * received[n]) + burnt[n] - sums[n]).collect();
    millijoules(&gave, &[0.0, 0.0, 0.0, 0.3, 0.7, 0.9, 0.9, 1.0]);
}

crate::worked::each_scalar!(the_sampled_account, sampled);

crate::worked::each_scalar!(the_held_account, held);

/// A push of −2 N over 0.1 mm is a debt of 0.2 mJ. The damper that serves it pushes on the way back, and what the port gives
/// doubles from tick to tick, with nothing short: both ports give at least what their accounts say, and no bound keeps it.
#[test]
fn a_hand_that_turns_takes_what_was_to_be_dissipated() {
    let mut side = TwoPortSide::<f64>::new(limit(f64::INFINITY));
    let (mut work, mut applied) = (0.0, -2.0);
    side.stabilize(&PortSample::starting(PERIOD, 0.0, 0.0), applied);
    for tick in 0..10 {
        let moved = if tick % 2 == 0 { 1e-4 } else { -1e-4 };
        work += applied * moved;
        let correction = side.stabilize(&held_tick(0.0, moved, applied), 0.0);
        let expected = -2e-4 * 2f64.powi(tick);
        assert!((work / expected - 1.0).abs() < 1e-12, "{work} J of {expected} J");
        assert!((correction.observed_energy / work - 1.0).abs() < 1e-12);
        assert_eq!(correction.shortfall, 0.0);
        applied = correction.effort;
    }
}

/// 2 mJ of debt, 10 mJ burnt: no debt is left. And what was burnt is not spendable by the other side.
#[test]
fn what_burns_pays_its_own_debt_once() {
    let (mut here, mut there) = (TwoPortSide::new(limit(1e3)), TwoPortSide::new(limit(1e3)));
    let outwards = |moved: f64, applied: f64| held_tick(0.0, moved, applied);
    // The channel's 2 N over a millimetre outwards, nothing received.
    here.stabilize(&PortSample::starting(PERIOD, 0.0, -1.0), 2.0);
    let correction: Correction<f64> = here.stabilize(&outwards(-1e-3, 2.0), 0.0);
    assert!((correction.observed_energy + 2e-3).abs() < 1e-15 && correction.alpha > 0.0);
    // The correction burns 10 mJ against the motion: −10 N over a millimetre.
    let correction = here.stabilize(&outwards(-1e-3, -10.0), 0.0);
    assert!((correction.observed_energy - 8e-3).abs() < 1e-15, "{} J", correction.observed_energy);
    assert_eq!((correction.alpha, correction.shortfall, here.absorbed()), (0.0, 0.0, 0.0));
    // The other side is told of nothing, and a mJ that it gives is a debt.
    there.receive(here.absorbed());
    there.stabilize(&PortSample::starting(PERIOD, 0.0, -1.0), 1.0);
    let correction: Correction<f64> = there.stabilize(&outwards(-1e-3, 1.0), 1.0);
    assert!((correction.observed_energy + 1e-3).abs() < 1e-15, "{} J", correction.observed_energy);
    // What came in is told, and pays for as much.
    here.stabilize(&outwards(0.0, 0.0), 1.0);
    here.stabilize(&outwards(1e-3, 1.0), 0.0);
    there.receive(here.absorbed());
    let correction = there.stabilize(&outwards(0.0, 1.0), 0.0);
    assert!(correction.observed_energy.abs() < 1e-15, "{} J", correction.observed_energy);
}

/// `in₁ + in₂ − out₁ − out₂ + burnt₁ + burnt₂` is the work of both ports, and never below `W₁ + W₂`, whatever applied.
#[test]
fn both_accounts_are_below_the_work_of_both_ports() {
    for seed in 0..20 {
        let mut dice = Dice::of(seed);
        let mut sides = [TwoPortSide::<Vector2<f64>>::new(limit(50.0)); 2];
        let mut drives = [PortSample::starting(PERIOD, Vector2::zeros(), Vector2::zeros()); 2];
        let (mut work, mut size, mut told) = (0.0, 0.0, [0.0; 2]);
        for tick in 0..1000 {
            let mut sum = 0.0;
            for side in 0..2 {
                // Late by up to some ticks, as the last message that came.
                if (tick + side) % 5 == 0 {
                    sides[side].receive(told[1 - side]);
                }
                let correction = sides[side].stabilize(&drives[side], dice.signal(5.0));
                sum += correction.observed_energy;
                let moved: Vector2<f64> = dice.signal(2e-4);
                // A motor that does not always do as it is told.
                let applied = correction.effort.map(|force| force.clamp(-8.0, 8.0));
                drives[side] = held_tick(Vector2::zeros(), moved, applied);
            }
            told = [sides[0].absorbed(), sides[1].absorbed()];
            assert!(sum <= work + 1e-12 * size, "{sum:e} J of {work:e} J");
            work += drives.iter().map(|sample| sample.work.sum()).sum::<f64>();
            size += drives.iter().map(|sample| sample.work.abs().sum()).sum::<f64>();
        }
    }
}

/// The slave's port: its force and the flow that is asked for, in admittance causality.
fn slave<T: Scalar>() -> DriftCompensated<TwoPortSide<T, Sampled>, T> {
    let side = TwoPortSide::new(limit(f64::INFINITY)).sampled();
    DriftCompensated::new(side, T::of(0.05)).expect("a speed")
}

fn drift<T: Scalar>() {
    let mut side = slave::<T>();
    let asked = [0.1, 0.1, 0.1, 0.1, 0.0, 0.0, 0.0, 0.0];
    let pushes = [1.0, 2.0, 2.0, 2.0, 1.0, 1.0, -1.0, -1.0];
    let received = [0.0, 0.1, 0.2, 0.3, 0.8, 1.5, 2.0, 2.0];
    let (mut sums, mut corrected, mut flows, mut drifts) = (vec![], vec![], vec![], vec![]);
    for tick in 0..8 {
        side.receive(T::of(1e-3 * received[tick]));
        let force = T::of(-pushes[tick]);
        let load = PortSample::from(AdmittanceSample::starting(T::of(PERIOD), force));
        let correction: Correction<T> = side.stabilize(&load, T::of(asked[tick]));
        sums.push(correction.observed_energy);
        corrected.push(T::of(asked[tick]) + correction.alpha * force);
        flows.push(correction.effort);
        drifts.push(side.drift());
    }
    near(&lane(&corrected), &[0.0, 0.05, 0.05, 0.05, 0.0, 0.0, 0.0, 0.0]);
    millijoules(&sums, &[-0.1, -0.1, -0.1, -0.1, 0.5, 1.15, 1.6, 1.65]);
    near(&lane(&flows), &[0.0, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05]);
    // In mm, of what is missing.
    millijoules(&drifts, &[-0.1, -0.15, -0.2, -0.25, -0.2, -0.15, -0.1, -0.05]);
}

crate::worked::each_scalar!(the_worked_drift, drift);

/// `W = 0.04 mJ` against 4 N moves 0.01 mm of 0.1 mm; `W = 1 mJ` moves all of it.
#[test]
fn surplus_or_error_binds() {
    for (surplus, step) in [(0.04e-3, 0.01e-3), (1e-3, 0.1e-3)] {
        let unlimited = TwoPortSide::<f64>::new(limit(f64::INFINITY)).sampled();
        let mut side = DriftCompensated::new(unlimited, f64::INFINITY).expect("no limit");
        // 0.1 m/s against 1 N, unpaid, is taken off: 0.1 mm of drift.
        let load = PortSample::from(AdmittanceSample::starting(PERIOD, -1.0));
        side.stabilize(&load, 0.1);
        assert!((side.drift() + 1e-4).abs() < 1e-12);
        // It gave 0.1 mJ and burnt as much.
        side.receive(surplus);
        let load = PortSample::from(AdmittanceSample::starting(PERIOD, -4.0));
        let flow: f64 = side.stabilize(&load, 0.0).effort;
        assert!((flow * PERIOD - step).abs() < 1e-9, "{flow} m/s");
    }
}

/// About 5 mm of drift against 1 N, and then 0.1 mJ: 0.1 mm comes back, and not again on every tick.
#[test]
fn a_surplus_is_spent_once() {
    macro_rules! comes_back {
        ($side:expr) => {{
            let mut side = DriftCompensated::new($side, 0.05).expect("a speed");
            let mut load = PortSample::from(AdmittanceSample::starting(PERIOD, -1.0));
            let mut lost = 0.0;
            for tick in 0..400 {
                if tick == 100 {
                    lost = side.drift();
                    side.receive(1e-4);
                }
                let asked = if tick < 50 { 0.1 } else { 0.0 };
                let flow = side.stabilize(&load, asked).effort;
                load = HeldFlow {
                    period: PERIOD,
                    momentum: 0.0,
                    effort: -1.0,
                    impulse: -PERIOD,
                    flow,
                }
                .sample()
                .into();
            }
            assert!(lost < -4.5e-3, "{lost} m");
            side.drift() - lost
        }};
    }
    let side = || TwoPortSide::<f64>::new(limit(f64::INFINITY));
    for back in [comes_back!(side()), comes_back!(side().sampled())] {
        assert!((back - 1e-4).abs() < 1e-9, "{back} m");
    }
}

/// Flow on the tick after a credit of 2 mJ, of a port that lags by 10 mm against 1 N, and the account a tick later.
fn pays_from<S>(account: S, asked: f64) -> (f64, f64)
where
    S: Stabilizer<f64> + Snapshot,
    DriftCompensated<S, f64>: Stabilizer<f64> + Account<f64>,
{
    let side = DriftCompensated::new(account, f64::INFINITY).expect("no limit");
    let (inside, _) = side.state();
    let mut side = side.restored((inside, 10e-3)).expect("a drift");
    let load = PortSample::from(AdmittanceSample::starting(PERIOD, 1.0));
    let flow = side.stabilize(&load, asked).effort;
    let spent =
        HeldFlow { period: PERIOD, momentum: PERIOD, effort: 1.0, impulse: PERIOD, flow }.sample();
    side.stabilize(&PortSample::from(spent), 0.0);
    (flow, side.observed_energy())
}

/// 2 mJ, of which a flow of −0.6 m/s against 1 N takes 0.6 mJ itself: −1.4 m/s are left. What a flow of 2 m/s brings is not
/// there yet: −2 m/s, after which a port has its 2 mJ still, and a side has told them to the other.
#[test]
fn what_the_flow_itself_takes_is_not_spent_twice() {
    let received = || {
        let mut side = TwoPortSide::<f64>::new(limit(f64::INFINITY));
        side.receive(2e-3);
        side
    };
    let port = || Popc::new(PortEnergy, limit(f64::INFINITY)).budgeted(2e-3).expect("a budget");
    let sampled = || received().sampled();
    for (told, flow, energy) in [
        (pays_from(port(), -0.6), -2.0, 0.0),
        (pays_from(port().sampled(), -0.6), -2.0, 0.0),
        (pays_from(received(), -0.6), -2.0, 0.0),
        (pays_from(sampled(), -0.6), -2.0, 0.0),
        (pays_from(port(), 2.0), 0.0, 2e-3),
        (pays_from(received(), 2.0), 0.0, 0.0),
        (pays_from(sampled(), 2.0), 0.0, 0.0),
    ] {
        assert!((told.0 - flow).abs() < 1e-12, "{} m/s", told.0);
        assert!((told.1 - energy).abs() < 1e-15, "{:e} J", told.1);
    }
}
