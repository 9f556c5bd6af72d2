//! The observer/controller against its recursion in whole numbers, to the bit where no division is.

use lyapunov::lanes::WideF64x4;
use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, Popc, PortEnergy, PortSample, Scalar, Signal,
    Stabilizer,
    accumulators::{Compensated, Plain},
    stabilizers::{Account, LimitCredit},
};
use nalgebra::Vector2;

use crate::support::Dice;

const MOST: f64 = 8.0; // N·s/m
const DAMPING: f64 = 3.0; // N·s/m
const PERIOD: f64 = 0.25; // s

/// Fields that are small whole numbers of powers of two, so that every product and sum of them is exact.
fn ticks<V: Signal<Scalar = f64>>(seed: u64) -> impl Iterator<Item = (PortSample<V>, V)> {
    let mut dice = Dice::of(seed);
    (0..1500).map(move |tick| {
        let mut whole = |size: f64| V::zero().map(|_| dice.within(size).round() / 4.0);
        let velocity = if tick % 9 == 8 { V::zero() } else { whole(9.0) };
        let [position, displacement, applied, work, effort] =
            [90.0, 9.0, 90.0, 60.0, 90.0].map(&mut whole);
        let sample = PortSample { period: PERIOD, position, velocity, displacement, applied, work };
        (sample, effort)
    })
}

/// Ways in which a sample is spoilt, and whether its work and its credit still count.
fn spoilt<V: Signal<Scalar = f64>>(tick: usize, told: (PortSample<V>, V)) -> (PortSample<V>, V) {
    let (sample, effort) = told;
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][tick / 70 % 3];
    match tick % 70 {
        11 => (PortSample { velocity: V::splat(bad), ..sample }, effort),
        23 => (PortSample { work: V::splat(bad), ..sample }, effort),
        37 => (sample, V::splat(bad)),
        41 => (PortSample { period: -PERIOD, ..sample }, effort),
        53 => (PortSample { period: bad, ..sample }, effort),
        67 => (PortSample { period: 0.0, ..sample }, effort),
        _ => (sample, effort),
    }
}

/// The tick contract, line by line: `sum` is what was observed up to now.
struct ByHand {
    sum: f64,
    sampled: bool,
    credit: f64,
}

impl ByHand {
    fn tick<V: Signal<Scalar = f64>>(
        &mut self,
        sample: &PortSample<V>,
        effort: V,
        told: &Correction<V>,
    ) {
        let period = if sample.period > 0.0 { sample.period } else { 0.0 };
        let square = sample.velocity.inner(sample.velocity) * period;
        let work = if self.sampled {
            effort.inner(sample.velocity.map(|v| v * period))
        } else {
            sample.work.sum()
        };
        let burnt = self.credit * square;
        let decrease = work + if burnt.is_finite() { burnt } else { 0.0 };
        let accepted =
            sample.period > 0.0 && [square, decrease, effort.sum()].into_iter().all(f64::is_finite);
        if decrease.is_finite() {
            self.sum += decrease;
        }
        let debt = if self.sum < 0.0 { -self.sum } else { 0.0 };
        assert_eq!((told.observed_energy, told.accepted), (self.sum, accepted), "{sample:?}");
        if !accepted {
            assert_eq!(
                (told.effort, told.alpha, told.shortfall),
                (V::zero(), 0.0, debt),
                "{sample:?}"
            );
            return;
        }
        // What the damper takes is the debt, rounded up, or the most that it can.
        if square == 0.0 || debt == 0.0 {
            assert_eq!(told.alpha, 0.0);
        } else if debt >= MOST * square {
            assert_eq!(told.alpha, MOST);
        } else {
            let exact = debt / square;
            let most = (exact * (1.0 + 12.0 * f64::EPSILON)).min(MOST);
            assert!(told.alpha >= exact && told.alpha <= most, "{} for {exact}", told.alpha);
        }
        let served = self.sum + told.alpha * square;
        let below_its_limit = square > 0.0 && told.alpha < MOST;
        assert!(served >= 0.0 || !below_its_limit, "{served:e} is left below the limit");
        assert_eq!(told.shortfall, if served < 0.0 { -served } else { 0.0 });
        assert_eq!(told.effort, effort.zip(sample.velocity, |f, v| f + told.alpha * v));
        if self.sampled && self.sum < 0.0 {
            self.sum = (self.sum + MOST * square).min(0.0);
        }
    }
}

fn limit() -> DampingLimit<f64> {
    DampingLimit::at(MOST).expect("a limit")
}

fn follows<V: Signal<Scalar = f64>>(mut one: impl Stabilizer<V>, by_hand: ByHand) {
    let mut by_hand = by_hand;
    for (tick, told) in ticks::<V>(3).enumerate() {
        let (sample, effort) = spoilt(tick, told);
        let correction = one.stabilize(&sample, effort);
        by_hand.tick(&sample, effort, &correction);
    }
}

fn on<V: Signal<Scalar = f64>>() {
    let damper = Dissipation::of(DAMPING).expect("a damping");
    let (popc, lolc) = (Popc::new(PortEnergy, limit()), Lolc::new((PortEnergy, damper), limit()));
    let held = |sum, credit| ByHand { sum, sampled: false, credit };
    let sampled = |credit| ByHand { sum: 0.0, sampled: true, credit };
    follows::<V>(popc, held(0.0, 0.0));
    follows::<V>(lolc, held(0.0, DAMPING));
    follows::<V>(lolc.sampled(), sampled(DAMPING));
    follows::<V>(popc.sampled(), sampled(0.0));
    follows::<V>(lolc.summed_in::<Compensated<f64>>(), held(0.0, DAMPING));
    follows::<V>(popc.budgeted(24.0).expect("a budget"), held(24.0, 0.0));
}

#[test]
fn follows_the_recursion() {
    on::<f64>();
    on::<Vector2<f64>>();
}

/// Debts of every size are served in full, by a product that a reader can check.
#[test]
fn a_debt_is_served_to_the_last_bit() {
    let mut dice = Dice::of(9);
    for _ in 0..20_000 {
        let (velocity, period) = (dice.within(3.0), dice.within(1.0).abs());
        is_served(velocity, period, dice.within(1.0).abs());
    }
    // A square so many steps above the smallest normal number.
    for step in 1..2000 {
        let period = 1.0 + f64::from(step % 40 + 1) * f64::EPSILON;
        is_served(2f64.powi(-511), period, dice.within(1.0).abs());
    }
}

fn is_served(velocity: f64, period: f64, debt: f64) {
    let unlimited = DampingLimit::at(f64::INFINITY).expect("none");
    let sample = PortSample { work: -debt, ..PortSample::starting(period, 0.0, velocity) };
    let told = Popc::new(PortEnergy, unlimited).stabilize(&sample, 0.0);
    let served = told.observed_energy + told.alpha * ((velocity * velocity) * period);
    assert!(served >= 0.0 && told.shortfall == 0.0, "{served:e}: {sample:?} {told:?}");
    assert!(served <= debt * 16.0 * f64::EPSILON, "{served:e} too much: {told:?}");
}

/// A square that is not normal is no motion.
#[test]
fn no_damping_where_the_division_would_be_by_nearly_nothing() {
    let at = |velocity| PortSample { work: -1.0, ..PortSample::starting(1.0, 0.0, velocity) };
    let told = Popc::new(PortEnergy, limit()).stabilize(&at(1e-154), 2.0);
    assert_eq!((told.alpha, told.shortfall, told.effort, told.accepted), (0.0, 1.0, 2.0, true));
    let told = Popc::new(PortEnergy, limit()).stabilize(&at(1e-150), 2.0);
    assert_eq!((told.alpha, told.effort, told.accepted), (MOST, 2.0 + 8e-150, true));
}

/// What does not add up to a finite number is rejected, and only that.
#[test]
fn numbers_that_leave_the_range_are_rejected() {
    let with = |work, velocity| PortSample { work, ..PortSample::starting(0.25, 0.0, velocity) };
    for (work, velocity, effort, accepted) in [
        (1.7e308, 0.0, 1.7e308, false),
        (1e200, 0.0, 1e200, true),
        (1e200, 0.0, -1e200, true),
        (0.0, 1e200, 0.0, false),
        (-1.7e308, 0.5, -1.7e308, false),
    ] {
        let told = Popc::new(PortEnergy, limit()).stabilize(&with(work, velocity), effort);
        assert_eq!(
            (told.accepted, told.observed_energy),
            (accepted, work),
            "{work} {velocity} {effort}"
        );
    }
    // A sum that is full takes no more, and keeps what it has.
    let mut full = Popc::new(PortEnergy, limit());
    let sums = [1.7e308, 1.7e308, -1.0e308]
        .map(|work| full.stabilize(&with(work, 0.0), 0.0).observed_energy);
    assert_eq!(sums, [1.7e308, 1.7e308, 1.7e308 - 1.0e308]);
}

/// Each lane is the scalar run, also beside one that is rejected.
#[test]
fn lanes_are_scalar_runs() {
    let damper = Dissipation::of(WideF64x4::of(DAMPING)).expect("a damping");
    let most = DampingLimit::at(WideF64x4::of(MOST)).expect("a limit");
    let mut lanes = Lolc::new((PortEnergy, damper), most);
    let damper = Dissipation::of(DAMPING).expect("a damping");
    let mut alone = [Lolc::new((PortEnergy, damper), limit()); 4];
    let mut streams = [1, 2, 3, 4].map(ticks::<f64>);
    for tick in 0..1500 {
        // Another place for the spoilt sample in each lane.
        let lanes_told = streams.iter_mut().enumerate();
        let told: Vec<_> = lanes_told
            .map(|(lane, stream)| spoilt(tick + 5 * lane, stream.next().expect("a tick")))
            .collect();
        let of = |field: &dyn Fn(&PortSample<f64>) -> f64| {
            WideF64x4::from_lanes(|lane| field(&told[lane].0))
        };
        let sample = PortSample {
            period: of(&|it| it.period),
            position: of(&|it| it.position),
            velocity: of(&|it| it.velocity),
            displacement: of(&|it| it.displacement),
            applied: of(&|it| it.applied),
            work: of(&|it| it.work),
        };
        let correction = lanes.stabilize(&sample, WideF64x4::from_lanes(|lane| told[lane].1));
        for (lane, one) in alone.iter_mut().enumerate() {
            let own = one.stabilize(&told[lane].0, told[lane].1);
            let Correction { effort, observed_energy, alpha, shortfall, accepted } = correction;
            let found = [effort, observed_energy, alpha, shortfall].map(|it| it.lane(lane));
            assert_eq!(
                found,
                [own.effort, own.observed_energy, own.alpha, own.shortfall],
                "{tick}"
            );
            assert_eq!(lyapunov::Mask::lane(accepted, lane), own.accepted, "{tick}");
        }
    }
}

#[test]
fn is_changed_between_ticks() {
    let damper = Dissipation::of(DAMPING).expect("a damping");
    let mut lolc = Lolc::new((PortEnergy, damper), limit());
    assert_eq!((lolc.candidate().1.damping(), lolc.limit().most()), (DAMPING, MOST));
    lolc.candidate_mut().1 = Dissipation::of(5.0).expect("a damping");
    assert_eq!(lolc.candidate().1.damping(), 5.0);
    lolc.set_limit(DampingLimit::at(2.0).expect("a limit"));
    let moving = PortSample { work: -100.0, ..PortSample::starting(0.25, 0.0, 2.0) };
    let told = lolc.stabilize(&moving, 0.0);
    assert_eq!((told.alpha, told.observed_energy), (2.0, -95.0));
    let mut sum = Plain::<f64>::default_sum();
    lyapunov::accumulators::Accumulator::add(&mut sum, 7.0);
    let mut from = Popc::new(PortEnergy, limit()).summed_by(sum);
    assert_eq!(from.observed_energy(), 7.0);
    from.limit_credit(6.0);
    assert_eq!(from.observed_energy(), 6.0);
    from.grant(2.0).expect("a credit");
    from.owe(11.0).expect("a debt");
    assert_eq!(from.observed_energy(), -3.0);
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(from.grant(bad).is_err() && from.owe(bad).is_err() && from.budgeted(bad).is_err());
    }
    from.reset();
    assert_eq!(from.observed_energy(), 0.0);
    // What there is no room for is refused; nothing at all is not.
    assert!(from.grant(0.0).is_ok() && from.owe(0.0).is_ok());
    from.grant(1e200).expect("room");
    assert!(from.grant(1e200).is_ok() && from.owe(f64::MAX).is_ok());
    assert!(from.owe(f64::MAX).is_err(), "twice the largest number");
    from.reset();
    from.grant(f64::MAX).expect("room");
    assert!(from.grant(f64::MAX).is_err() && from.observed_energy() == f64::MAX);
    assert!(from.owe(f64::MAX).is_ok() && from.observed_energy() == 0.0);
}

trait Empty {
    fn default_sum() -> Self;
}

impl Empty for Plain<f64> {
    fn default_sum() -> Self {
        lyapunov::accumulators::Accumulator::zero()
    }
}
