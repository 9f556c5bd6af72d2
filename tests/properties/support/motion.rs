//! Motion of a mass with a damper and a spring under a held effort, computed without the library.

use crate::support::Double;
use approx::assert_abs_diff_eq;

/// Nodes and weights of the Gauss quadrature of ten points on `[-1, 1]`, which are symmetric.
const GAUSS: [(f64, f64); 5] = [
    (0.148_874_338_981_631_22, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// Position and velocity of the mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) position: f64,
    pub(crate) velocity: f64,
}

/// `m ẍ + b ẋ + k (x − rest) = −f` with `f` held.
///
/// Over a time `t` everything follows from `h(t)`, the impulse response (`h(0) = 0`, `h'(0) = 1`), its slope and its
/// area. Their Taylor series are summed in double-double, which works for every damping: the textbook forms cancel near
/// critical damping and for short times.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    pub(crate) mass: f64,
    pub(crate) damping: f64,
    pub(crate) stiffness: f64,
    pub(crate) rest: f64,
}

/// The gains of position and velocity over a time, per unit of deflection, velocity and effort.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gain {
    pub(crate) position: [f64; 3],
    pub(crate) velocity: [f64; 3],
}

impl Gain {
    pub(crate) fn step(&self, motion: &Motion, state: State, effort: f64) -> State {
        let by = [state.position - motion.rest, state.velocity, effort];
        let gain = |row: [f64; 3]| row[0] * by[0] + row[1] * by[1] + row[2] * by[2];
        State {
            position: state.position + gain(self.position),
            velocity: state.velocity + gain(self.velocity),
        }
    }
}

impl Motion {
    /// The gains up to the nodes of a quadrature over `period`, with their weights.
    pub(crate) fn nodes(&self, period: f64) -> Vec<(Gain, f64)> {
        quadrature(period).into_iter().map(|(t, weight)| (self.over(t), weight)).collect()
    }

    /// The gain over a time `t`.
    pub(crate) fn over(&self, t: f64) -> Gain {
        let friction = Double::of(self.damping).over(Double::of(self.mass));
        let spring = Double::of(self.stiffness).over(Double::of(self.mass));
        let mobility = Double::of(1.0).over(Double::of(self.mass));
        let (h, slope, area) = answer(friction, spring, Double::of(t));
        Gain {
            position: [-(spring * area), h, -(mobility * area)].map(Double::value),
            velocity: [-(spring * h), slope - Double::of(1.0), -(mobility * h)].map(Double::value),
        }
    }
}

/// Nodes and weights of a quadrature over `period`: two panels of ten points.
pub(crate) fn quadrature(period: f64) -> Vec<(f64, f64)> {
    let panel = period / 2.0;
    [0.0, panel]
        .into_iter()
        .flat_map(|from| GAUSS.map(|(node, weight)| (from, node, weight)))
        .flat_map(|(from, node, weight)| {
            [1.0 - node, 1.0 + node].map(|at| (from + at * panel / 2.0, weight * panel / 2.0))
        })
        .collect()
}

/// `h`, its slope and its area at `t`. With `h'' = −b/m h' − k/m h` the coefficients of `h = Σ cⱼ tʲ / j!` follow from
/// one another.
fn answer(friction: Double, spring: Double, t: Double) -> (Double, Double, Double) {
    let size = friction.value() * t.value() + spring.value() * t.value() * t.value();
    assert!(size < 24.0, "too long a time for one series: {size}");
    let (mut h, mut slope, mut area) = (Double::default(), Double::default(), Double::default());
    // cⱼ tʲ⁻¹ / (j − 1)!, and the one before it times t / (j − 1).
    let (mut term, mut last) = (Double::of(1.0), Double::default());
    for order in 1..=150 {
        let j = Double::of(f64::from(order));
        let next_power = t.over(j);
        slope = slope + term;
        h = h + term * next_power;
        area = area + term * next_power * t.over(j + Double::of(1.0));
        let next = -(friction * term * next_power) - spring * last * next_power;
        last = term * next_power;
        term = next;
    }
    (h, slope, area)
}

/// The same motion by the classical Runge-Kutta method in `steps` steps, and the work `∫ f v dt` and the dissipated
/// energy `∫ b v² dt` on the way.
pub(crate) fn runge_kutta(
    motion: &Motion,
    start: State,
    effort: f64,
    t: f64,
    steps: u32,
) -> (State, f64, f64) {
    let Motion { mass, damping, stiffness, rest } = *motion;
    let slope = |[x, v, _, _]: [f64; 4]| {
        let force = -effort - damping * v - stiffness * (x - rest);
        [v, force / mass, effort * v, damping * v * v]
    };
    let dt = t / f64::from(steps);
    let ahead = |at: [f64; 4], slope: [f64; 4], dt: f64| {
        std::array::from_fn(|part| at[part] + dt * slope[part])
    };
    let mut now = [start.position, start.velocity, 0.0, 0.0];
    for _ in 0..steps {
        let a = slope(now);
        let b = slope(ahead(now, a, dt / 2.0));
        let c = slope(ahead(now, b, dt / 2.0));
        let d = slope(ahead(now, c, dt));
        let mean =
            std::array::from_fn(|part| (a[part] + 2.0 * (b[part] + c[part]) + d[part]) / 6.0);
        now = ahead(now, mean, dt);
    }
    let [position, velocity, work, burnt] = now;
    (State { position, velocity }, work, burnt)
}

#[test]
fn series_and_runge_kutta_agree() {
    let start = State { position: -0.004, velocity: 0.3 };
    for (damping, stiffness) in [(0.201, 50.0), (0.0, 0.0), (7.746, 50.0), (30.0, 50.0), (3.0, 0.0)]
    {
        let motion = Motion { mass: 0.3, damping, stiffness, rest: 0.001 };
        let series = motion.over(0.05).step(&motion, start, -1.5);
        let (stepped, work, _) = runge_kutta(&motion, start, -1.5, 0.05, 400);
        assert_abs_diff_eq!(series.position, stepped.position, epsilon = 1e-12);
        assert_abs_diff_eq!(series.velocity, stepped.velocity, epsilon = 1e-11);
        assert_abs_diff_eq!(work, -1.5 * (series.position - start.position), epsilon = 1e-12);
    }
}

/// A mass alone: `x = v t − f t² / (2 m)`; with a spring alone: `x = v sin(ω t) / ω`.
#[test]
fn series_equals_the_textbook() {
    let start = State { position: 0.0, velocity: 0.5 };
    let free = Motion { mass: 2.0, damping: 0.0, stiffness: 0.0, rest: 0.0 };
    let end = free.over(0.25).step(&free, start, 3.0);
    assert_abs_diff_eq!(end.position, 0.125 - 3.0 * 0.0625 / 4.0, epsilon = 1e-16);
    let sprung = Motion { stiffness: 18.0, ..free };
    let end = sprung.over(0.25).step(&sprung, start, 0.0);
    assert_abs_diff_eq!(end.position, 0.5 * (0.75f64).sin() / 3.0, epsilon = 1e-16);
    assert_abs_diff_eq!(end.velocity, 0.5 * (0.75f64).cos(), epsilon = 2e-16);
}
