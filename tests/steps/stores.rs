//! Tanks and the least-norm filter: their credit, what they accept, and what they hand out.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, DampingLimit, Dissipation, ParameterError, PortEnergy, PortSample, Stabilizer,
    accumulators::Compensated,
    stabilizers::{Account, EnergyTank, LeastNorm, LimitCredit, Tank, TankLimits},
};

use crate::support::Dice;

const PERIOD: f64 = 0.25; // s
const OPEN: TankLimits<f64> =
    TankLimits { start: 0.0, floor: 0.0, ceiling: f64::INFINITY, power: f64::INFINITY };

fn filter(decay: f64) -> LeastNorm<f64, PortEnergy> {
    let limit = DampingLimit::at(f64::INFINITY).expect("no limit");
    LeastNorm::new(PortEnergy, limit, decay).expect("a filter")
}

fn at(velocity: f64, work: f64) -> PortSample<f64> {
    PortSample { work, ..PortSample::starting(PERIOD, 0.0, velocity) }
}

/// Credit that is limited is gone, and a limit above it changes nothing.
#[test]
fn credit_is_limited() {
    let mut filter = filter(0.5).budgeted(4.0).expect("a budget");
    let mut tank = Tank::new(PortEnergy, TankLimits { start: 4.0, ..OPEN }).expect("a tank");
    for (most, left) in [(9.0, 4.0), (3.0, 3.0), (0.0, 0.0)] {
        filter.limit_credit(most);
        tank.limit_credit(most);
        assert_eq!((filter.observed_energy(), tank.observed_energy()), (left, left));
    }
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let error = self::filter(0.5).budgeted(bad).expect_err("refused");
        assert!(error.parameter == "budget" && error.to_string().contains(&format!("{bad:?}")));
    }
}

/// What is lacking is served to the last bit, by a product that a reader can check.
#[test]
fn what_is_lacking_is_served_in_full() {
    let mut dice = Dice::of(23);
    for _ in 0..20_000 {
        let (velocity, effort) = (dice.within(3.0), dice.within(5.0));
        let mut one = filter(0.5).budgeted(dice.within(1e-3).abs()).expect("a budget");
        let sample = at(velocity, 0.0);
        let told = one.stabilize(&sample, effort);
        let given = effort * velocity * PERIOD;
        let slack = 0.5 * told.observed_energy + given;
        let served = slack + told.alpha * (velocity * velocity * PERIOD);
        assert!(served >= 0.0 && told.shortfall == 0.0, "{served:e}: {told:?}");
        let most = slack.max(0.0) + 64.0 * f64::EPSILON * given.abs();
        assert!(served <= most, "{served:e} J too much: {told:?}");
    }
}

/// `γ L + f · v T ≥ 0` needs nothing; below, the force is the least that does, at most the limit's.
#[test]
fn the_least_change_is_made() {
    let limit = DampingLimit::at(6.0).expect("a limit");
    let made = LeastNorm::new(PortEnergy, limit, 0.25).and_then(|it| it.budgeted(8.0));
    // 2 J may go, over 2 m/s · 0.25 s: 4 N out.
    for (effort, given, shortfall) in
        [(-3.0, -3.0, 0.0), (-4.0, -4.0, 0.0), (-10.0, -4.0, 0.0), (-20.0, -8.0, 2.0)]
    {
        let told: Correction<f64> = made.expect("a filter").stabilize(&at(2.0, 0.0), effort);
        assert_relative_eq!(told.effort, given, max_relative = 1e-14);
        assert_relative_eq!(told.shortfall, shortfall, max_relative = 1e-14);
        assert!(told.accepted && told.observed_energy == 8.0);
    }
}

/// What is finite and adds up is accepted, also where products of it do not; what moves too fast to have a square is not.
#[test]
fn the_filter_rejects_what_it_cannot_measure() {
    for (velocity, work, effort, accepted) in [
        (1e100, 0.0, 1e100, true),
        (1e100, 1e200, 0.0, true),
        (1e100, 1e200, 1e100, true),
        (0.0, 1e308, 1e308, true),
        (1e200, 0.0, 0.0, false),
        (1e200, 0.0, 5.0, false),
        (0.0, 1.7e308, 0.0, false),
        (1e154, 1.1e308, 0.0, false),
        (1e154, 0.9e308, 0.0, true),
        (0.0, 0.0, f64::INFINITY, false),
    ] {
        let told = filter(0.5).stabilize(&at(velocity, work), effort);
        assert_eq!(told.accepted, accepted, "{velocity} {work} {effort}: {told:?}");
        assert!(accepted || told.effort == 0.0 && told.alpha == 0.0, "{told:?}");
    }
}

/// The valve hands out what is there, and the most of its power.
#[test]
fn a_tank_hands_out_its_energy_or_its_power() {
    let store = TankLimits { start: 5.0, floor: 1.0, ceiling: 9.0, power: 40.0 };
    let out = |store, effort: f64, velocity: f64| {
        let mut tank = Tank::new(PortEnergy, store).expect("a tank");
        tank.stabilize(&at(velocity, 0.0), effort).effort
    };
    for (effort, velocity) in [(7.9, -2.0), (64.0, 4.0)] {
        assert_eq!(out(store, effort, velocity), effort);
    }
    // 4 J over a quarter of a second are 16 W, of which it keeps what a step may round.
    for (effort, velocity, given) in [(8.0, -2.0, 8.0), (10.0, -2.0, 8.0), (-64.0, 4.0, -4.0)] {
        let kept = (1.0 - out(store, effort, velocity) / given) / f64::EPSILON;
        assert!((3.0..=5.0).contains(&kept), "{kept} epsilon of {given} N");
    }
    assert_eq!(out(TankLimits { power: 6.0, ..store }, 10.0, -2.0), 3.0);
    let mut tank = Tank::new(PortEnergy, store).expect("a tank");
    assert_eq!((tank.room(), tank.power()), (8.0, 40.0));
    let full = tank.stabilize(&at(0.0, 100.0), 0.0);
    assert_eq!((full.observed_energy, tank.observed_energy()), (8.0, 8.0));
    let owed = tank.stabilize(&at(0.0, -11.0), 2.0);
    assert_eq!((owed.observed_energy, owed.shortfall, owed.effort), (-3.0, 3.0, 2.0));
    assert_eq!(tank.stabilize(&at(-1.0, 0.0), 2.0).effort, 0.0);
}

/// In computed numbers: a tank that is asked for more than it holds keeps no less than nothing, and next to nothing.
#[test]
fn a_tank_is_not_overdrawn_by_rounding() {
    let mut dice = Dice::of(29);
    for _ in 0..20_000 {
        let start = dice.within(1.0).abs() * 10f64.powf(dice.within(6.0));
        let mut tank = EnergyTank::new(TankLimits { start, ..OPEN }).expect("a tank");
        let (period, flow) = (0.1 + dice.within(0.09), 1.0 + dice.within(0.9));
        let given = tank.pass(period, 0.0, 1e12, flow);
        assert!(tank.energy() >= 0.0, "{} J of {start:e} J", tank.energy());
        assert_relative_eq!(given * flow * period, start, max_relative = 1e-14);
    }
}

/// As the filter does: what is asked, the period and the work are finite, and so is what they add up to.
#[test]
fn a_tank_rejects_what_does_not_add_up() {
    for (velocity, work, effort, accepted) in [
        (1e100, 1e200, 1e100, true),
        (1e100, -1e200, -1e100, true),
        (-1e154, 1e308, 1e154, false),
        (-1e154, -1e308, 1e154, true),
        (1.0, 0.0, f64::NAN, false),
        (0.0, 0.0, f64::INFINITY, false),
        (f64::NAN, 0.0, 0.0, false),
        (0.0, f64::NAN, 0.0, false),
    ] {
        let mut tank = Tank::new(PortEnergy, OPEN).expect("a tank");
        let told = tank.stabilize(&at(velocity, work), effort);
        assert_eq!(told.accepted, accepted, "{velocity} {work} {effort}: {told:?}");
        assert!(accepted || told.effort == 0.0, "{told:?}");
    }
    // Nor over a time that is none, or so long that it is none.
    for (period, accepted) in [(1e200, true), (0.0, false), (-1.0, false), (f64::INFINITY, false)] {
        let mut tank = Tank::new(PortEnergy, TankLimits { start: 1.0, ..OPEN }).expect("a tank");
        let told = tank.stabilize(&PortSample { period, ..at(-1e100, 0.0) }, 1e100);
        assert_eq!(told.accepted, accepted, "{period}: {told:?}");
    }
}

/// The candidate is lent, and what it is changed to counts from then on.
#[test]
fn a_candidate_is_lent() {
    let damper = |damping| Dissipation::of(damping).expect("a damping");
    let limit = DampingLimit::at(1.0).expect("a limit");
    let mut tank = Tank::new((PortEnergy, damper(2.0)), OPEN).expect("a tank");
    let mut filter = LeastNorm::new((PortEnergy, damper(2.0)), limit, 0.5).expect("a filter");
    assert_eq!((tank.candidate().1.damping(), filter.candidate().1.damping()), (2.0, 2.0));
    (tank.candidate_mut().1, filter.candidate_mut().1) = (damper(8.0), damper(8.0));
    let moving = at(2.0, 0.0);
    let told = [tank.stabilize(&moving, 0.0), filter.stabilize(&moving, 0.0)];
    assert_eq!(told.map(|it| it.observed_energy), [8.0; 2]);
    filter.set_limit(DampingLimit::at(3.0).expect("a limit"));
    assert_eq!((filter.limit().most(), filter.decay()), (3.0, 0.5));
}

/// A sum that is compensated keeps what a plain one loses: as many small works as there are digits beside one large one.
#[test]
fn the_filter_sums_as_it_is_told() {
    let mut plain = filter(0.5);
    let mut compensated = filter(0.5).summed_in::<Compensated<f64>>();
    for work in std::iter::once(2f64.powi(53)).chain([1.0; 64]) {
        let told =
            [plain.stabilize(&at(0.0, work), 0.0), compensated.stabilize(&at(0.0, work), 0.0)];
        assert!(told[0].accepted && told[1].accepted);
    }
    assert_eq!(plain.observed_energy(), 2f64.powi(53));
    assert_eq!(compensated.observed_energy(), 2f64.powi(53) + 64.0);
}

fn refused<T>(made: Result<T, ParameterError>) -> (&'static str, f64) {
    let error = made.err().expect("refused");
    (error.parameter, error.value)
}

/// What is refused is named, with the number that cannot be.
#[test]
fn what_cannot_be_right_is_named() {
    let limit = DampingLimit::at(1.0).expect("a limit");
    let decaying = |decay| refused(LeastNorm::new(PortEnergy, limit, decay));
    assert_eq!((decaying(0.0), decaying(1.5)), (("barrier decay", 0.0), ("barrier decay", 1.5)));
    let store = TankLimits { start: 4.0, floor: 1.0, ceiling: 6.0, power: 2.0 };
    let made = |store| (refused(Tank::new(PortEnergy, store)), refused(EnergyTank::new(store)));
    for (store, told) in [
        (TankLimits { floor: -1.0, ..store }, ("tank floor", -1.0)),
        (TankLimits { start: 0.5, ..store }, ("tank start", 0.5)),
        (TankLimits { ceiling: 1.0, ..store }, ("tank start", 4.0)),
        (TankLimits { power: -2.0, ..store }, ("tank power", -2.0)),
    ] {
        assert_eq!(made(store), (told, told));
    }
    let mut tank = Tank::new(PortEnergy, store).expect("a tank");
    assert_eq!(refused(tank.set_room(-1.0)), ("tank ceiling above its floor", -1.0));
    assert_eq!(refused(tank.set_power(-1.0)), ("tank power", -1.0));
    assert_eq!((tank.room(), tank.power()), (5.0, 2.0));
    let mut tank = EnergyTank::new(store).expect("a tank");
    tank.pass(1.0, 1.0, 0.0, 0.0);
    let changed = refused(tank.set_limits(TankLimits { ceiling: 4.5, start: 0.0, ..store }));
    assert_eq!(changed, ("energy in the tank", 5.0));
    assert_eq!((tank.limits(), tank.energy()), (store, 5.0));
    let changed = TankLimits { floor: 2.0, ceiling: 5.5, power: 0.5, start: 0.0 };
    tank.set_limits(changed).expect("limits");
    assert_eq!((tank.limits(), tank.energy()), (TankLimits { start: 5.0, ..changed }, 5.0));
    assert_eq!(tank.pass(1.0, 3.0, 1.0, 4.0), 0.125);
    assert_eq!(tank.energy(), 5.5);
}
