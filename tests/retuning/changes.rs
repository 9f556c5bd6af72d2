//! What a change between ticks does to the sum, the correction and the bound.

use nalgebra::Vector2;

use lyapunov::{
    DampingLimit, Dissipation, Lolc, PortEnergy, Scalar, Stabilizer,
    accumulators::{Accumulator, Compensated, Plain, Wide},
    stabilizers::{
        Account, AxisWeights, DirectedDamping, ForceBound, LeastNorm, PerAxis, Sharing,
        StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide, WatchdogTimes, WindowedCredit,
    },
};

use crate::support::{PERIOD, limit, popc, tick};

/// Reset, credit and debt are what they are called, in every account and through every adaptor.
fn keeps_account(mut account: impl Account<f64>) {
    account.reset();
    assert_eq!(account.observed_energy(), 0.0);
    account.grant(0.5).expect("a credit");
    account.owe(2.0).expect("a debt");
    assert_eq!(account.observed_energy(), -1.5);
    account.reset();
    assert_eq!(account.observed_energy(), 0.0);
    account.grant(0.0).expect("nothing");
    account.owe(0.0).expect("nothing");
    assert_eq!(account.observed_energy(), 0.0);
}

#[test]
fn accounts() {
    let popc = popc::<f64>();
    keeps_account(popc);
    keeps_account(popc.summed_in::<Compensated<f64>>());
    keeps_account(popc.summed_in::<Wide<f64>>());
    keeps_account(popc.summed_in::<WindowedCredit<f64, Plain<f64>, 8>>());
    keeps_account(popc.sampled());
    keeps_account(LeastNorm::new(PortEnergy, limit(), 0.5).expect("one"));
    let store = TankLimits { start: 2e-3, floor: 0.0, ceiling: 5e-3, power: 3.0 };
    keeps_account(Tank::new(PortEnergy, store).expect("one"));
    keeps_account(ForceBound::new(0.1).expect("one"));
    let sharing = Sharing { start: 1e-3, share: 0.1 };
    keeps_account(TwoLayer::<f64>::slave(sharing).expect("one"));
    keeps_account(TwoPortSide::<f64>::new(limit()));
    keeps_account(popc.bounded(10.0).expect("one"));
    keeps_account(popc.above_velocity(0.1).expect("one"));
    let times = WatchdogTimes { hold: 0.0, rise: 0.0 };
    keeps_account(popc.spread_over::<f64>(3).expect("one").watched::<f64>(times).expect("one"));
}

/// A reset keeps how long a slot of a window is.
#[test]
fn a_reset_window_keeps_its_length() {
    let mut window = WindowedCredit::<f64, Plain<f64>, 2>::of_ticks(3).expect("one");
    let fresh = window;
    for term in [1.0, 2.0, -0.5, 4.0, 0.25] {
        window.add(term);
    }
    window.clear();
    let mut other = fresh;
    for term in [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, 0.0, 1.0] {
        window.add(term);
        other.add(term);
        assert_eq!(window.value(), other.value());
    }
}

/// A debt carried over is served like one of its own, to the last bit.
#[test]
fn a_debt_carried_over_is_served() {
    let (mut one, mut other) = (popc::<f64>(), popc::<f64>());
    one.stabilize(&tick(-5e-4, 0.0), 0.0);
    other.owe(5e-4).expect("a debt");
    let moving = tick(0.0, 0.1);
    let (one, other) = (one.stabilize(&moving, 1.0), other.stabilize(&moving, 1.0));
    assert!(one.alpha > 0.0);
    assert_eq!(one, other);
}

/// The port may give what was granted and no more before the controller acts.
#[test]
fn a_grant_delays_the_controller_by_itself() {
    let mut popc = popc::<f64>();
    popc.grant(3e-4).expect("a credit");
    let given: Vec<_> = (0..4).map(|_| popc.stabilize(&tick(-1e-4, 0.1), 0.0).alpha).collect();
    assert!(given[..2].iter().all(|&alpha| alpha == 0.0), "{given:?}");
    assert!(given[3] > 0.0, "{given:?}");
}

/// A lower limit with a debt open serves it more slowly, reports the rest, and changes no sum; a higher one serves it.
#[test]
fn a_lower_limit_keeps_the_debt() {
    let mut popc = popc::<f64>();
    popc.owe(1e-3).expect("a debt");
    let moving = tick(0.0, 0.05);
    let square = 0.05 * 0.05 * PERIOD;
    for most in [20.0, 0.0, 100.0, 1e9] {
        popc.set_limit(DampingLimit::at(most).expect("a limit"));
        assert_eq!(popc.limit().most(), most);
        let correction = popc.stabilize(&moving, 0.0);
        assert_eq!(correction.observed_energy, -1e-3);
        let alpha = (1e-3 / square).min(most);
        assert!((correction.alpha - alpha).abs() <= 1e-12 * alpha, "{correction:?}");
        let left = 1e-3 - alpha * square;
        assert!((correction.shortfall - left).abs() <= 1e-12, "{correction:?}");
    }
}

/// A candidate that is changed credits from the next tick on, and the sum so far stays.
#[test]
fn a_candidate_changes_from_the_next_tick_on() {
    let damper = |b| Dissipation::of(b).expect("a damper");
    let mut lolc = Lolc::new((PortEnergy, damper(1.0)), limit());
    let moving = tick(0.0, 0.5);
    let once = 0.25 * PERIOD;
    let sum = |lolc: &mut Lolc<f64, _>| lolc.stabilize(&moving, 0.0).observed_energy;
    assert_eq!(sum(&mut lolc), once);
    lolc.candidate_mut().1 = damper(4.0);
    assert_eq!(lolc.candidate().1.damping(), 4.0);
    assert_eq!(sum(&mut lolc), once + 4.0 * once);
}

/// A loop that changes its period: work stays exact, and the limit made anew is the share of the new `m / T`.
#[test]
fn a_period_may_change() {
    let mut readings = lyapunov::Readings::<f64>::every(PERIOD).expect("a period");
    let mut popc = popc::<f64>();
    let mut told = 0.0;
    let (mut position, mut applied) = (0.25, 0.0);
    for tick in 0..20 {
        if tick == 10 {
            readings.set_period(PERIOD / 2.0).expect("a period");
            let limit = DampingLimit::of_mass(0.5, 0.2, PERIOD / 2.0).expect("a limit");
            popc.set_limit(limit);
            assert_eq!(popc.limit().most(), 200.0);
        }
        let checked = readings.read(lyapunov::Reading { position, applied });
        assert!(!checked.late);
        assert_eq!(checked.sample.period, if tick < 10 { PERIOD } else { PERIOD / 2.0 });
        told = popc.stabilize(&checked.sample, 0.0).observed_energy;
        position += 1.0 / 1024.0;
        applied = 2.0;
    }
    assert_eq!(told, 2.0 * 19.0 / 1024.0);
}

/// What is inside an adaptor can be reached and changed.
#[test]
fn adaptors_lend_what_is_inside() {
    let mut chain =
        popc::<f64>().bounded(1e-3).and_then(|it| it.spread_over::<f64>(4)).expect("one");
    let small = DampingLimit::at(1.0).expect("a limit");
    chain.stabilizer_mut().stabilizer_mut().set_limit(small);
    chain.owe(1.0).expect("a debt");
    assert_eq!(chain.stabilizer().stabilizer().observed_energy(), -1.0);
    assert_eq!(chain.stabilize(&tick(0.0, 0.1), 0.0).alpha, 1.0);
    chain.stabilizer_mut().set_most(2e-3).expect("a credit");
    assert_eq!(chain.stabilizer().most(), 2e-3);

    let weights = AxisWeights::new(Vector2::new(1.0, 0.5)).expect("weights");
    let mut directed = DirectedDamping::new(popc::<f64>(), weights, limit());
    directed.set_limit(small);
    assert_eq!(directed.limit(), small);
    let mut axes = PerAxis::of([popc::<f64>(); 2]);
    axes.axes_mut()[1].owe(1.0).expect("a debt");
    assert_eq!(axes.axes().map(|axis| axis.observed_energy()), [0.0, -1.0]);
    let mut port = lyapunov::environments::Spring::new(100.0).expect("a spring");
    let mut port = lyapunov::OnePort::<f64>::stabilized(&mut port, popc());
    port.stabilizer_mut().grant(1.0).expect("a credit");
    assert_eq!(port.stabilizer().observed_energy(), f64::of(1.0));
}
