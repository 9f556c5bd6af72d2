//! Memory of a credit.

use std::collections::VecDeque;

use lyapunov::{
    DampingLimit, HeldTick, ParameterError, PortEnergy, PortSample, Stabilizer,
    accumulators::{Accumulator, Compensated, Plain, Wide},
    candidates::InContact,
    stabilizers::{
        Account, ForceBound, LeastNorm, Sharing, StabilizerExt, Tank, TankLimits, TwoLayer,
        WindowedCredit,
    },
};

use crate::support::{Dice, PERIOD, popc};

/// Energies that add up without rounding.
fn energies(seed: u64) -> Vec<f64> {
    let mut dice = Dice::of(seed);
    (0..500).map(|_| (dice.within(64.0)).round() / 1024.0).collect()
}

/// Credits in the order in which they came, the oldest spent first.
fn first_in_first_out(energies: &[f64], window: usize, slot: usize) -> Vec<f64> {
    let (mut credits, mut debt) = (VecDeque::<(usize, f64)>::new(), 0.0);
    let mut sums = Vec::new();
    for (tick, energy) in energies.iter().enumerate() {
        let slot = tick / slot;
        while credits.front().is_some_and(|(of, _)| of + window <= slot) {
            credits.pop_front();
        }
        let mut left = *energy;
        if left > 0.0 {
            let paid = left.min(debt);
            debt -= paid;
            credits.push_back((slot, left - paid));
        }
        while left < 0.0 {
            let Some((_, credit)) = credits.front_mut() else {
                debt -= left;
                break;
            };
            let spent = credit.min(-left);
            *credit -= spent;
            left += spent;
            if *credit == 0.0 {
                credits.pop_front();
            }
        }
        sums.push(credits.iter().map(|(_, credit)| credit).sum::<f64>() - debt);
    }
    sums
}

fn windowed<A: Accumulator<f64>>(slot: u32) {
    for seed in 0..50 {
        let energies = energies(seed);
        let truth = first_in_first_out(&energies, 6, slot as usize);
        let mut sum = WindowedCredit::<f64, A, 6>::of_ticks(slot).expect("a window");
        for (energy, truth) in energies.iter().zip(truth) {
            sum.add(*energy);
            assert_eq!(sum.value(), truth);
        }
    }
}

#[test]
fn a_window_spends_the_oldest_first() {
    for slot in [1, 3] {
        windowed::<Plain<f64>>(slot);
        windowed::<Compensated<f64>>(slot);
    }
}

#[test]
fn a_window_in_single_precision() {
    let energies = energies(9);
    let mut sum = WindowedCredit::<f32, Wide<f32>, 6>::zero();
    for (energy, truth) in energies.iter().zip(first_in_first_out(&energies, 6, 1)) {
        sum.add(*energy as f32);
        assert_eq!(f64::from(sum.value()), truth);
    }
}

#[test]
fn sums_are_lowered_to_the_bit() {
    fn check<A: Accumulator<f64>>() {
        let mut sum = A::zero();
        sum.add(1e10);
        sum.lower(1e-3);
        assert_eq!(sum.value(), 1e-3);
        sum.add(-1.0);
        sum.lower(1e-3);
        assert_eq!(sum.value(), 1e-3 - 1.0);
    }
    check::<Plain<f64>>();
    check::<Compensated<f64>>();
    check::<WindowedCredit<f64, Plain<f64>, 4>>();
}

fn sample(position: f64, work: f64) -> PortSample<f64> {
    PortSample {
        work,
        ..HeldTick { period: PERIOD, position, velocity: 0.1, displacement: 1e-4, applied: 0.0 }
            .sample()
    }
}

#[test]
fn a_bounded_credit_follows_the_recursion() {
    let mut bounded = popc().bounded(0.02).expect("a bound");
    let mut sum = 0f64;
    for energy in energies(4) {
        sum = sum.min(0.02) + energy;
        assert_eq!(bounded.stabilize(&sample(0.0, energy), 0.0).observed_energy, sum);
    }
}

#[test]
fn a_contact_starts_without_credit_and_keeps_its_debt() {
    let mut reset = popc().reset_at(InContact { position: 0.0 });
    let (mut sum, mut inside) = (0f64, false);
    let mut dice = Dice::of(3);
    for energy in energies(6) {
        let position = dice.within(1.0);
        if position > 0.0 && !inside {
            sum = sum.min(0.0);
        }
        inside = position > 0.0;
        sum += energy;
        assert_eq!(reset.stabilize(&sample(position, energy), 0.0).observed_energy, sum);
    }
}

#[test]
fn what_cannot_be_right_is_refused() {
    let why = |error: lyapunov::ParameterError| error.to_string();
    assert_eq!(
        popc::<f64>().budgeted(-1.0).map(|_| ()).map_err(why).unwrap_err(),
        "budget is -1.0; it must be at least 0 and finite"
    );
    assert!(popc::<f64>().bounded(f64::NAN).is_err());
    assert!(popc::<f64>().above_velocity(1e200_f64).is_err());
    assert!(popc::<f32>().above_velocity(1e-23_f32).is_err());
    assert!(popc::<f64>().spread_over::<f64>(0).is_err());
    assert!(popc::<f64>().rising_over::<f64>(0).is_err());
    assert!(popc::<f32>().rising_over::<f32>((1 << 24) + 1).is_err());
    assert!(popc::<f64>().rate_limited::<f64>(-1.0).is_err());
    assert!(WindowedCredit::<f64, Plain<f64>, 4>::of_ticks(0).is_err());
}

/// A budget is credit in the account, from the start and in every kind of sum.
#[test]
fn a_budget_is_in_the_account() {
    let popc = popc::<f64>();
    assert_eq!(popc.budgeted(1e-3).expect("a budget").observed_energy(), 1e-3);
    let sampled = popc.sampled().budgeted(2e-3).expect("a budget");
    assert_eq!(sampled.budgeted(1e-3).expect("a budget").observed_energy(), 3e-3);
    let compensated = popc.summed_in::<Compensated<f64>>().budgeted(1e-3).expect("a budget");
    assert_eq!(compensated.observed_energy(), 1e-3);
    let wide = popc.summed_in::<Wide<f64>>().budgeted(1e-3).expect("a budget");
    assert_eq!(wide.observed_energy(), 1e-3);
}

#[test]
fn a_budget_beyond_the_sum_is_refused() {
    let most = f32::MAX;
    let name = |refused: Option<ParameterError>| refused.map(|it| (it.parameter, it.value));
    let expected = Some(("budget", f64::from(most)));
    let bound = ForceBound::new(0.1_f32).and_then(|it| it.budgeted(most)).expect("a budget");
    assert_eq!(name(bound.budgeted(most).err()), expected);
    let limit = DampingLimit::at(1.0_f32).expect("a limit");
    let filter = LeastNorm::new(PortEnergy, limit, 0.5).and_then(|it| it.budgeted(most));
    assert_eq!(name(filter.expect("a budget").budgeted(most).err()), expected);
    let popc = popc::<f32>().budgeted(most).expect("a budget");
    assert_eq!(name(popc.budgeted(most).err()), expected);
}

/// A budget goes along into another sum and to another kind of work, whichever is asked for first.
#[test]
fn a_budget_goes_along() {
    let budgeted = popc::<f64>().budgeted(1e-3).expect("a budget");
    assert_eq!(budgeted.sampled().observed_energy(), 1e-3);
    assert_eq!(budgeted.summed_in::<Compensated<f64>>().observed_energy(), 1e-3);
    assert_eq!(budgeted.sampled().summed_in::<Wide<f64>>().observed_energy(), 1e-3);
    let bound = ForceBound::new(1.0).and_then(|it| it.budgeted(2e-3)).expect("a budget");
    assert_eq!(bound.summed_in::<Wide<f64>>().observed_energy(), 2e-3);
    let store = TankLimits { start: 3e-3, floor: 1e-3, ceiling: 5e-3, power: 1.0 };
    let tank = Tank::new(PortEnergy, store).expect("a tank").summed_in::<Wide<f64>>();
    assert_eq!((tank.observed_energy(), tank.room()), (2e-3, 4e-3));
    let end = TwoLayer::slave(Sharing { start: 2e-3, share: 0.1 }).expect("an end");
    assert_eq!(end.summed_in::<Compensated<f64>>().observed_energy(), 2e-3);
    let limit = DampingLimit::at(1.0).expect("a limit");
    let filter = LeastNorm::new(PortEnergy, limit, 0.5).and_then(|it| it.budgeted(3e-3));
    let filter = filter.expect("a budget");
    assert_eq!(filter.summed_in::<Compensated<f64>>().observed_energy(), 3e-3);
}
