//! Loose arithmetic: what every correctly rounded product, quotient and root keeps, and no more.
//!
//! Rounding is monotone and keeps 0, 1 and every number of the format. Each axiom follows from that and from the rules of IEEE
//! 754 for NaN, infinities and zeros. What is shown from them is shown of the operations themselves, without their bits.

use std::fmt::Write;

use crate::tape::Place;

/// Numbers of any binary format as reals: finite ones as they are, an infinity and NaN as two more beyond the largest.
pub(crate) const NUMBERS: &str = "\
(declare-const tiny Real)
(declare-const epsilon Real)
(declare-const largest Real)
(assert (and (< 0.0 tiny epsilon) (<= epsilon 0.001) (< 60000.0 largest)))
(define-fun infinity () Real (+ largest 1.0))
(define-fun nan () Real (+ largest 2.0))
(define-fun isNaN ((x Real)) Bool (= x nan))
(define-fun isInfinite ((x Real)) Bool (or (= x infinity) (= x (- infinity))))
(define-fun isZero ((x Real)) Bool (= x 0.0))
(define-fun finite ((x Real)) Bool (and (<= (- largest) x) (<= x largest)))
(define-fun number ((x Real)) Bool (or (finite x) (isInfinite x) (isNaN x)))
(define-fun lt ((x Real) (y Real)) Bool (and (not (isNaN x)) (not (isNaN y)) (< x y)))
(define-fun leq ((x Real) (y Real)) Bool (and (not (isNaN x)) (not (isNaN y)) (<= x y)))
(define-fun gt ((x Real) (y Real)) Bool (lt y x))
(define-fun geq ((x Real) (y Real)) Bool (leq y x))
(define-fun eq ((x Real) (y Real)) Bool (and (leq x y) (leq y x)))
(define-fun minus ((x Real)) Real (ite (isNaN x) x (- x)))
(define-fun size ((x Real)) Real (ite (< x 0.0) (- x) x))";

/// The axioms of `p = a b`, also beside the products there are already.
pub(crate) fn product(out: &mut String, earlier: &[[Place; 3]], [p, a, b]: [Place; 3]) {
    let none =
        format!("(or (isNaN n{a}) (isNaN n{b}) {} {})", infinite_zero(a, b), infinite_zero(b, a));
    fact(out, &format!("(= (isNaN n{p}) {none})"));
    fact(
        out,
        &format!("(=> (and (or (isZero n{a}) (isZero n{b})) (not (isNaN n{p}))) (isZero n{p}))"),
    );
    let endless = format!("(or (isInfinite n{a}) (isInfinite n{b}))");
    fact(out, &format!("(=> (and {endless} (not (isNaN n{p}))) (isInfinite n{p}))"));
    fact(
        out,
        &format!(
            "(=> (or (and (geq n{a} 0.0) (geq n{b} 0.0)) (and (leq n{a} 0.0) (leq n{b} 0.0))) (not (lt n{p} 0.0)))"
        ),
    );
    fact(
        out,
        &format!(
            "(=> (or (and (geq n{a} 0.0) (leq n{b} 0.0)) (and (leq n{a} 0.0) (geq n{b} 0.0))) (not (gt n{p} 0.0)))"
        ),
    );
    for (x, y) in [(a, b), (b, a)] {
        let small = format!("(and (leq (size n{y}) 1.0) (not (isNaN n{p})))");
        fact(out, &format!("(=> {small} (leq (size n{p}) (size n{x})))"));
    }
    for [other, c, d] in earlier {
        for (c, d) in [(c, d), (d, c)] {
            for [small, x, y, large, v, w] in [[p, a, b, *other, *c, *d], [*other, *c, *d, p, a, b]]
            {
                let known = format!("(not (isNaN n{small})) (not (isNaN n{large}))");
                let order = [(x, v), (y, w)].map(|(x, v)| format!("(leq (size n{x}) (size n{v}))"));
                let then = format!("(leq (size n{small}) (size n{large}))");
                fact(out, &format!("(=> (and {} {known}) {then})", order.join(" ")));
            }
        }
    }
}

/// A sum with its terms, as they are added.
pub(crate) type Sum = (Place, [String; 2]);

/// The sum `s = a + b`, with the negative of `b` where it is taken away.
pub(crate) fn terms([s, a, b]: [Place; 3], taken: bool) -> Sum {
    let b = if taken { format!("(minus n{b})") } else { format!("n{b}") };
    (s, [format!("n{a}"), b])
}

/// The axioms of a sum, also beside the sums there are already.
pub(crate) fn sum(out: &mut String, earlier: &[Sum], (s, [a, b]): &Sum) {
    for (other, [c, d]) in earlier {
        for (c, d) in [(c, d), (d, c)] {
            for [small, x, y, large, v, w] in [
                [&format!("n{s}"), a, b, &format!("n{other}"), c, d],
                [&format!("n{other}"), c, d, &format!("n{s}"), a, b],
            ] {
                fact(
                    out,
                    &format!(
                        "(=> (and (leq {x} {v}) (leq {y} {w}) (not (isNaN {small})) (not (isNaN {large}))) (leq {small} {large}))"
                    ),
                );
            }
        }
    }
    let opposite = format!("(and (isInfinite {a}) (isInfinite {b}) (not (eq {a} {b})))");
    fact(out, &format!("(= (isNaN n{s}) (or (isNaN {a}) (isNaN {b}) {opposite}))"));
    fact(
        out,
        &format!(
            "(=> (and (or (isInfinite {a}) (isInfinite {b})) (not (isNaN n{s}))) (isInfinite n{s}))"
        ),
    );
    for (x, y) in [(&a, &b), (&b, &a)] {
        fact(out, &format!("(=> (and (isZero {y}) (not (isNaN n{s}))) (eq n{s} {x}))"));
        fact(out, &format!("(=> (geq {y} 0.0) (not (lt n{s} {x})))"));
        fact(out, &format!("(=> (leq {y} 0.0) (not (gt n{s} {x})))"));
    }
    let known = format!("(not (isNaN n{s}))");
    fact(out, &format!("(=> (and {known} (lt {a} (minus {b}))) (lt n{s} 0.0))"));
    fact(out, &format!("(=> (and {known} (gt {a} (minus {b}))) (gt n{s} 0.0))"));
    fact(out, &format!("(=> (and {known} (eq {a} (minus {b}))) (isZero n{s}))"));
}

/// The axioms of `q = a / b`, also beside the quotients there are already.
pub(crate) fn quotient(out: &mut String, earlier: &[[Place; 3]], [q, a, b]: [Place; 3]) {
    for [other, c, d] in earlier {
        let same = format!("(eq n{a} n{c}) (eq n{b} n{d}) (not (isZero n{b})) (not (isNaN n{q}))");
        fact(out, &format!("(=> (and {same}) (eq n{q} n{other}))"));
    }
    let both = |test: &str| format!("(and ({test} n{a}) ({test} n{b}))");
    let none = format!("(or (isNaN n{a}) (isNaN n{b}) {} {})", both("isZero"), both("isInfinite"));
    fact(out, &format!("(= (isNaN n{q}) {none})"));
    let known = format!("(not (isNaN n{q}))");
    fact(
        out,
        &format!("(=> (and {known} (or (isZero n{b}) (isInfinite n{a}))) (isInfinite n{q}))"),
    );
    fact(out, &format!("(=> (and {known} (or (isZero n{a}) (isInfinite n{b}))) (isZero n{q}))"));
    fact(
        out,
        &format!(
            "(=> (or (and (geq n{a} 0.0) (gt n{b} 0.0)) (and (leq n{a} 0.0) (lt n{b} 0.0))) (not (lt n{q} 0.0)))"
        ),
    );
    fact(
        out,
        &format!(
            "(=> (or (and (geq n{a} 0.0) (lt n{b} 0.0)) (and (leq n{a} 0.0) (gt n{b} 0.0))) (not (gt n{q} 0.0)))"
        ),
    );
    fact(out, &format!("(=> (and {known} (leq (size n{a}) (size n{b}))) (leq (size n{q}) 1.0))"));
    fact(out, &format!("(=> (and {known} (geq (size n{a}) (size n{b}))) (geq (size n{q}) 1.0))"));
    fact(out, &format!("(=> (and {known} (geq (size n{b}) 1.0)) (leq (size n{q}) (size n{a})))"));
}

/// The axioms of `r = √a`.
pub(crate) fn root(out: &mut String, r: Place, a: Place) {
    fact(out, &format!("(= (isNaN n{r}) (or (isNaN n{a}) (lt n{a} 0.0)))"));
    fact(out, &format!("(= (isInfinite n{r}) (and (isInfinite n{a}) (gt n{a} 0.0)))"));
    fact(out, &format!("(not (lt n{r} 0.0))"));
}

fn infinite_zero(a: Place, b: Place) -> String {
    format!("(and (isInfinite n{a}) (isZero n{b}))")
}

fn fact(out: &mut String, axiom: &str) {
    let _ = writeln!(out, "(assert {axiom})");
}
