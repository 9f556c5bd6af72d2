//! First root of a polynomial, isolated with certainty.

/// The degree of every polynomial here.
pub(super) const ORDER: usize = 24;

/// `Σ c[k] τᵏ` for `0 ≤ τ ≤ 1`.
pub(super) type Polynomial<T = f64> = [T; ORDER + 1];

/// The first `τ` in `[0, 1]` at which the polynomial stops being positive; where it starts from 0, the first
/// after it has been positive, or 0 if it never is.
///
/// The Bernstein coefficients of an interval have at least as many changes of sign as the polynomial has roots in it; no change
/// means no root, and one change one root (Lane and Riesenfeld 1981). With none the interval is passed over; with one the
/// root is polished; with more the interval is halved. Conversion from powers of `τ` to Bernstein's form on `[0, 1]`
/// makes no number grow, so no digits are lost. Two roots closer than `2^-DEEPEST` are a graze within rounding; they
/// are passed over.
pub(super) fn first_fall(polynomial: &Polynomial) -> Option<f64> {
    let lead = polynomial.iter().position(|&coefficient| coefficient != 0.0)?;
    let mut reduced = [0.0; ORDER + 1];
    reduced[..=ORDER - lead].copy_from_slice(&polynomial[lead..]);
    if reduced[0] < 0.0 {
        return Some(0.0);
    }
    if reduced.iter().map(|&coefficient| coefficient.min(0.0)).sum::<f64>() + reduced[0] > 0.0 {
        return None;
    }
    search(&reduced, &bernstein(&reduced))
}

const DEEPEST: u32 = 40;
const INTERVALS: usize = 400;

fn search(polynomial: &Polynomial, whole: &Polynomial) -> Option<f64> {
    let (mut index, mut depth) = (0_u64, 0);
    for _ in 0..INTERVALS {
        let parts = (1_u64 << depth) as f64;
        let (start, end) = (index as f64 / parts, (index + 1) as f64 / parts);
        let part = restrict(whole, start, end);
        match changes(&part) {
            1 => return Some(polish(polynomial, start, end)),
            0 if part[ORDER] == 0.0 => return Some(end),
            several if several > 0 && depth < DEEPEST => {
                (index, depth) = (2 * index, depth + 1);
                continue;
            }
            _ => {}
        }
        index += 1;
        // Moves on to the widest interval that starts here.
        while index.is_multiple_of(2) && depth > 0 {
            (index, depth) = (index / 2, depth - 1);
        }
        if depth == 0 {
            return None;
        }
    }
    None
}

fn changes(coefficients: &Polynomial) -> usize {
    let mut positive = true;
    let mut count = 0;
    for &coefficient in coefficients.iter().filter(|&&coefficient| coefficient != 0.0) {
        if (coefficient > 0.0) != positive {
            positive = !positive;
            count += 1;
        }
    }
    count
}

fn bernstein(polynomial: &Polynomial) -> Polynomial {
    let mut coefficients = *polynomial;
    let mut binomial = 1.0;
    for (k, coefficient) in coefficients.iter_mut().enumerate() {
        *coefficient /= binomial;
        binomial = binomial * (ORDER - k) as f64 / (k + 1) as f64;
    }
    for from in (0..ORDER).rev() {
        for at in from..ORDER {
            coefficients[at + 1] += coefficients[at];
        }
    }
    coefficients
}

/// The coefficients on `[start, end]` (de Casteljau).
fn restrict(whole: &Polynomial, start: f64, end: f64) -> Polynomial {
    let mut part = *whole;
    if end < 1.0 {
        for round in 1..=ORDER {
            for at in (round..=ORDER).rev() {
                part[at] = (1.0 - end) * part[at - 1] + end * part[at];
            }
        }
    }
    let start = start / end;
    if start > 0.0 {
        for round in 1..=ORDER {
            for at in 0..=ORDER - round {
                part[at] = (1.0 - start) * part[at] + start * part[at + 1];
            }
        }
    }
    part
}

/// The one root in `[start, end]`, to the last digit: Newton's method, halving where that would leave the interval.
fn polish(polynomial: &Polynomial, mut start: f64, mut end: f64) -> f64 {
    let mut at = 0.5 * (start + end);
    for _ in 0..200 {
        let (value, slope) = polynomial
            .iter()
            .rev()
            .fold((0.0, 0.0), |(value, slope), c| (value * at + c, slope * at + value));
        if value > 0.0 {
            start = at;
        } else {
            end = at;
        }
        let newton = at - value / slope;
        if (newton - at).abs() <= f64::EPSILON * at {
            return newton.clamp(0.0, 1.0);
        }
        at = if newton > start && newton < end { newton } else { 0.5 * (start + end) };
        if end - start <= f64::EPSILON * end {
            break;
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `Π (1 − τ / root)`.
    fn through(roots: &[f64]) -> Polynomial {
        let mut product = [0.0; ORDER + 1];
        product[0] = 1.0;
        for root in roots {
            for k in (0..ORDER).rev() {
                product[k + 1] -= product[k] / root;
            }
        }
        product
    }

    #[test]
    fn the_first_of_many_roots_is_found_at_any_distance_of_the_next() {
        let others = [0.71, 0.83, 0.97, 1.4];
        for first in [0.003, 0.12, 0.26, 0.51, 0.66] {
            for gap in [0.2, 0.03, 1e-3, 1e-5] {
                let roots = [&[first, first + gap][..], &others].concat();
                let found = first_fall(&through(&roots));
                let is_near = found.is_some_and(|found| (found - first).abs() < 1e-10 / gap);
                assert!(is_near, "{first} and {gap} on: {found:?}");
            }
        }
    }

    #[test]
    fn what_only_grazes_0_is_passed_over() {
        for graze in [0.04, 0.1, 0.3, 0.45, 0.6] {
            for height in [1e-3, 1e-5] {
                // (1 − τ / graze)² + height, and that times 1 − τ / 0.8.
                let mut lifted = through(&[graze, graze]);
                lifted[0] += height;
                let mut product = lifted;
                (1..=ORDER).for_each(|k| product[k] -= lifted[k - 1] / 0.8);
                let found = first_fall(&product);
                let is_near = found.is_some_and(|found| (found - 0.8).abs() < 1e-12);
                assert!(is_near, "{graze}, {height}: {found:?}");
            }
        }
    }

    #[test]
    fn a_polynomial_that_only_grazes_0_does_not_fall() {
        assert_eq!(first_fall(&through(&[1.2, 1.3])), None);
        let mut lifted = through(&[0.4, 0.4]);
        lifted[0] += 1e-3;
        assert_eq!(first_fall(&lifted), None);
    }
}
