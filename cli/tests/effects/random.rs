//! Random numbers as defined in docs/effects/noise.md.

use approx::abs_diff_eq;

#[derive(Clone, Copy, Debug)]
pub(crate) enum Source {
    Noise = 1,
    Jitter = 2,
    Dropout = 3,
}

/// Philox4x32 of ten rounds: the four words of one draw.
fn words(seed: u64, call: u64, source: Source, axis: u32) -> [u32; 4] {
    let halves = |number: u64| ((number & 0xffff_ffff) as u32, (number >> 32) as u32);
    let (mut k0, mut k1) = halves(seed);
    let (c0, c1) = halves(call);
    let mut c = [c0, c1, source as u32, axis];
    for round in 0..10 {
        if round > 0 {
            (k0, k1) = (k0.wrapping_add(0x9e37_79b9), k1.wrapping_add(0xbb67_ae85));
        }
        let first = 0xd251_1f53_u64 * u64::from(c[0]);
        let second = 0xcd9e_8d57_u64 * u64::from(c[2]);
        let ((low, high), (other_low, other_high)) = (halves(first), halves(second));
        c = [other_high ^ c[1] ^ k0, other_low, high ^ c[3] ^ k1, low];
    }
    c
}

/// Number from 0 to 1, without 1.
fn fraction(high: u32, low: u32) -> f64 {
    let whole = u64::from(high) * (1 << 32) + u64::from(low);
    (whole / 2048) as f64 * 0.5_f64.powi(53)
}

pub(crate) fn normal(seed: u64, call: u64, source: Source, axis: u32) -> f64 {
    let [a, b, c, d] = words(seed, call, source, axis);
    let turn = std::f64::consts::TAU * fraction(c, d);
    (-2.0 * (1.0 - fraction(a, b)).ln()).sqrt() * turn.cos()
}

/// Whether an environment's answer is lost.
pub(crate) fn lost(seed: u64, call: u64, probability: f64) -> bool {
    let [a, b, ..] = words(seed, call, Source::Dropout, 0);
    fraction(a, b) < probability
}

#[test]
fn the_numbers_are_those_of_the_page() {
    let call = |call| [0, 1, 2].map(|axis| normal(7, call, Source::Noise, axis));
    let told = [[-0.438667, -1.233755, -0.357976], [0.234579, 2.273096, -0.396287]];
    for (n, told) in told.into_iter().enumerate() {
        for (ours, told) in call(n as u64).into_iter().zip(told) {
            assert!(abs_diff_eq!(ours, told, epsilon = 5.1e-7), "{ours} is not {told}");
        }
    }
}
