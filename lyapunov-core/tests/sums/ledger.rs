//! Ledgers: which work is booked, and what the sum becomes.

use lyapunov_core::{
    Compensated, Held, Ledger, LyapunovCandidate, Observer, Plain, PortEnergy, PortSample, Sampled,
    Snapshot, StorageFunction,
};

fn moved() -> PortSample<f64> {
    PortSample {
        period: 0.5,
        position: 3.0,
        velocity: 4.0,
        displacement: 7.0,
        applied: 11.0,
        work: 13.0,
    }
}

/// Held work is the sample's own; sampled work is `f v T` of the effort that is asked now. Time never runs back.
#[test]
fn terms_see_the_work_that_is_booked() {
    let (held, sampled) = (Ledger::<Held, Plain<f64>>::new(), Ledger::<Sampled, Plain<f64>>::new());
    let back = |period| PortSample { period, ..moved() };
    assert_eq!(held.sample(&moved(), -2.0), moved());
    assert_eq!(held.sample(&back(-0.5), -2.0), back(0.0));
    let booked = PortSample { displacement: 2.0, applied: -2.0, work: -4.0, ..moved() };
    assert_eq!(sampled.sample(&moved(), -2.0), booked);
    let none = PortSample { period: 0.0, displacement: 0.0, work: 0.0, ..booked };
    assert_eq!(sampled.sample(&back(-0.5), -2.0), none);
}

/// Held work waits for the next sample to show what a correction did; sampled work takes it for granted.
#[test]
fn a_debt_is_raised_by_sampled_work_only() {
    let (mut held, mut sampled) =
        (Ledger::<Held, Plain<f64>>::new(), Ledger::<Sampled, Plain<f64>>::new());
    for (decrease, held_sum, sampled_sum) in
        [(-8.0, -8.0, -8.0), (-1.0, -9.0, -6.0), (9.0, 0.0, 6.0)]
    {
        assert_eq!(held.book(decrease, 3.0), held_sum);
        assert_eq!(sampled.book(decrease, 3.0), sampled_sum);
    }
    assert_eq!((held.energy::<f64>(), sampled.energy::<f64>()), (0.0, 6.0));
}

#[test]
fn credit_is_added_limited_and_forfeited() {
    let mut sum = Plain::zero_with(5.0);
    let mut ledger = Ledger::<Held, _>::in_sum(sum);
    assert_eq!(ledger.energy::<f64>(), 5.0);
    assert!(ledger.credit(2.0));
    assert_eq!(ledger.energy::<f64>(), 7.0);
    ledger.limit_credit(6.0);
    assert_eq!(ledger.energy::<f64>(), 6.0);
    let stored = ledger.state();
    ledger.clear::<f64>();
    assert_eq!(ledger.energy::<f64>(), 0.0);
    assert_eq!(ledger.restored(stored).map(|it| it.energy::<f64>()), Ok(6.0));
    assert!(ledger.restored(f64::NAN).is_err());
    sum = Plain::zero_with(f64::MAX);
    let full = Ledger::<Held, _>::in_sum(sum);
    for (energy, after) in
        [(-f64::MAX, Some(0.0)), (1.0, Some(f64::MAX)), (f64::MAX, None), (f64::NAN, None)]
    {
        let mut changed = full;
        assert_eq!(changed.credit(energy), after.is_some());
        assert_eq!(changed.energy::<f64>(), after.unwrap_or(f64::MAX));
    }
}

trait Of {
    fn zero_with(sum: f64) -> Self;
}

impl Of for Plain<f64> {
    fn zero_with(sum: f64) -> Self {
        use lyapunov_core::Accumulator;
        let mut plain = Self::zero();
        plain.add(sum);
        plain
    }
}

/// What does not fit is not booked; what fits is, and nothing is raised.
#[test]
fn an_observer_books_what_fits() {
    let mut observer = Observer::of(PortEnergy);
    let with = |work| PortSample { work, ..moved() };
    let sums = [-3.0, f64::NAN, -1.0, 6.0].map(|work| observer.observe(&with(work), 0.0));
    assert_eq!(sums, [-3.0, -3.0, -4.0, 2.0]);
    let mut sampled = observer.over::<Sampled>().summed_in::<f64, Compensated<f64>>();
    assert_eq!(sampled.observe(&moved(), -2.0), -2.0, "2 J and −2 N · 4 m/s · 0.5 s");
    assert_eq!(sampled.observe(&moved(), 1.0), 0.0);
    let restored = Observer::of(PortEnergy).restored(observer.state()).expect("a memory");
    assert_eq!(restored.ledger.energy::<f64>(), 2.0);
}

/// The decrease of `x² + v`, a sum of terms, and a value that is not finite, which is not remembered.
#[test]
fn decreases_are_differences() {
    let function = |x: f64, v: f64| x * x + v;
    let mut stored = StorageFunction::starting(function, 2.0, 1.0);
    let at = |position, velocity| PortSample { position, velocity, ..moved() };
    assert_eq!(stored.decrease(&at(3.0, 1.0)), -5.0);
    assert!(stored.decrease(&at(f64::NAN, 1.0)).is_nan());
    assert_eq!(stored.state(), 10.0);
    let mut three = (PortEnergy, stored, PortEnergy);
    assert_eq!(three.decrease(&at(1.0, 2.0)), 13.0 + 7.0 + 13.0);
    let mut two = (PortEnergy, stored);
    let lent = &mut &mut two;
    assert_eq!(LyapunovCandidate::<f64>::decrease(lent, &at(1.0, 2.0)), 13.0 + 7.0);
    assert_eq!(two.1.decrease(&at(1.0, 2.0)), 0.0);
    assert_eq!(stored.restored(8.0).map(|mut it| it.decrease(&at(1.0, 2.0))), Ok(5.0));
    assert!(stored.restored(f64::INFINITY).is_err());
    // The first energy that is known is no decrease, and takes nothing from the terms beside it.
    let unknown = StorageFunction::starting(function, f64::NAN, 0.0);
    assert_eq!((PortEnergy, unknown).decrease(&at(3.0, 1.0)), 13.0);
    let mut unknown = unknown;
    assert!(unknown.decrease(&at(f64::NAN, 1.0)).is_nan());
    assert_eq!(unknown.decrease(&at(3.0, 1.0)), 0.0);
    assert_eq!(unknown.decrease(&at(1.0, 1.0)), 8.0);
}
