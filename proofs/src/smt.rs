//! SMT-LIB: the tape as definitions that a solver reads, in a format of IEEE 754 or over the reals.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::loose;
use crate::symbolic::{Symbolic, Truth};
use crate::tape::{self, Limit, Node, Place, Tape};

/// Numbers that a query is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// A binary format of IEEE 754: bits of the exponent, and of the significand with the hidden one.
    Binary { name: &'static str, exponent: u32, digits: u32 },
    /// Exact arithmetic. Everything is finite, and rounding is 0.
    Reals,
    /// Every binary format: products, quotients, sums and roots are free but for what every correct rounding keeps.
    Every,
}

pub(crate) const F16: Format = Format::Binary { name: "f16", exponent: 5, digits: 11 };
pub(crate) const F32: Format = Format::Binary { name: "f32", exponent: 8, digits: 24 };
pub(crate) const F64: Format = Format::Binary { name: "f64", exponent: 11, digits: 53 };

impl Format {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Binary { name, .. } => name,
            Self::Reals => "reals",
            Self::Every => "every",
        }
    }
}

/// Query: whether one of `cases` can hold.
#[derive(Debug)]
pub(crate) struct Query {
    /// Each a conjunction.
    pub(crate) cases: Vec<Vec<Truth>>,
    /// Numbers taken as free, whatever they were computed from.
    pub(crate) cuts: Vec<Symbolic>,
}

impl Query {
    /// The query in SMT-LIB.
    pub(crate) fn text(&self, format: Format) -> String {
        tape::with(|tape| {
            Writer {
                tape,
                format,
                query: self,
                products: vec![],
                quotients: vec![],
                sums: vec![],
                out: String::new(),
            }
            .written()
        })
    }
}

struct Writer<'a> {
    tape: &'a Tape,
    format: Format,
    query: &'a Query,
    /// Products so far, with their factors.
    products: Vec<[Place; 3]>,
    quotients: Vec<[Place; 3]>,
    sums: Vec<loose::Sum>,
    out: String,
}

impl Writer<'_> {
    fn written(mut self) -> String {
        let mut needed = BTreeSet::new();
        let mut open: Vec<Place> = self.query.cases.iter().flatten().map(|it| it.0).collect();
        while let Some(place) = open.pop() {
            if needed.insert(place) && !self.is_cut(place) {
                open.extend(self.tape.node(place).reads());
            }
        }
        let logic = match self.format {
            Format::Binary { .. } => "QF_FP",
            Format::Reals => "QF_NRA",
            Format::Every => "QF_LRA",
        };
        self.line(&format!("(set-logic {logic})"));
        if self.format == Format::Every {
            self.line(loose::NUMBERS);
        }
        if self.format == Format::Reals {
            self.line("(declare-const tiny Real)\n(declare-const largest Real)");
            self.line("(assert (and (< 0.0 tiny) (< tiny 1.0 largest)))");
        }
        for place in needed {
            self.define(place);
        }
        let cases: Vec<String> = self.query.cases.iter().map(|case| conjunction(case)).collect();
        self.line(&format!("(assert (or false {}))\n(check-sat)", cases.join(" ")));
        self.out
    }

    fn is_cut(&self, place: Place) -> bool {
        self.query.cuts.iter().any(|cut| cut.0 == place)
    }

    fn line(&mut self, line: &str) {
        self.out.push_str(line);
        self.out.push('\n');
    }

    fn sort(&self) -> String {
        match self.format {
            Format::Binary { exponent, digits, .. } => {
                format!("(_ FloatingPoint {exponent} {digits})")
            }
            Format::Reals | Format::Every => "Real".to_owned(),
        }
    }

    /// What every correct rounding keeps of the operation at `place`.
    fn axioms(&mut self, place: Place, node: Node) {
        match node {
            Node::Add(a, b) | Node::Sub(a, b) => {
                let sum = loose::terms([place, a, b], matches!(node, Node::Sub(..)));
                loose::sum(&mut self.out, &self.sums, &sum);
                self.sums.push(sum);
            }
            Node::Mul(a, b) => {
                loose::product(&mut self.out, &self.products, [place, a, b]);
                self.products.push([place, a, b]);
            }
            Node::Div(a, b) => {
                loose::quotient(&mut self.out, &self.quotients, [place, a, b]);
                self.quotients.push([place, a, b]);
            }
            _ => loose::root(&mut self.out, place, node.reads()[0]),
        }
    }

    fn define(&mut self, place: Place) {
        let node = self.tape.node(place);
        let sort = self.sort();
        let name = match node {
            Node::Free(index) => format!(" ; {}", self.tape.names[index as usize]),
            _ => String::new(),
        };
        if self.is_cut(place) || matches!(node, Node::Free(_)) {
            self.line(&format!("(declare-const n{place} {sort}){name}"));
            if self.format == Format::Every {
                self.line(&format!("(assert (number n{place}))"));
            }
            return;
        }
        if self.format == Format::Every && is_rounded(node) {
            self.line(&format!("(declare-const n{place} Real)\n(assert (number n{place}))"));
            return self.axioms(place, node);
        }
        match (self.format, node) {
            (Format::Reals, Node::Div(a, b)) => {
                self.line(&format!("(declare-const n{place} Real)"));
                self.line(&format!("(assert (=> (distinct n{b} 0.0) (= (* n{place} n{b}) n{a})))"));
            }
            (Format::Reals, Node::Root(a)) => {
                self.line(&format!("(declare-const n{place} Real)"));
                let square = format!("(= (* n{place} n{place}) n{a})");
                self.line(&format!("(assert (=> (>= n{a} 0.0) (and (>= n{place} 0.0) {square})))"));
            }
            (Format::Reals, Node::Number(bits)) if f64::from_bits(bits).is_nan() => {
                self.line(&format!("(declare-const n{place} Real)"));
            }
            _ => {
                let sort = if is_truth(node) { "Bool".to_owned() } else { sort };
                let term = match self.format {
                    Format::Reals => real(node),
                    Format::Every => loosely(node),
                    Format::Binary { .. } => binary(node, self.format),
                };
                self.line(&format!("(define-fun n{place} () {sort} {term})"));
            }
        }
    }
}

fn is_rounded(node: Node) -> bool {
    use Node::{Add, Div, Mul, Root, Sub};
    matches!(node, Add(..) | Sub(..) | Mul(..) | Div(..) | Root(_))
}

fn is_truth(node: Node) -> bool {
    use Node::{And, Below, Finite, Not, Or, Truth};
    matches!(node, Truth(_) | Below(..) | Finite(_) | And(..) | Or(..) | Not(_))
}

fn conjunction(case: &[Truth]) -> String {
    let mut text = "(and true".to_owned();
    for truth in case {
        let _ = write!(text, " n{}", truth.0);
    }
    text + ")"
}

/// A node of either kind of arithmetic, `select` apart.
fn logic(node: Node) -> Option<String> {
    Some(match node {
        Node::Select(mask, a, b) => format!("(ite n{mask} n{a} n{b})"),
        Node::Truth(truth) => truth.to_string(),
        Node::And(a, b) => format!("(and n{a} n{b})"),
        Node::Or(a, b) => format!("(or n{a} n{b})"),
        Node::Not(a) => format!("(not n{a})"),
        _ => return None,
    })
}

fn binary(node: Node, format: Format) -> String {
    let Format::Binary { exponent, digits, .. } = format else { return real(node) };
    let bits = |exponent_bits: String, fraction: &str| {
        let fraction = fraction.repeat(digits as usize - 1);
        format!("(fp #b0 #b{exponent_bits} #b{fraction})")
    };
    let zeros = |count: u32| "0".repeat(count as usize);
    match node {
        Node::Number(number) => rounded(number, exponent, digits),
        Node::Limit(Limit::SmallestNormal) => bits(zeros(exponent - 1) + "1", "0"),
        Node::Limit(Limit::SmallestPositive) => {
            format!("(fp #b0 #b{} #b{}1)", zeros(exponent), zeros(digits - 2))
        }
        Node::Limit(Limit::Largest) => bits("1".repeat(exponent as usize - 1) + "0", "1"),
        Node::Limit(Limit::Epsilon) => {
            rounded(2_f64.powi(1 - digits as i32).to_bits(), exponent, digits)
        }
        Node::Neg(a) => format!("(fp.neg n{a})"),
        Node::Add(a, b) => format!("(fp.add RNE n{a} n{b})"),
        Node::Sub(a, b) => format!("(fp.sub RNE n{a} n{b})"),
        Node::Mul(a, b) => format!("(fp.mul RNE n{a} n{b})"),
        Node::Div(a, b) => format!("(fp.div RNE n{a} n{b})"),
        Node::Root(a) => format!("(fp.sqrt RNE n{a})"),
        Node::Below(a, b) => format!("(fp.lt n{a} n{b})"),
        Node::Finite(a) => format!("(not (or (fp.isNaN n{a}) (fp.isInfinite n{a})))"),
        other => logic(other).unwrap_or_default(),
    }
}

/// An `f64`, rounded to the format.
fn rounded(number: u64, exponent: u32, digits: u32) -> String {
    format!("((_ to_fp {exponent} {digits}) RNE ((_ to_fp 11 53) #x{number:016x}))")
}

fn real(node: Node) -> String {
    match node {
        Node::Number(bits) => exact(f64::from_bits(bits)),
        Node::Limit(Limit::SmallestNormal | Limit::SmallestPositive) => "tiny".to_owned(),
        Node::Limit(Limit::Largest) => "largest".to_owned(),
        Node::Limit(Limit::Epsilon) => "0.0".to_owned(),
        Node::Neg(a) => format!("(- n{a})"),
        Node::Add(a, b) => format!("(+ n{a} n{b})"),
        Node::Sub(a, b) => format!("(- n{a} n{b})"),
        Node::Mul(a, b) => format!("(* n{a} n{b})"),
        Node::Below(a, b) => format!("(< n{a} n{b})"),
        Node::Finite(_) => "true".to_owned(),
        other => logic(other).unwrap_or_default(),
    }
}

fn loosely(node: Node) -> String {
    match node {
        Node::Number(bits) if f64::from_bits(bits).is_nan() => "nan".to_owned(),
        Node::Limit(Limit::Epsilon) => "epsilon".to_owned(),
        Node::Neg(a) => format!("(minus n{a})"),
        Node::Below(a, b) => format!("(lt n{a} n{b})"),
        Node::Finite(a) => format!("(finite n{a})"),
        other => real(other),
    }
}

/// A constant of the code as a fraction over a power of two; they are numbers with few digits.
fn exact(number: f64) -> String {
    assert!(number.is_finite(), "{number} is no constant");
    let (size, mut scale) = (number.abs(), 1.0);
    while (size * scale).fract() != 0.0 {
        scale *= 2.0;
    }
    let scaled = size * scale;
    assert!(scaled < 1e15, "{number} is no constant of few digits");
    let text = format!("(/ {scaled:.1} {scale:.1})");
    if number < 0.0 { format!("(- {text})") } else { text }
}
