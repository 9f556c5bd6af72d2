//! What a change between ticks does to the sum, the correction and the bound.

use nalgebra::{Matrix1, Vector2};

use lyapunov::{
    Correction, DampingLimit, Dissipation, HeldTick, Lolc, PortEnergy, PortSample, Scalar,
    Snapshot, Stabilizer,
    accumulators::{Accumulator, Compensated, Plain, Wide},
    laws::Samples,
    stabilizers::{
        Account, AxisWeights, DirectedDamping, EnergyBounding, ForceBound, Inertia, InertiaLimit,
        JointInertia, LeastNorm, MemoryBased, PathMemory, PerAxis, Sharing, SlopeBound,
        StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide, WatchdogTimes, WindowedCredit,
    },
};

use crate::support::{PERIOD, limit, popc};

/// A tick that does `work` J of work at `velocity` m/s.
fn tick(work: f64, velocity: f64) -> PortSample<f64> {
    let displacement = velocity * PERIOD;
    let tick = HeldTick { period: PERIOD, position: 0.0, velocity, displacement, applied: 0.0 };
    PortSample { work, ..tick.sample() }
}

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
    keeps_account(EnergyBounding::<f64>::new(500.0, 250.0).expect("one"));
    keeps_account(SlopeBound::<f64>::new(1e3).expect("one"));
    keeps_account(MemoryBased::<f64, 8>::beyond(0.0, 0.1).expect("one"));
    let inertia = JointInertia::new(Matrix1::new(0.2)).expect("one");
    keeps_account(InertiaLimit::new(popc, inertia, 0.5, PERIOD).expect("one"));
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

/// 0.5 m/s is 0.5 m/s at the new period, over a window that holds positions of the old one: before the change, with it, after
/// a reading that is lost, and in a memory that was stored in between.
#[test]
fn a_window_begins_anew_at_another_period() {
    let fresh = lyapunov::Readings::<f64>::every(PERIOD).expect("a period");
    let mut readings = fresh.windowed::<16>(16, 1e-2).expect("a window");
    let (mut position, mut period) = (0.0, PERIOD);
    for tick in 0..60 {
        if tick % 20 == 19 {
            period *= 0.5;
            readings.set_period(period).expect("a period");
            readings.set_period(period).expect("the same");
            readings = readings.restored(readings.state()).expect("its own memory");
        }
        position += 0.5 * period;
        let told = if tick == 39 { f64::NAN } else { position };
        let checked = readings.read(lyapunov::Reading { position: told, applied: 0.0 });
        let right = tick == 0 || tick == 39 || (checked.sample.velocity - 0.5).abs() < 1e-9;
        assert!(right, "{} m/s on tick {tick}", checked.sample.velocity);
    }
    // The same period leaves the window as it is: 16 readings of 1 mm/s and one of 0.1 m/s.
    let mut readings = fresh.windowed::<16>(16, 1e-2).expect("a window");
    for tick in 0..20 {
        readings
            .read(lyapunov::Reading { position: 1e-3 * PERIOD * f64::from(tick), applied: 0.0 });
    }
    readings.set_period(PERIOD).expect("a period");
    let position = 1e-3 * PERIOD * 19.0 + 0.1 * PERIOD;
    let velocity = readings.read(lyapunov::Reading { position, applied: 0.0 }).sample.velocity;
    assert!((velocity - (15.0 * 1e-3 + 0.1) / 16.0).abs() < 1e-9, "{velocity} m/s");
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

/// What was changed acts as what was made so: from the same state, the same corrections to the bit.
fn becomes<S>(mut changed: S, made: S, change: impl FnOnce(&mut S))
where
    S: Stabilizer<f64> + Snapshot + Clone,
{
    let mut samples = Samples::<f64>::new(PERIOD);
    for (sample, effort) in samples.by_ref().take(300) {
        changed.stabilize(&sample, effort);
    }
    let mut made = made.restored(changed.state()).expect("a state");
    let mut as_it_was = changed.clone();
    change(&mut changed);
    let mut acted = false;
    for (sample, effort) in samples.take(300) {
        let [one, other] = [&mut changed, &mut made].map(|it| it.stabilize(&sample, effort));
        assert_eq!(format!("{one:?}"), format!("{other:?}"));
        acted |= format!("{:?}", as_it_was.stabilize(&sample, effort)) != format!("{one:?}");
    }
    assert!(acted, "the change changes something");
}

#[test]
fn what_was_changed_acts_as_what_was_made_so() {
    let popc = popc::<f64>();
    let store = TankLimits { start: 2e-3, floor: 0.0, ceiling: 5e-3, power: 3.0 };
    let tank = |store| Tank::new(PortEnergy, store).expect("one");
    becomes(tank(store), tank(TankLimits { ceiling: 2e-3, ..store }), |it| {
        it.set_room(2e-3).expect("a room");
    });
    becomes(tank(store), tank(TankLimits { power: 0.5, ..store }), |it| {
        it.set_power(0.5).expect("a power");
    });
    let filter = |decay| LeastNorm::new(PortEnergy, limit(), decay).expect("one");
    becomes(filter(1.0), filter(0.01), |it| it.set_decay(0.01).expect("a decay"));
    let [one, other] = [3, 9].map(|ticks| popc.rising_over::<f64>(ticks).expect("one"));
    becomes(one, other, |it| it.set_ticks(9).expect("ticks"));
    let [one, other] = [3, 9].map(|ticks| popc.spread_over::<f64>(ticks).expect("one"));
    becomes(one, other, |it| it.set_ticks(9).expect("ticks"));
    let [one, other] = [1e-3, 0.5].map(|speed| popc.above_velocity(speed).expect("one"));
    becomes(one, other, |it| it.set_velocity(0.5).expect("a speed"));
    let limited = |cap| InertiaLimit::new(NoLimit, Mass(1e-3), cap, PERIOD).expect("one");
    let late = limited(0.01).delayed(2);
    let rate = late.rate();
    becomes(limited(0.5), late, |it| it.set_rate(rate));
    let slope = |slope, creep| {
        SlopeBound::<f64>::new(slope).and_then(|it| it.creeping(creep)).expect("one")
    };
    becomes(slope(1e3, 0.0), slope(10.0, 5.0), |it| {
        it.set_slope(10.0).expect("a slope");
        it.set_creep(5.0).expect("a creep");
    });
    let side = TwoPortSide::<f64>::new;
    let small = DampingLimit::at(0.1).expect("a limit");
    becomes(side(limit()), side(small), |it| it.set_limit(small));
    let layer = |share, level, gain| {
        TwoLayer::master(Sharing { start: 1e-3, share }, level, gain).expect("one")
    };
    becomes(layer(0.1, 1e-3, 500.0), layer(0.4, 2e-3, 100.0), |it| {
        it.set_share(0.4).expect("a share");
        it.set_filling(2e-3, 100.0).expect("a level");
    });
}

/// A mass along one axis, kg.
#[derive(Clone)]
struct Mass(f64);

impl Inertia<f64> for Mass {
    fn inverse_square(&self, effort: f64) -> f64 {
        effort * effort / self.0
    }
}

/// A damper of 50 N·s/m that has no limit of its own.
#[derive(Clone)]
struct NoLimit;

impl Stabilizer<f64> for NoLimit {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let alpha = 50.0;
        Correction { alpha, ..Correction::none(effort + alpha * sample.velocity) }.checked()
    }
}

impl Snapshot for NoLimit {
    type State = ();

    fn state(&self) {}

    fn restored(self, _state: ()) -> Result<Self, lyapunov::ParameterError> {
        Ok(self)
    }
}

/// What is read is what was set, and what is refused is not.
#[test]
fn what_is_read_is_what_was_set() {
    let popc = popc::<f64>();
    let mut slow = popc.above_velocity(0.05).expect("one");
    assert_eq!(slow.velocity(), 0.05);
    assert!(slow.set_velocity(1e200).is_err() && slow.set_velocity(-1.0).is_err());
    assert_eq!(slow.velocity(), 0.05);
    let mut spread = popc.spread_over::<f64>(4).expect("one");
    assert!(spread.set_ticks(0).is_err() && spread.ticks() == 4);
    let mut filter = LeastNorm::new(PortEnergy, limit(), 0.5).expect("one");
    assert!(filter.set_decay(1.5).is_err() && filter.decay() == 0.5);
    let mut slope = SlopeBound::<f64>::new(1e3).expect("one");
    assert!(slope.set_slope(0.0).is_err() && slope.set_creep(f64::NAN).is_err());
    assert_eq!((slope.slope(), slope.creep()), (1e3, 0.0));
    let mut layer = TwoLayer::master(Sharing { start: 0.0, share: 0.1 }, 1.0, 2.0).expect("one");
    assert!(layer.set_share(1.1).is_err() && layer.set_filling(3.0, -1.0).is_err());
    assert_eq!((layer.share(), layer.filling()), (0.1, (1.0, 2.0)));
    let mut path = PathMemory::<f64, 8>::beyond(0.0, 0.1).expect("one");
    path.owe(2e-3).expect("a debt");
    assert!(path.owe(f64::NAN).is_err() && path.debt() == 2e-3);
    assert_eq!(path.stabilize(&tick(0.0, 0.0), 1.0).observed_energy, -2e-3);
}
