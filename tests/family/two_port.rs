//! Two loops over a channel: whatever the channel does to the messages, the two ports together give no more than they
//! took.

use approx::abs_diff_eq;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestCaseResult, TestRunner};

use lyapunov::{
    AdmittanceSample, Correction, DampingLimit, HeldFlow, HeldTick, Plant, PortSample, Stabilizer,
    accumulators::Compensated,
    bodies::{Body, Impedance},
    channels::{Channel, ConstantDelay, LossyChannel, VaryingDelay},
    stabilizers::{DriftCompensated, TwoPortSide},
};

use crate::support::{Dice, PERIOD, held_tick, limit};

/// A signal and the energy that its sender has absorbed.
type Message = (f64, f64);

const SILENCE: Message = (0.0, 0.0);

/// The slave's spring, and its damper, which answers a held velocity at once as a spring of `b / T` does in a tick.
fn mobility() -> DampingLimit<f64> {
    DampingLimit::of_stiffness(0.5, 500.0 + 5.0 / PERIOD, PERIOD).expect("a limit")
}

/// Each kind of channel that ships, alone and losing messages.
fn channels(seed: u64) -> Vec<Box<dyn Channel<Message>>> {
    let constant = |ticks| ConstantDelay::<Message, 64>::new(ticks, SILENCE).expect("a channel");
    let varying = |most| VaryingDelay::<Message, 64>::new(3, most, seed, SILENCE).expect("one");
    vec![
        Box::new(constant(0)),
        Box::new(constant(5)),
        Box::new(constant(60)),
        Box::new(varying(3)),
        Box::new(varying(40)),
        Box::new(LossyChannel::new(constant(10), 0.3, seed).expect("one")),
        Box::new(LossyChannel::new(varying(40), 0.9, seed).expect("one")),
        Box::new(LossyChannel::new(constant(1), 1.0, seed).expect("one")),
    ]
}

/// The account of both ports from outside, with what the corrections are about to burn and what they cannot.
struct Book {
    crossed: f64,
    size: f64,
}

impl Book {
    fn enter(&mut self, sample: &PortSample<f64>) {
        self.crossed += sample.work;
        self.size += sample.work.abs();
    }

    fn holds(&self, ends: [(&PortSample<f64>, &Correction<f64>); 2]) -> TestCaseResult {
        let served = |(sample, correction): (&PortSample<f64>, &Correction<f64>)| {
            correction.alpha * sample.velocity * sample.velocity * PERIOD + correction.shortfall
        };
        let kept = self.crossed + ends.map(served).iter().sum::<f64>();
        prop_assert!(kept >= -1e-11 * self.size, "{kept:e} of {:e} J", self.size);
        Ok(())
    }
}

fn try_seeds(cases: u32, property: impl Fn(u64) -> TestCaseResult) {
    let rng_seed = RngSeed::Fixed(0x5eed);
    let config = Config { cases, failure_persistence: None, rng_seed, ..Config::default() };
    let result = TestRunner::new(config).run(&any::<u64>(), property);
    result.unwrap_or_else(|failed| panic!("{failed}"));
}

/// Both ends are moved and pushed at random.
#[test]
fn under_every_channel_the_ledger_of_both_ports_holds() {
    try_seeds(100, |seed| {
        for (there, back) in channels(seed).iter_mut().zip(&mut channels(!seed)) {
            let mut dice = Dice::of(seed);
            let mut master = TwoPortSide::new(limit());
            let mut slave = DriftCompensated::new(TwoPortSide::new(mobility()), 0.05).expect("one");
            let (mut sample, mut load) = (
                PortSample::starting(PERIOD, 0.0, 0.0),
                PortSample::from(AdmittanceSample::starting(PERIOD, 0.0)),
            );
            let mut book = Book { crossed: 0.0, size: 0.0 };
            let mut arrived = SILENCE;
            for _ in 0..400 {
                master.receive(arrived.1);
                let felt = master.stabilize(&sample, dice.within(10.0));
                let (_, energy) = there.carry((sample.velocity, master.absorbed()));
                slave.receive(energy);
                let moves = slave.stabilize(&load, dice.within(0.2));
                arrived = back.carry((load.velocity, slave.absorbed()));
                book.holds([(&sample, &felt), (&load, &moves)])?;
                let moved = dice.within(2e-4);
                sample = held_tick(0.0, moved, felt.effort);
                let force = dice.within(10.0);
                load = HeldFlow {
                    period: PERIOD,
                    momentum: 0.0,
                    effort: force,
                    impulse: force * PERIOD,
                    flow: moves.effort,
                }
                .sample()
                .into();
                book.enter(&sample);
                book.enter(&load);
            }
        }
        Ok(())
    });
}

/// The fastest that the master moves in the last of six seconds, m/s.
///
/// A hand on a master; a slave that a spring and a damper pull to the position that the master's velocities add up
/// to; a wall in front of the slave. The force of that spring goes back to the master.
fn loop_of(
    stabilized: bool,
    speed: f64,
    there: &mut dyn Channel<Message>,
    back: &mut dyn Channel<Message>,
) -> Result<f64, TestCaseError> {
    let hand = Impedance { mass: 0.3, damping: 0.5, stiffness: 100.0 };
    let mut master = Body::<f64>::new(hand, PERIOD).expect("a body").resting_at(0.01);
    let own = Impedance { mass: 0.3, damping: 0.5, stiffness: 0.0 };
    let mut slave = Body::<f64>::new(own, PERIOD).expect("a body");
    let (stiffness, damping, wall) = (500.0, 5.0, 2000.0);
    let (mut near, far) = (TwoPortSide::new(limit()), TwoPortSide::new(mobility()));
    let mut far = DriftCompensated::new(far, speed).expect("a station");
    let (mut sample, mut follows): (PortSample<f64>, PortSample<f64>) =
        (master.start(), slave.start());
    let mut load = PortSample::from(AdmittanceSample::starting(PERIOD, 0.0));
    let mut book = Book { crossed: 0.0, size: 0.0 };
    let (mut command, mut arrived, mut swing) = (0.0, SILENCE, 0f64);
    for tick in 0..6000 {
        near.receive(arrived.1);
        let felt = near.stabilize(&sample, arrived.0);
        let received = arrived.0;
        let (velocity, energy) = there.carry((sample.velocity, near.absorbed()));
        far.receive(energy);
        let moves = far.stabilize(&load, velocity);
        book.holds([(&sample, &felt), (&load, &moves)])
            .or_else(|e| if stabilized { Err(e) } else { Ok(()) })?;
        let flow = if stabilized { moves.effort } else { velocity };
        let pull = stiffness * (command - follows.position) + damping * (flow - follows.velocity);
        arrived = back.carry((pull, far.absorbed()));
        sample = master.advance(if stabilized { felt.effort } else { received });
        command += flow * PERIOD;
        follows = slave.advance(-pull + wall * (follows.position - 0.005).max(0.0));
        load = HeldFlow {
            period: PERIOD,
            momentum: 0.0,
            effort: -pull,
            impulse: -pull * PERIOD,
            flow,
        }
        .sample()
        .into();
        book.enter(&sample);
        book.enter(&load);
        if !follows.position.is_finite() || follows.position.abs() > 10.0 {
            return Ok(f64::INFINITY);
        }
        if tick >= 5000 {
            swing = swing.max(sample.velocity.abs());
        }
    }
    Ok(swing)
}

/// Over 60 ms and more the loop alone swings up; with a station at each end it calms down.
#[test]
fn a_master_and_a_slave_over_a_delay() {
    let channel = || ConstantDelay::<Message, 64>::new(60, SILENCE).expect("a channel");
    let free = loop_of(false, 0.0, &mut channel(), &mut channel()).expect("a run");
    assert!(free > 0.5, "{} m/s without stations", free);
    let joined = loop_of(true, 0.0, &mut channel(), &mut channel()).expect("the ledger");
    assert!(joined < 0.3, "{} m/s", joined);
}

#[test]
fn over_every_channel_it_stays_bounded() {
    for (there, back) in channels(5).iter_mut().zip(&mut channels(6)) {
        let joined = loop_of(true, 0.02, &mut **there, &mut **back).expect("the ledger");
        assert!(joined < 0.3, "{} m/s", joined);
    }
}

/// Against a force that answers at once, what is given away is counted with the answer: `(v + u)(f + z u)`.
#[test]
fn compensation_counts_with_what_answers_it() {
    let (speed, impedance) = (0.02, 5.0);
    let station = || DriftCompensated::new(TwoPortSide::new(mobility()), speed).expect("one");
    assert!(station().meeting(-1.0).is_err() && station().meeting(f64::NAN).is_err());
    let mut one = station().meeting(impedance).expect("one");
    let (asked, mut spent) = (0.1, 0.0_f64);
    let mut load = PortSample::from(AdmittanceSample::starting(PERIOD, 0.0));
    for tick in 0..4000 {
        // A push that is not paid for makes the drift; then credit comes in, less than the push takes.
        let push: f64 = if tick < 20 { -5.0 } else { -0.1 };
        one.receive(if tick < 100 { 0.0 } else { 1.05e-5 * f64::from(tick) });
        let correction: Correction<f64> = one.stabilize(&load, asked);
        let served = asked + correction.alpha * load.velocity;
        let back = correction.effort - served;
        // What the answer makes of it, beyond what would have been given without.
        let more = served * load.velocity - correction.effort * (load.velocity - impedance * back);
        assert!(
            more * PERIOD <= correction.observed_energy.max(0.0) + 1e-15,
            "{tick}: {more} {correction:?}"
        );
        spent = spent.max(more);
        load = HeldFlow {
            period: PERIOD,
            momentum: 0.0,
            effort: push,
            impulse: push * PERIOD,
            flow: correction.effort,
        }
        .sample()
        .into();
    }
    assert!(spent > 0.0 && one.drift() > -1e-3, "credit is spent: {spent} W, {} m", one.drift());
}

/// What the corrections cost in position is made up for, from credit only.
#[test]
fn drift_is_taken_back() {
    let settled = |speed: f64| {
        let mut station = DriftCompensated::new(TwoPortSide::new(mobility()), speed).expect("one");
        let mut load = PortSample::from(AdmittanceSample::starting(PERIOD, 0.0));
        let mut least = 0f64;
        for tick in 0..2000 {
            // A push that the other side has not yet paid for, then a long credit and no push.
            let force: f64 = if tick < 20 { -5.0 } else { -0.1 };
            station.receive(if tick < 100 { 0.0 } else { 1.0 });
            let flow = station.stabilize(&load, 0.1).effort;
            load = HeldFlow {
                period: PERIOD,
                momentum: 0.0,
                effort: force,
                impulse: force * PERIOD,
                flow,
            }
            .sample()
            .into();
            least = least.min(station.drift());
        }
        (least, station.drift())
    };
    let (least, end) = settled(0.0);
    assert!(least < -1e-3 && abs_diff_eq!(end, least, epsilon = 1e-12), "{least} m, then {end} m");
    let (least, end) = settled(0.02);
    assert!(least < -1e-3 && end.abs() < 1e-6, "{least} m, then {end} m");
}

/// A message that is older than the last one, or spoilt, says nothing: the account is as if it had not come.
#[test]
fn an_older_message_says_nothing() {
    let mut side = TwoPortSide::new(limit::<f64>());
    let rest = PortSample::starting(PERIOD, 0.0, 0.0);
    let mut after = |energy: f64| {
        side.receive(energy);
        side.stabilize(&rest, 0.0).observed_energy
    };
    assert_eq!(after(5e-4), 5e-4);
    for stale in [3e-4, 0.0, -1.0, 5e-4, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(after(stale), 5e-4, "after {stale}");
    }
    assert_eq!(after(6e-4), 6e-4);
}

/// In `f32` beside 256 J a packet of 2e-5 J is rounded to a step of 3e-5 J or to none. What is told and what a side keeps sum to
/// what crossed.
#[test]
fn what_a_sum_rounds_off_is_told_or_kept_and_never_both() {
    for work in [1.0e-5_f32, 1.7e-5, 3.2e-5] {
        let limit = DampingLimit::at(0.0_f32).expect("one");
        let fresh = TwoPortSide::new(limit).summed_in::<Compensated<f32>>();
        let sample = |applied: f32| {
            HeldTick { period: 1e-3, position: 0.0, velocity: 0.1, displacement: 1e-4, applied }
                .sample()
        };
        let mut side = fresh;
        side.stabilize(&PortSample::starting(1e-3, 0.0, 0.1), 2.56e6);
        let before = side.stabilize(&sample(2.56e6), work / 1e-4);
        assert!(side.absorbed() > 255.0 && before.observed_energy.abs() < 1e-4);
        let (told, kept) = (side.absorbed(), before.observed_energy);
        let mut crossed = 0.0;
        for _ in 0..100_000 {
            let tick = sample(work / 1e-4);
            crossed += f64::from(tick.work);
            let correction = side.stabilize(&tick, work / 1e-4);
            let [more, own] =
                [side.absorbed() - told, correction.observed_energy - kept].map(f64::from);
            assert!(
                (more + own - crossed).abs() < 1e-4 * crossed + 1e-9,
                "{work}: {more} + {own} of {crossed}"
            );
        }
    }
}
