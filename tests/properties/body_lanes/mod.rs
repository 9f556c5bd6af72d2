//! Bodies with friction and jitter on lanes against the runs of each by itself, bit for bit, whatever the neighbours do.

mod bodies;
mod lane;

use proptest::array::uniform8;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseError;

use lyapunov::lanes::{AutoF32x4, AutoF64x8, WideF64x4};
use lyapunov::{PortSample, Scalar, bodies::Transition};

use crate::support::{Bits, Real, hold, same};
use bodies::Made;
use lane::{Lane, Noise, Push};

/// Sets of parameters that a test tries: many where the build is made for speed.
const SETS: u32 = if cfg!(debug_assertions) { 40 } else { 10_000 };

const TICKS: usize = 200;

fn numbers<T: Scalar>(sample: &PortSample<T>, lane: usize) -> [f64; 6] {
    let PortSample { period, position, velocity, displacement, applied, work } = *sample;
    [period, position, velocity, displacement, applied, work].map(|number| number.lane(lane))
}

type Of<T> = fn(&[Lane]) -> Made<T>;

/// Runs the lanes of one body beside a body for each; counts the ticks in which one was cut.
fn agree<L: Scalar, T: Real>(lanes: &[Lane], of: (Of<L>, Of<T>)) -> Result<u32, TestCaseError> {
    let mut all = (of.0)(lanes).expect("a body of lanes that are all accepted");
    let one = |lane| (of.1)(std::slice::from_ref(lane)).expect("a body");
    let mut alone: Vec<_> = lanes.iter().map(one).collect();
    let mut last: Vec<_> = alone.iter().map(|body| numbers(&body.start(), 0)).collect();
    let mut cut = 0;
    for tick in 0..TICKS {
        let effort = |lane: usize| T::of(lanes[lane].push.at(tick, &last[lane]));
        let efforts: Vec<T> = (0..L::LANES).map(effort).collect();
        let sample = all.advance(L::from_lanes(|lane| efforts[lane].f64()));
        for (lane, body) in alone.iter_mut().enumerate() {
            let single = numbers(&body.advance(efforts[lane]), 0);
            let found = numbers(&sample, lane);
            let agrees = found.iter().zip(&single).all(|(&a, &b)| same(a, b));
            prop_assert!(agrees, "tick {tick}, lane {lane}: {found:?} for {single:?}");
            let ((heat, events), (burnt, exact)) = (all.told(lane), body.told(0));
            prop_assert!(same(heat, burnt), "tick {tick}, lane {lane}: {heat:e} J for {burnt:e}");
            prop_assert!(events == exact, "tick {tick}, lane {lane}: {events:?} for {exact:?}");
            cut += u32::from(exact.iter().any(|&(_, what)| what == Transition::Cut));
            last[lane] = single;
        }
    }
    Ok(cut)
}

/// Lanes of all kinds side by side. A lane of which no body can be made is refused, and gives way to one of which it can.
fn lanes_are_alone<L: Scalar, T: Real>(sets: u32, of: (Of<L>, Of<T>)) {
    let refused = |lane: &Lane| (of.1)(std::slice::from_ref(lane)).is_err();
    hold(sets, (uniform8(any::<Bits>()), any::<Bits>()), |(bits, set)| {
        let mut lanes = bits.map(|bits| Lane::of(bits, set));
        let lanes = &mut lanes[..L::LANES];
        prop_assert!((of.0)(lanes).is_err() == lanes.iter().any(refused));
        for (lane, bits) in lanes.iter_mut().zip(bits) {
            if refused(lane) {
                *lane = Lane::ordinary(bits);
            }
        }
        agree(lanes, of).map(drop)
    });
}

macro_rules! lanes_equal_single_runs {
    ($($name:ident over $sets:expr),+ $(,)?) => {$(
        #[test]
        fn $name() {
            let sets = $sets;
            lanes_are_alone::<AutoF64x8, f64>(sets, (bodies::$name, bodies::$name));
            lanes_are_alone::<WideF64x4, f64>(sets.div_ceil(20), (bodies::$name, bodies::$name));
            lanes_are_alone::<AutoF32x4, f32>(sets.div_ceil(20), (bodies::$name, bodies::$name));
        }
    )+};
}

// Two masses in very many pieces take the longest.
lanes_equal_single_runs! {
    jittered_block over SETS,
    jittered_pair over SETS,
    rubbed_block over SETS,
    rubbed_pair over SETS / 4,
    both_on_a_block over SETS / 4,
    both_on_a_pair over SETS / 4,
}

/// Blocks that are driven out of the range of the numbers from different places, so that periods are cut in some lanes
/// while others go on.
#[test]
fn runaways_are_alone() {
    let noise = Noise::Within(0.0);
    let push = Push { stiffness: 300.0, swing: 80.0, damping: 1.0, noise, seed: 0 };
    let lanes: [Lane; 8] = std::array::from_fn(|lane| Lane {
        body: [0.5, 0.0, 0.0],
        law: [0.3, 0.32, 0.002],
        period: 0.1,
        start: [0.001 * (lane + 1) as f64, 0.05 * (lane as f64 - 3.0)],
        push,
        ..Lane::ordinary(0)
    });
    let cut = agree::<AutoF64x8, f64>(&lanes, (bodies::rubbed_block, bodies::rubbed_block));
    assert!(cut.unwrap() > 100);
}
