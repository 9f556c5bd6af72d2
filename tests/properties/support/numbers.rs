//! Numbers to try, made from random bits so that a failure shrinks towards zeros.

use crate::support::Real;

/// The bits that one number is made of.
pub(crate) type Bits = u64;

/// Uniform in `[0, 1)`.
pub(crate) fn unit(bits: Bits) -> f64 {
    (bits >> 11) as f64 * 2f64.powi(-53)
}

/// Uniform in the logarithm, between `least` and `most`.
pub(crate) fn log_between(bits: Bits, least: f64, most: f64) -> f64 {
    least * (unit(bits) * (most / least).ln()).exp()
}

/// Uniform in `±scale`.
pub(crate) fn ordinary<T: Real>(bits: Bits, scale: f64) -> T {
    T::of((2.0 * unit(bits) - 1.0) * scale)
}

/// `2^exponent` without a range error on the way to a subnormal.
fn power_of_two(exponent: i32) -> f64 {
    2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2)
}

/// Zeros of either sign, subnormals, ones with an extra bit, numbers whose square is near the smallest normal number,
/// and magnitudes from the smallest number up to 1e18 (`f32`) or 1e150 (`f64`).
pub(crate) fn hostile<T: Real>(bits: Bits) -> T {
    let sign = if bits & 0x10 == 0 { 1.0 } else { -1.0 };
    let mantissa = 1.0 + unit(bits);
    let (least, most) = T::EXPONENTS;
    let tiny = T::smallest_normal().f64().log2() as i32;
    let steps = |span: i32| (bits >> 5 & 0xffff) as i32 % (span + 1);
    let exponent = match bits & 0xf {
        0 | 1 => return T::of(0.0 * sign),
        2 => return T::of(sign * (1.0 + steps(4) as f64 * T::epsilon().f64())),
        3 => least + steps(tiny - least),
        4 => tiny - 1 + steps(3),
        5 | 6 => tiny / 2 - 4 + steps(16),
        7..=9 => -20 + steps(30),
        _ => least + steps(most - least),
    };
    T::of(sign * mantissa * power_of_two(exponent))
}

/// Any bit pattern: NaN, infinities and the whole range.
pub(crate) fn wild<T: Real>(bits: Bits) -> T {
    T::of_bits(bits.rotate_left(17) ^ bits >> 9)
}

/// NaN or an infinity.
pub(crate) fn bad<T: Real>(bits: Bits) -> T {
    T::of([f64::NAN, f64::INFINITY, f64::NEG_INFINITY][(bits % 3) as usize])
}

#[test]
fn hostile_numbers_cover_what_they_say() {
    let numbers: Vec<f32> =
        (0..100_000u64).map(|n| hostile(n.wrapping_mul(0x9e37_79b9_7f4a_7c15))).collect();
    let some = |what: &str, found: fn(&f32) -> bool| {
        assert!(numbers.iter().filter(|x| found(x)).count() > 100, "{what}");
    };
    some("negative zeros", |x| *x == 0.0 && x.is_sign_negative());
    some("subnormals", |x| x.is_subnormal());
    some("squares near the smallest normal number", |x| {
        (0.25..4.0).contains(&(x * x / f32::MIN_POSITIVE))
    });
    some("large ones", |x| x.abs() > 1e15);
    assert!(numbers.iter().all(|x| x.abs() < 1e18));
    assert!((0..1000).all(|n| hostile::<f64>(n << 5 | 0xf).abs() < 1e150));
}
