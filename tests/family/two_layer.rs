//! The two-layer architecture against its worked row, and what crosses any channel.

use lyapunov::lanes::AutoF64x4;
use lyapunov::{
    Correction, HeldTick, PortSample, Scalar, Stabilizer,
    channels::{Channel, ConstantDelay, LossyChannel, VaryingDelay},
    stabilizers::{Sharing, TwoLayer},
};

use crate::support::{Dice, PERIOD, held_tick};
use crate::worked::near;

/// Of the row: displacements, 0.1 mm, what is received, mJ, and the wished torques with their sign.
const MOVED: [f64; 7] = [0.0, 1.0, 1.0, -1.0, -2.0, -2.0, 0.0];
const RECEIVED: [f64; 7] = [0.0, 0.0, 0.05, 0.05, 0.05, 0.0, 0.0];
const WISHED: [f64; 7] = [-1.0, -2.0, -2.0, -2.0, -4.0, -4.0, -4.0];

fn row<T: Scalar>(tolerance: f64) {
    let of = T::of;
    let sharing = Sharing { start: of(0.5e-3), share: of(0.1) };
    let mut master = TwoLayer::master(sharing, of(1e-3), of(2000.0)).expect("an end");
    let (mut torques, mut packets, mut tank) = (vec![], vec![], vec![]);
    let (mut force, mut received, mut sent) = (T::of(0.0), 0.0, 0.0);
    for tick in 0..7 {
        received += 1e-3 * RECEIVED[tick];
        master.receive(of(received));
        let moved = of(1e-4 * MOVED[tick]);
        let sample = held_tick(of(0.0), moved, force);
        let correction: Correction<T> = master.stabilize(&sample, of(-WISHED[tick]));
        force = correction.effort;
        let told = master.sent().lane(0);
        torques.push(-force.lane(0));
        packets.push(1e3 * (told - sent));
        tank.push(1e3 * correction.observed_energy.lane(0));
        sent = told;
    }
    let expected = [0.05, 0.055, 0.07551, 0.0523182, 0.0142029, 0.00697739, 0.00627965];
    for (found, expected) in packets.iter().zip(expected) {
        assert!((found - expected).abs() < tolerance, "{packets:?}");
    }
    let expected = [0.45, 0.495, 0.67959, 0.470864, 0.127826, 0.0627965, 0.0565169];
    near(&tank, &expected);
    let expected = [-1.0, -2.101, -2.06408, -1.89417, -0.290261, 0.0608988, -4.0];
    near(&torques, &expected);
}

#[test]
fn the_worked_row() {
    row::<f64>(1e-7);
    row::<f32>(1e-5);
    row::<AutoF64x4>(1e-7);
}

fn channels(seed: u64) -> Vec<Box<dyn Channel<f64>>> {
    let constant = |ticks| ConstantDelay::<f64, 64>::new(ticks, 0.0).expect("a channel");
    let varying = |most| VaryingDelay::<f64, 64>::new(3, most, seed, 0.0).expect("a channel");
    vec![
        Box::new(constant(0)),
        Box::new(constant(20)),
        Box::new(varying(40)),
        Box::new(LossyChannel::new(constant(5), 0.3, seed).expect("a channel")),
        Box::new(LossyChannel::new(varying(40), 0.9, seed).expect("a channel")),
    ]
}

/// Both tanks and what is under way hold the start and what the hands put in, whatever the channel does to the messages:
/// so the tanks never hold more.
#[test]
fn the_tanks_and_what_is_under_way_hold_what_the_hands_put_in() {
    for seed in 0..20 {
        for (there, back) in channels(seed).iter_mut().zip(&mut channels(!seed)) {
            let mut dice = Dice::of(seed);
            let sharing = Sharing { start: 1e-3, share: 0.1 };
            let mut ends = [
                TwoLayer::master(sharing, 5e-3, 200.0).expect("an end"),
                TwoLayer::slave(sharing).expect("an end"),
            ];
            let mut drives = [PortSample::starting(PERIOD, 0.0, 0.0); 2];
            let (mut put_in, mut size, mut arrived) = (2e-3, 2e-3, [0.0_f64; 2]);
            for _ in 0..500 {
                let mut held = 0.0;
                for (end, sample) in ends.iter_mut().zip(&mut drives) {
                    let correction = end.stabilize(sample, dice.within(5.0));
                    held += correction.observed_energy;
                    let moved = dice.within(1e-4);
                    *sample = held_tick(0.0, moved, correction.effort);
                }
                let under_way = [ends[0].sent() - arrived[1], ends[1].sent() - arrived[0]];
                assert!(under_way.iter().all(|energy| *energy >= 0.0), "{under_way:?}");
                let missing = put_in - held - under_way[0] - under_way[1];
                assert!(missing.abs() <= 1e-12 * size, "{missing:e} J of {put_in:e} J");
                put_in += drives.iter().map(|sample| sample.work).sum::<f64>();
                size += drives.iter().map(|sample| sample.work.abs()).sum::<f64>();
                let told = [back.carry(ends[1].sent()), there.carry(ends[0].sent())];
                for ((end, told), arrived) in ends.iter_mut().zip(told).zip(&mut arrived) {
                    end.receive(told);
                    *arrived = arrived.max(told);
                }
            }
        }
    }
}

/// At rest the two ends pass the same energy to and fro for ever: not a part in a million comes or goes by rounding, also
/// when the sums are ten thousand times as large as what the tanks hold.
#[test]
fn sharing_at_rest_makes_no_energy() {
    let sharing = Sharing { start: 2.5e-3_f32, share: 0.1 };
    let end = || TwoLayer::slave(sharing).expect("an end");
    let mut ends = [end(), end()];
    let rest = PortSample::starting(PERIOD as f32, 0.0, 0.0);
    for _ in 0..1_000_000 {
        let told = [ends[1].sent(), ends[0].sent()];
        let mut held = 0.0;
        for (end, told) in ends.iter_mut().zip(told) {
            end.receive(told);
            let correction: Correction<f32> = end.stabilize(&rest, 0.0);
            held += f64::from(correction.observed_energy);
        }
        let sent: f64 = ends.iter().map(|end| f64::from(end.sent())).sum();
        let arrived: f64 = told.map(f64::from).iter().sum();
        let all = held + sent - arrived;
        assert!((all - 5e-3).abs() < 5e-9, "{all:e} J after {sent} J were sent");
    }
    assert!(ends[0].sent() > 10.0);
}

/// Where the next displacement is as guessed no tank falls below 0, and the slave gives only what has come.
#[test]
fn nothing_is_given_that_has_not_come() {
    let sharing = Sharing { start: 0.0, share: 0.1 };
    let mut slave = TwoLayer::slave(sharing).expect("an end");
    let mut sample = PortSample::starting(PERIOD, 0.0, -0.1);
    let mut given = 0.0;
    for tick in 0..500 {
        slave.receive(1e-6 * f64::from(tick));
        let correction: Correction<f64> = slave.stabilize(&sample, 10.0);
        assert!(correction.observed_energy >= -1e-15 && (tick > 0 || correction.effort == 0.0));
        sample = HeldTick {
            period: PERIOD,
            position: 0.0,
            velocity: -0.1,
            displacement: -0.1 * PERIOD,
            applied: correction.effort,
        }
        .sample();
        given -= sample.work;
        assert!(given <= 1e-6 * f64::from(tick) + 1e-15, "{given:e} J on {tick}");
    }
    assert!(given > 3e-4);
}

#[test]
fn what_cannot_be_right_is_refused() {
    let sharing = Sharing { start: 1e-3, share: 0.1 };
    assert!(TwoLayer::slave(Sharing { start: -1.0, ..sharing }).is_err());
    assert!(TwoLayer::slave(Sharing { share: 1.5, ..sharing }).is_err());
    assert!(TwoLayer::master(sharing, f64::NAN, 1.0).is_err());
    assert!(TwoLayer::master(sharing, 1.0, -1.0).is_err());
}
