//! Random numbers: the documented ones, against tests of distribution and of independence.

use nalgebra::Vector3;

use lyapunov::lanes::{AutoF32x4, AutoF64x8};
use lyapunov::{
    Mask, Scalar,
    effects::{Random, Source},
};

const MANY: usize = 1_000_000;

/// Standard deviations that a statistic may be off: among some hundred statistics, none exceeds this by chance.
const SIGMAS: f64 = 4.8;

fn normals(seed: u64, source: Source) -> Vec<f64> {
    let mut random = Random::<f64>::new(|_| seed, source);
    (0..MANY).map(|_| random.normal()).collect()
}

/// The distribution function of the normal distribution by its power series (Marsaglia, Evaluating the normal
/// distribution, 2004).
fn distribution(x: f64) -> f64 {
    let (mut term, mut sum, mut odd) = (x, 0.0, 1.0);
    while sum + term != sum {
        sum += term;
        odd += 2.0;
        term *= x * x / odd;
    }
    0.5 + sum * (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt()
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

/// The fault of numbers that should be independent and standard normal, if any.
fn fault(numbers: &[f64]) -> Option<String> {
    let count = numbers.len() as f64;
    let moment = |power| mean(numbers.iter().map(|x: &f64| x.powi(power)));
    // Each moment with its expectation and the variance of one term.
    for (power, expected, variance) in
        [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0), (6, 15.0, 10_170.0)]
    {
        let off = (moment(power) - expected) / (variance / count).sqrt();
        if off.abs() > SIGMAS {
            return Some(format!("moment {power} is off by {off} standard deviations"));
        }
    }
    for lag in 1..=16 {
        let pairs = numbers.iter().zip(&numbers[lag..]);
        let off = pairs.map(|(a, b)| a * b).sum::<f64>() / count.sqrt();
        if off.abs() > SIGMAS {
            return Some(format!("correlation at lag {lag}: {off} standard deviations"));
        }
    }
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    let apart = sorted.iter().enumerate().map(|(index, x)| {
        let below = distribution(*x) - index as f64 / count;
        below.max(1.0 / count - below)
    });
    let distance = apart.fold(0.0, f64::max) * count.sqrt();
    // Kolmogorov and Smirnov: exceeded once in ten thousand times.
    (distance > 2.23).then(|| format!("{distance} from the normal distribution"))
}

#[test]
fn normal_numbers_are_normal() {
    for (seed, source) in
        [(0, Source::Noise), (1, Source::Noise), (u64::MAX, Source::Jitter), (0, Source::Dropout)]
    {
        assert_eq!(fault(&normals(seed, source)), None, "seed {seed} of {source:?}");
    }
}

/// The test above detects numbers that are nearly right.
#[test]
fn wrong_numbers_are_detected() {
    let right = normals(2, Source::Noise);
    let of = |change: fn((usize, f64)) -> f64| -> Vec<f64> {
        right.iter().copied().enumerate().map(change).collect()
    };
    let sums = right.chunks(2).map(|pair| pair.iter().sum::<f64>() / 2f64.sqrt());
    let overlapping = right.windows(2).map(|pair| pair[0] * 0.99995 + pair[1] * 0.01);
    // Six uniform numbers less three: normal to the eye.
    let six = right
        .chunks_exact(6)
        .map(|some| (some.iter().map(|x| distribution(*x)).sum::<f64>() - 3.0) * 2f64.sqrt());
    for (what, wrong) in [
        ("too wide", of(|(_, x)| 1.005 * x)),
        ("moved", of(|(_, x)| x + 0.006)),
        ("cut off", of(|(_, x)| x.clamp(-3.3, 3.3))),
        ("coarse", of(|(_, x)| (100.0 * x).floor() / 100.0)),
        ("one sign less often", of(|(n, x)| if n % 200 == 0 { x.abs() } else { x })),
        ("repeated", right.iter().flat_map(|x| [*x, *x]).take(MANY).collect()),
        ("a moving sum", overlapping.collect()),
        ("six uniform ones", six.collect()),
    ] {
        assert!(fault(&wrong).is_some(), "{what} passes");
    }
    assert_eq!(fault(&sums.collect::<Vec<_>>()), None, "half as many right ones");
}

/// Streams of neighbouring seeds, of sources and of axes are independent.
#[test]
fn streams_are_independent() {
    let mut vectors = Random::<f64>::new(|_| 5, Source::Noise);
    let vectors: Vec<Vector3<f64>> = (0..MANY).map(|_| vectors.normal()).collect();
    let axis = |axis: usize| vectors.iter().map(|vector| vector[axis]).collect::<Vec<f64>>();
    let streams = [
        axis(0),
        axis(1),
        axis(2),
        normals(6, Source::Noise),
        normals(5, Source::Jitter),
        normals(5, Source::Dropout),
        normals(5 | 1 << 32, Source::Noise),
    ];
    for (index, a) in streams.iter().enumerate() {
        for b in &streams[index + 1..] {
            for lag in 0..3 {
                let products = |power: i32| {
                    let pairs = a.iter().zip(&b[lag..]);
                    pairs.map(|(a, b)| a.powi(power) * b.powi(power)).sum::<f64>()
                };
                let count = (MANY - lag) as f64;
                assert!(products(1).abs() < SIGMAS * count.sqrt(), "{index} at lag {lag}");
                // The variance of the product of two squares is 8.
                let squares = (products(2) - count) / (8.0 * count).sqrt();
                assert!(squares.abs() < SIGMAS, "squares of {index} at lag {lag}");
            }
        }
    }
}

/// Numbers that another language computes from the page on noise, with its own logarithm and cosine.
#[test]
fn numbers_are_the_documented_ones() {
    let expected = [
        (7, Source::Noise, [-0.43866718170944535, -1.2337550330569467, -0.35797645598874833]),
        (7, Source::Jitter, [-1.8926926351067812, 1.6179129818781155, -0.009225609894786711]),
        (7, Source::Dropout, [0.6986583481913333, -2.440702602274989, 0.1208820547323893]),
        (
            0xfedc_ba98_7654_3210,
            Source::Noise,
            [-0.27618043774442214, -1.645222414912376, 1.0862519785454043],
        ),
    ];
    let second = [
        [0.23457944655316734, 2.2730956546357795, -0.3962870660285434],
        [2.055178012070387, 0.2477556823139341, 1.1003328921494628],
        [1.199332779467545, 1.3005581338208376, 1.0340116697575825],
        [-0.24657918340317075, -0.2149732060618723, -0.8816545756308507],
    ];
    for ((seed, source, first), second) in expected.into_iter().zip(second) {
        let mut random = Random::<f64>::new(|_| seed, source);
        for call in [first, second] {
            let found: Vector3<f64> = random.normal();
            let apart = (found - Vector3::from(call)).amax();
            assert!(apart < 4e-15, "{seed} of {source:?}: off by {apart:e}");
        }
    }
}

/// A lane draws the numbers of a scalar run with its seed, and `f32` those of `f64`, rounded.
#[test]
fn lanes_draw_like_scalars() {
    let seed = |lane: usize| 0xfedc_ba98_7654_3210 + 3 * lane as u64;
    let mut wide = Random::<AutoF64x8>::new(seed, Source::Noise);
    let mut narrow = Random::<AutoF32x4>::new(seed, Source::Noise);
    let mut alone: [_; 8] =
        std::array::from_fn(|lane| Random::<f64>::new(|_| seed(lane), Source::Noise));
    let mut single: [_; 4] =
        std::array::from_fn(|lane| Random::<f32>::new(|_| seed(lane), Source::Noise));
    for call in 0..2000 {
        if call % 3 == 0 {
            let (p, q) = (wide.chance(AutoF64x8::of(0.5)), narrow.chance(AutoF32x4::of(0.5)));
            for (lane, alone) in alone.iter_mut().enumerate() {
                let happens = alone.chance(0.5);
                assert_eq!(p.lane(lane), happens);
                if let Some(single) = single.get_mut(lane) {
                    assert_eq!((q.lane(lane), single.chance(0.5)), (happens, happens));
                }
            }
            continue;
        }
        let (wide, narrow): (AutoF64x8, AutoF32x4) = (wide.normal(), narrow.normal());
        for (lane, alone) in alone.iter_mut().enumerate() {
            let number: f64 = alone.normal();
            assert_eq!(wide.lane(lane).to_bits(), number.to_bits());
            if let Some(single) = single.get_mut(lane) {
                let rounded: f32 = single.normal();
                assert_eq!(narrow.lane(lane), f64::from(rounded));
                assert_eq!(rounded, number as f32);
            }
        }
    }
}

#[test]
fn events_have_the_requested_probability() {
    let mut random = Random::<f32>::new(|_| 11, Source::Dropout);
    for probability in [0.0, 1e-4, 0.1, 0.5, 0.9, 1.0f32] {
        let happened = (0..MANY).filter(|_| random.chance(probability)).count() as f64;
        let (count, p) = (MANY as f64, f64::from(probability));
        let off = happened - count * p;
        assert!(off.abs() <= SIGMAS * (count * p * (1.0 - p)).sqrt(), "{probability}: {happened}");
    }
}
