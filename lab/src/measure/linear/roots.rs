//! All roots of a polynomial at once.

use nalgebra::Complex;

/// Steps after which the iteration leaves what has not settled: a root of high multiplicity, or none at all.
const STEPS: usize = 200;

/// Steps smaller than this share of a root change nothing that matters.
const SETTLED: f64 = 4.0 * f64::EPSILON;

/// Moves `places` to as many roots of a polynomial given by `step`, the ratio of its value to its derivative.
///
/// Aberth's iteration (Mathematics of Computation 27, 1973), Newton's with every place repelled by the others: `x ← x −
/// n / (1 − n Σ 1 / (x − x_j))`, `n = p / p′`. Evaluating a polynomial in its given form yields roots to the digits of
/// that form, while a companion matrix yields them to the digits of its largest entry.
pub(super) fn settle(places: &mut [Complex<f64>], step: impl Fn(Complex<f64>) -> Complex<f64>) {
    let mut settled = vec![false; places.len()];
    for _ in 0..STEPS {
        for at in 0..places.len() {
            if settled[at] {
                continue;
            }
            let place = places[at];
            let newton = step(place);
            let others = places.iter().enumerate().filter(|(other, _)| *other != at);
            let repelled: Complex<f64> =
                others.map(|(_, other)| (place - other).inv()).filter(is_finite).sum();
            let change = newton / (Complex::from(1.0) - newton * repelled);
            if !is_finite(&change) {
                // On a pole, or at a root of high order that is known no better.
                settled[at] = newton.norm_sqr() == 0.0 || !is_finite(&newton);
                continue;
            }
            places[at] = place - change;
            settled[at] = change.norm_sqr() <= SETTLED * SETTLED * place.norm_sqr();
        }
        if settled.iter().all(|done| *done) {
            return;
        }
    }
}

fn is_finite(value: &Complex<f64>) -> bool {
    value.re.is_finite() && value.im.is_finite()
}

/// `count` places on the unit circle, none on the real axis and no two mirrored.
pub(super) fn circle(count: usize) -> impl Iterator<Item = Complex<f64>> {
    (0..count).map(move |index| {
        let angle = std::f64::consts::TAU * index as f64 / count as f64 + 0.4;
        Complex::new(libm::cos(angle), libm::sin(angle))
    })
}
