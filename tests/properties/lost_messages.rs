//! Lost messages of a channel, beside a list that keeps every message with its arrival.

use lyapunov::channels::{Channel, LossyChannel, VaryingDelay};
use lyapunov::effects::{Random, Source};

/// A lost message never arrives, and holds no earlier one up.
#[test]
fn a_lost_message_never_arrives() {
    let (least, most, loss, seed) = (3_u32, 40_u32, 0.8, 5);
    let delay = VaryingDelay::<_, 64>::new(least, most, seed, 0_u64).expect("a delay");
    let mut channel = LossyChannel::new(delay, loss, seed).expect("a channel");
    let mut lag = Random::<f64>::new(|_| seed, Source::Lag);
    let mut losing = Random::<f64>::new(|_| seed, Source::Loss);
    let mut arrives = vec![u64::MAX; 5000];
    for now in 1..5000_u64 {
        let late = (lag.uniform() * f64::from(most - least + 1)) as u64;
        if losing.uniform() >= loss {
            arrives[now as usize] = now + u64::from(least) + late;
        }
        let newest = (1..=now).rev().find(|sent| arrives[*sent as usize] <= now);
        assert_eq!(channel.carry(now), newest.unwrap_or(0), "{now}");
    }
}

/// A tick takes no longer, however long ago the last message arrived.
#[test]
fn a_line_that_never_delivers_takes_no_longer_than_it_is_long() {
    let delay = VaryingDelay::<_, 64>::new(3, 40, 1, 0.0).expect("a delay");
    let mut channel = LossyChannel::new(delay, 1.0, 1).expect("a channel");
    assert!((0..3_000_000).all(|_| channel.carry(1.0) == 0.0));
}
