//! Gappa: the served energy of a debt that is served below the limit, as a script about relative errors.
//!
//! The expression of `α` is read off the tape: of each choice the branch is taken that a debt below the limit takes. A query of
//! its own shows that those are the branches.

use lyapunov_core::Mask;

use crate::seen::Seen;
use crate::smt::Format;
use crate::symbolic::Truth;
use crate::tape::{self, Limit, Node, Place, Tape};

/// A straight line through choices, with what decided them.
#[derive(Debug, Default)]
struct Line {
    /// The operations in order, without choices.
    places: Vec<Place>,
    decided: Vec<(Place, bool)>,
}

impl Line {
    /// The place that `place` is, past all choices, as the witnesses choose.
    fn follow(&mut self, tape: &Tape, place: Place, ends: &[Place]) -> Place {
        let node = tape.node(place);
        if let (Node::Select(mask, yes, no), false) = (node, ends.contains(&place)) {
            let taken = tape.witnesses[mask as usize] == 1.0;
            self.decided.push((mask, taken));
            return self.follow(tape, if taken { yes } else { no }, ends);
        }
        if !self.places.contains(&place) {
            if !ends.contains(&place) {
                for read in node.reads() {
                    self.follow(tape, read, ends);
                }
            }
            self.places.push(place);
        }
        place
    }
}

/// What decides that `α` is computed as in the scripts: that the divisor is normal, and the rest.
pub(crate) fn branches(seen: &Seen) -> (Truth, Vec<Truth>) {
    let (divisor, rest): (Vec<Truth>, Vec<Truth>) = decided(seen).into_iter().partition(|mask| {
        let node = tape::with(|tape| tape.node(mask.0));
        let Node::Below(least, product) = node else { return false };
        let least = tape::with(|tape| tape.node(least));
        product != seen.square.0 && least == Node::Limit(Limit::SmallestNormal)
    });
    match divisor.first() {
        Some(normal) => (*normal, rest),
        // No path with a debt below the limit; if there is one, the query fails.
        None => (Mask::of(true), vec![Mask::of(false)]),
    }
}

fn decided(seen: &Seen) -> Vec<Truth> {
    tape::with(|tape| {
        let mut line = Line::default();
        line.follow(tape, seen.alpha.0, &[seen.sum.0, seen.square.0]);
        line.decided.iter().map(|(mask, taken)| (Truth(*mask), *taken)).collect::<Vec<_>>()
    })
    .into_iter()
    .map(|(mask, taken)| if taken { mask } else { !mask })
    .collect()
}

/// Scripts for `format`: below the quarter of the range in which the reciprocal is normal, and above.
pub(crate) fn scripts(seen: &Seen, format: Format) -> Vec<(&'static str, String)> {
    let Format::Binary { exponent, digits, .. } = format else { return vec![] };
    let most = 1 << (exponent - 1);
    let least = 2 - most;
    let ranges = [
        ("normal", format!("[1b{least}, 1b{}]", most - 2)),
        ("largest", format!("[1b{}, 1b{most}]", most - 2)),
    ];
    ranges
        .into_iter()
        .map(|(name, range)| (name, script(seen, &range, [most, least, digits as i32])))
        .collect()
}

fn script(seen: &Seen, range: &str, [most, least, digits]: [i32; 3]) -> String {
    let lowest = least - digits + 1;
    let (sum, square) = (seen.sum.0, seen.square.0);
    let (lines, alpha, margin) = tape::with(|tape| {
        let mut line = Line::default();
        let alpha = line.follow(tape, seen.alpha.0, &[sum, square]);
        let mut writer = Writer { tape, line: Line::default(), sum, square, digits };
        let lines: Vec<_> = line.places.iter().map(|place| writer.operation(*place)).collect();
        (lines.concat(), alpha, writer.margin(&line.places))
    });
    let least = format!("1b{least}");
    format!(
        "# What is no less than the smallest normal number is rounded as if digits went on below; a quotient may be less.\n\
         @rounded = float<{digits}, {}, ne>;\n@quotient = float<{digits}, {lowest}, ne>;\n\
         n{square} = rounded(square);\n\
         debt = rounded(debt_);\nn{sum} = -debt;\n\
         {lines}served = rounded(n{alpha} * n{square});\nexact = e{alpha} * n{square};\n\
         {{ n{square} in {range} /\\ debt in [1b{lowest}, 1b{most}]\n\
         /\\ x{alpha} in [{least}, 1b{most}] /\\ n{alpha} * n{square} in [{least}, 1b{most}]\n\
         -> (served - debt) / debt >= 0 }}\n\
         (served - debt) / debt -> (1 + (served - exact) / exact) * (exact / debt) - 1 {{ exact <> 0, debt <> 0 }};\n\
         exact / debt -> 1 / {margin} {{ debt <> 0, n{square} <> 0 }};\n",
        lowest - 1
    )
}

/// Writer of the operations of a line: each as computed, `n`, before it is rounded, `x`, and from exact ones, `e`.
struct Writer<'a> {
    tape: &'a Tape,
    line: Line,
    sum: Place,
    square: Place,
    digits: i32,
}

impl Writer<'_> {
    fn operation(&mut self, place: Place) -> String {
        if place == self.sum || place == self.square {
            return String::new();
        }
        let node = self.tape.node(place);
        let reads: Vec<Place> = node
            .reads()
            .into_iter()
            .map(|read| self.line.follow(self.tape, read, &[self.sum, self.square]))
            .collect();
        let term = |exact: bool| -> String {
            let of = |index: usize| {
                let read = reads[index];
                let letter = if exact { self.exact(read) } else { 'n' };
                format!("{letter}{read}")
            };
            match node {
                Node::Number(bits) => f64::from_bits(bits).to_string(),
                Node::Limit(Limit::Epsilon) => format!("1b{}", 1 - self.digits),
                Node::Neg(_) => format!("-{}", of(0)),
                Node::Add(..) => format!("{} + {}", of(0), of(1)),
                Node::Sub(..) => format!("{} - {}", of(0), of(1)),
                Node::Mul(..) => format!("{} * {}", of(0), of(1)),
                Node::Div(..) => format!("{} / {}", of(0), of(1)),
                other => format!("unknown {other:?}"),
            }
        };
        if self.is_constant(place) {
            return format!("n{place} = {};\n", term(false));
        }
        let rounding = if matches!(node, Node::Div(..)) { "quotient" } else { "rounded" };
        let computed = format!("x{place} = {};\nn{place} = {rounding}(x{place});\n", term(false));
        if self.exact(place) == 'x' {
            computed
        } else {
            format!("{computed}e{place} = {};\n", term(true))
        }
    }

    /// The letter of the exact value of `place`: of what needs no rounding, of what is exact before it is rounded, of the rest.
    fn exact(&self, place: Place) -> char {
        if place == self.sum || place == self.square || self.is_constant(place) {
            return 'n';
        }
        let through =
            |read: &Place| Line::default().follow(self.tape, *read, &[self.sum, self.square]);
        let reads = self.tape.node(place).reads();
        if reads.iter().map(through).all(|read| self.exact(read) == 'n') { 'x' } else { 'e' }
    }

    /// Whether `place` is computed of constants alone; theirs are short and exact.
    fn is_constant(&self, place: Place) -> bool {
        place != self.sum
            && place != self.square
            && !matches!(self.tape.node(place), Node::Free(_))
            && self.tape.node(place).reads().into_iter().all(|read| self.is_constant(read))
    }

    /// The constant that `v² T` is multiplied by before the division.
    fn margin(&self, places: &[Place]) -> String {
        let factor = places.iter().find_map(|place| match self.tape.node(*place) {
            Node::Mul(a, b) if a == self.square && self.is_constant(b) => Some(b),
            Node::Mul(a, b) if b == self.square && self.is_constant(a) => Some(a),
            _ => None,
        });
        factor.map_or("1".to_owned(), |place| format!("n{place}"))
    }
}
