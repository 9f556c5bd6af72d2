//! Encode then filter against filter then encode: does the filter see counts?

use std::f64::consts::TAU;

use approx::abs_diff_eq;
use lyapunov::{HeldTick, OnePort, PortSample, effects::OnePortExt, environments::Spring};

use crate::support::Spy;

const PERIOD: f64 = 1e-3;
const SPEED: f64 = 0.01;
/// One count in ten ticks of this motion.
const RESOLUTION: f64 = 10.0 * SPEED * PERIOD;
/// `ω T = 1 / 4`, so a fifth of the change passes on each tick.
const CUTOFF: f64 = 0.25 / (TAU * PERIOD);

/// The samples of steady motion, a quarter of a count off the edges.
fn steady() -> impl Iterator<Item = PortSample<f64>> {
    let at = |n: usize| (n as f64 / 10.0 + 0.025) * RESOLUTION;
    (0..500).map(move |n| {
        HeldTick {
            period: PERIOD,
            position: at(n),
            velocity: SPEED,
            displacement: at(n) - at(n.max(1) - 1),
            applied: 0.0,
        }
        .sample()
    })
}

/// Moves `port` until the transient is gone.
fn settled(port: &mut impl OnePort<f64>) {
    for sample in steady() {
        port.respond(&sample);
    }
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), v| (least.min(v), most.max(v)))
}

#[test]
fn a_filter_of_counts_sees_steps() {
    let spring = Spring::new(100.0).expect("a spring");
    let (mut counts, mut motion) = (Spy::on(spring), Spy::on(spring));
    let filtered = (&mut counts).low_passed(CUTOFF).expect("a low pass");
    settled(&mut filtered.encoded(RESOLUTION).expect("an encoder"));
    let encoded = (&mut motion).encoded(RESOLUTION).expect("an encoder");
    settled(&mut encoded.low_passed(CUTOFF).expect("a low pass"));

    // Positions are counts in both.
    assert!(counts.asked.iter().zip(&motion.asked).all(|(a, b)| a.position == b.position));

    // A filter outside of the encoder sees the true motion, and its velocity has settled at 1 cm/s.
    let (least, most) = range(motion.asked[400..].iter().map(|sample| sample.velocity));
    assert!(
        abs_diff_eq!(least, SPEED, epsilon = 1e-12) && abs_diff_eq!(most, SPEED, epsilon = 1e-12)
    );

    // A filter inside sees a count every ten ticks: ten times the speed for one tick. With p = 4 / 5 left per tick the
    // velocity peaks at 10 v (1 − p) / (1 − p^10) and has fallen by p^9 before the next count.
    let (least, most) = range(counts.asked[400..].iter().map(|sample| sample.velocity));
    let peak = 10.0 * SPEED * 0.2 / (1.0 - 0.8f64.powi(10));
    assert!(abs_diff_eq!(most, peak, epsilon = 1e-12), "{most} for {peak}");
    assert!(abs_diff_eq!(least, peak * 0.8f64.powi(9), epsilon = 1e-12), "{least}");
    // In numbers: 1 cm/s reported as 0.3 to 2.2 cm/s.
    assert!((0.0030..0.0031).contains(&least) && (0.0224..0.0225).contains(&most));
}
