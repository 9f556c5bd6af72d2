//! Samples for the steps: motions and forces on which the controller acts never, now and then, or always.

/// Steps in one block: small enough for the second-level cache, long enough that no branch predictor learns it.
pub(crate) const STEPS: usize = 4096;
/// Seconds between two ticks.
pub(crate) const PERIOD: f64 = 1e-3;
/// The device's damping, N·s/m.
pub(crate) const DAMPING: f64 = 0.001;
/// The largest damping that the controller may inject: half of m / T at 0.2 kg, N·s/m.
pub(crate) const LIMIT: f64 = 100.0;

/// Mix of samples, by how often the controller acts.
#[derive(Clone, Copy)]
pub(crate) enum Mix {
    Idle,
    Random,
    Always,
}

impl Mix {
    pub(crate) const ALL: [Self; 3] = [Self::Idle, Self::Random, Self::Always];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Idle => "idle",
            Self::Random => "random",
            Self::Always => "always",
        }
    }

    /// A power drawn for this mix, W, from a number in [0, 1).
    fn power(self, random: f64) -> f64 {
        match self {
            Self::Idle => 0.01 + 0.1 * random,
            Self::Random => 0.1 * (random - 0.6),
            Self::Always => -0.01 - 0.1 * random,
        }
    }
}

/// Input of one step.
#[derive(Clone, Copy)]
pub(crate) struct Sample<T, const N: usize> {
    pub(crate) period: T,
    pub(crate) position: [T; N],
    pub(crate) velocity: [T; N],
    pub(crate) displacement: [T; N],
    pub(crate) applied: [T; N],
    pub(crate) work: [T; N],
    pub(crate) effort: [T; N],
}

/// Uniform in [0, 1): splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *seed;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

pub(crate) trait Real: Copy {
    fn of(value: f64) -> Self;
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }
}

impl Real for f32 {
    fn of(value: f64) -> Self {
        value as f32
    }
}

fn sample<T: Real, const N: usize>(seed: &mut u64, power: f64, work: f64) -> Sample<T, N> {
    let sign = if random(seed) < 0.5 { -1.0 } else { 1.0 };
    let velocity = sign * (0.1 + 0.1 * random(seed));
    let displacement = velocity * PERIOD;
    let share = 1.0 / N as f64;
    Sample {
        period: T::of(PERIOD),
        position: [T::of(0.0); N],
        velocity: [T::of(velocity); N],
        displacement: [T::of(displacement); N],
        applied: [T::of(work * share / displacement); N],
        work: [T::of(work * share); N],
        effort: [T::of(power * share / velocity); N],
    }
}

/// Samples whose power at the port makes the paper's recursion act as often as the mix says.
pub(crate) fn sampled<T: Real, const N: usize>(mix: Mix) -> Vec<Sample<T, N>> {
    let mut seed = 42;
    (0..STEPS)
        .map(|_| {
            let power = mix.power(random(&mut seed));
            sample(&mut seed, power, 0.0)
        })
        .collect()
}

/// Samples whose held work makes the observed energy negative as often as the mix says, and sums to 0 over one block.
pub(crate) fn held<T: Real, const N: usize>(mix: Mix) -> Vec<Sample<T, N>> {
    let mut seed = 42;
    let sums: Vec<f64> = (0..STEPS).map(|_| PERIOD * mix.power(random(&mut seed))).collect();
    (0..STEPS)
        .map(|n| {
            let before = if n == 0 { 0.0 } else { sums[n - 1] };
            let last = if n == STEPS - 1 { 0.0 } else { sums[n] };
            sample(&mut seed, 0.05, last - before)
        })
        .collect()
}
