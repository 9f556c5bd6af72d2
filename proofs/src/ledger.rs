//! Ledger: what one booking loses by rounding.

use std::fmt::Write;

use lyapunov_core::{Accumulator, Compensated, Plain, Signal, Snapshot};

use crate::paths::{self, assume};
use crate::smt::{F16, Format, Query};
use crate::symbolic::Symbolic;
use crate::tape::{self, Node};

/// Script for Gappa: a plain sum loses at most half a unit of itself, also where it is subnormal.
pub(crate) fn plain(format: Format) -> String {
    let Format::Binary { exponent, digits, .. } = format else { return String::new() };
    let (sum, term) = (Symbolic::free("sum", 0.0), Symbolic::free("term", 0.0));
    let mut booked = Plain::<Symbolic>::zero().restored(sum).expect("a sum");
    booked.add(term);
    let node = tape::with(|tape| tape.node(booked.state().0));
    let booked = if node == Node::Add(sum.0, term.0) { "sum + term" } else { "unknown" };
    let most = 1 << (exponent - 1);
    format!(
        "@rounded = float<{digits}, {}, ne>;\nsum = rounded(sum_);\nterm = rounded(term_);\n\
         booked = rounded({booked});\n\
         {{ |sum| in [0, 1b{most}] /\\ |term| in [0, 1b{most}] -> |booked -/ (sum + term)| <= 1b-{digits} }}\n",
        3 - most - digits as i32
    )
}

/// Query in `f16`: a compensated sum that loses more than `2 u² (|S| + |term|)`, or leaves an error above `u |S|`.
pub(crate) fn compensated() -> String {
    let numbers = ["sum", "error", "term"];
    let found = paths::every(|| {
        let [sum, error, term] = numbers.map(|name| Symbolic::free(name, 0.0));
        let mut booked = Compensated::<Symbolic>::zero().restored((sum, error)).expect("a sum");
        paths::step(|| booked.add(term));
        let (whole, left) = booked.state();
        let all = [sum, error, term, whole, left];
        all.iter().for_each(|number| assume(number.finite()));
        all
    });
    let text = Query { cases: vec![found[0].known.clone()], cuts: vec![] }.text(F16);
    let mut text = text.replace("(check-sat)\n", "");
    // In f64 every sum of numbers in f16 is exact, and so is one times the square of the unit.
    text += "(define-sort Wide () (_ FloatingPoint 11 53))\n(define-fun unit () Wide ((_ to_fp 11 53) RNE (/ 1.0 2048.0)))\n";
    for (name, number) in ["sum", "error", "term", "whole", "left"].iter().zip(found[0].result) {
        let _ = writeln!(text, "(define-fun {name} () Wide ((_ to_fp 11 53) RNE n{}))", number.0);
    }
    text += "(define-fun before () Wide (fp.add RNE (fp.add RNE sum error) term))\n\
             (define-fun lost () Wide (fp.abs (fp.sub RNE (fp.add RNE whole left) before)))\n\
             (define-fun both () Wide (fp.add RNE (fp.abs sum) (fp.abs term)))\n\
             (define-fun most () Wide (fp.mul RNE (fp.mul RNE unit unit) (fp.add RNE both both)))\n\
             (assert (fp.leq (fp.abs error) (fp.mul RNE unit (fp.abs sum))))\n\
             (assert (not (and (fp.leq lost most) (fp.leq (fp.abs left) (fp.mul RNE unit (fp.abs whole))))))\n\
             (check-sat)\n";
    text
}
