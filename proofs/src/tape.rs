//! Tape: the operations that a step was seen to make, each one once.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;

use lyapunov_core::Scalar;

/// Place of an operation on the tape.
pub(crate) type Place = u32;

/// Constant whose value depends on the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Limit {
    SmallestNormal,
    SmallestPositive,
    Largest,
    Epsilon,
}

/// Operation on numbers, or test of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    /// A free number, by its index among the variables.
    Free(u32),
    /// The bits of an `f64`, to be rounded to the format.
    Number(u64),
    Limit(Limit),
    Neg(Place),
    Add(Place, Place),
    Sub(Place, Place),
    Mul(Place, Place),
    Div(Place, Place),
    Root(Place),
    Select(Place, Place, Place),
    Truth(bool),
    Below(Place, Place),
    Finite(Place),
    And(Place, Place),
    Or(Place, Place),
    Not(Place),
}

/// The operations and the names of the variables.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    nodes: Vec<Node>,
    /// What construction sees in the place of each number.
    pub(crate) witnesses: Vec<f64>,
    pub(crate) names: Vec<String>,
    places: HashMap<Node, Place>,
}

/// Change of the arithmetic that a query must notice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mutant {
    /// `1 − 4 ε` becomes 1.
    MarginGone,
    /// `1 − 4 ε` becomes `1 + 4 ε`.
    MarginInverted,
    /// `α` is not limited.
    ClampGone,
    /// Whatever is computed passes for finite.
    ProbeGone,
}

impl Mutant {
    pub(crate) const ALL: [(&str, Self); 4] = [
        ("margin-gone", Self::MarginGone),
        ("margin-inverted", Self::MarginInverted),
        ("clamp-gone", Self::ClampGone),
        ("probe-gone", Self::ProbeGone),
    ];
}

thread_local! {
    static TAPE: RefCell<Tape> = RefCell::default();
    static MUTANT: Cell<Option<Mutant>> = const { Cell::new(None) };
}

/// Looks at the tape.
pub(crate) fn with<R>(f: impl FnOnce(&Tape) -> R) -> R {
    TAPE.with_borrow(f)
}

/// Empties the tape.
pub(crate) fn clear() {
    TAPE.with_borrow_mut(|tape| *tape = Tape::default());
}

/// Records the arithmetic of `mutant` from now on.
pub(crate) fn mutate(mutant: Option<Mutant>) {
    MUTANT.set(mutant);
}

/// A free number called `name`; construction takes it for `witness`.
pub(crate) fn free(name: &str, witness: f64) -> Place {
    TAPE.with_borrow_mut(|tape| {
        if let Some(index) = tape.names.iter().position(|it| it == name) {
            return tape.places[&Node::Free(index as u32)];
        }
        tape.names.push(name.to_owned());
        tape.enter(Node::Free(tape.names.len() as u32 - 1), witness)
    })
}

/// The place of `node`, which is entered where it is new.
pub(crate) fn push(node: Node) -> Place {
    TAPE.with_borrow_mut(|tape| {
        let node = tape.simple(MUTANT.get().map_or(node, |mutant| tape.mutated(node, mutant)));
        if let Some(place) = tape.places.get(&node) {
            return *place;
        }
        let witness = node.value(&tape.witnesses);
        tape.enter(node, witness)
    })
}

impl Tape {
    /// All places, in order.
    pub(crate) fn places(&self) -> std::ops::Range<Place> {
        0..self.nodes.len() as Place
    }

    fn enter(&mut self, node: Node, witness: f64) -> Place {
        let place = self.nodes.len() as Place;
        self.nodes.push(node);
        self.witnesses.push(witness);
        self.places.insert(node, place);
        place
    }

    pub(crate) fn node(&self, place: Place) -> Node {
        self.nodes[place as usize]
    }

    /// What is recorded in the place of `node`.
    fn mutated(&self, node: Node, mutant: Mutant) -> Node {
        let one = |place| self.node(place) == Node::Number(1_f64.to_bits());
        let scaled = |place| match self.node(place) {
            Node::Mul(_, of) => self.node(of) == Node::Limit(Limit::Epsilon),
            _ => false,
        };
        let limited = |most| match self.node(most) {
            Node::Select(_, most, _) => matches!(self.node(most), Node::Select(..)),
            _ => false,
        };
        match (mutant, node) {
            (Mutant::MarginGone, Node::Sub(a, b)) if one(a) && scaled(b) => self.node(a),
            (Mutant::MarginInverted, Node::Sub(a, b)) if one(a) && scaled(b) => Node::Add(a, b),
            (Mutant::ClampGone, Node::Select(mask, a, most))
                if limited(most) && self.node(mask) == Node::Below(a, most) =>
            {
                self.node(a)
            }
            (Mutant::ProbeGone, Node::Finite(_)) => Node::Truth(true),
            _ => node,
        }
    }

    /// The same truth with fewer operations; numbers stay as they were computed.
    fn simple(&self, node: Node) -> Node {
        let truth = |place| match self.node(place) {
            Node::Truth(truth) => Some(truth),
            _ => None,
        };
        match node {
            Node::And(a, b) => match (truth(a), truth(b)) {
                (Some(false), _) | (_, Some(false)) => Node::Truth(false),
                (Some(true), _) => self.node(b),
                (_, Some(true)) => self.node(a),
                _ if a == b => self.node(a),
                _ => node,
            },
            Node::Or(a, b) => match (truth(a), truth(b)) {
                (Some(true), _) | (_, Some(true)) => Node::Truth(true),
                (Some(false), _) => self.node(b),
                (_, Some(false)) => self.node(a),
                _ if a == b => self.node(a),
                _ => node,
            },
            Node::Not(a) => match (truth(a), self.node(a)) {
                (Some(truth), _) => Node::Truth(!truth),
                (_, Node::Not(inner)) => self.node(inner),
                _ => node,
            },
            _ => node,
        }
    }
}

impl Node {
    /// The number of the operation, given those in the places before it; a truth is 1 or 0, a free number is 0.
    pub(crate) fn value<T: Scalar<Mask = bool>>(self, values: &[T]) -> T {
        let of = |place: Place| values[place as usize];
        let truth = |truth: bool| T::of(if truth { 1.0 } else { 0.0 });
        let is = |place: Place| of(place) == T::of(1.0);
        match self {
            Self::Free(_) => T::of(0.0),
            Self::Number(bits) => T::of(f64::from_bits(bits)),
            Self::Limit(Limit::SmallestNormal) => T::smallest_normal(),
            Self::Limit(Limit::SmallestPositive) => T::smallest_positive(),
            Self::Limit(Limit::Largest) => T::largest(),
            Self::Limit(Limit::Epsilon) => T::epsilon(),
            Self::Neg(a) => -of(a),
            Self::Add(a, b) => of(a) + of(b),
            Self::Sub(a, b) => of(a) - of(b),
            Self::Mul(a, b) => of(a) * of(b),
            Self::Div(a, b) => of(a) / of(b),
            Self::Root(a) => of(a).sqrt(),
            Self::Select(mask, a, b) => of(if is(mask) { a } else { b }),
            Self::Truth(it) => truth(it),
            Self::Below(a, b) => truth(of(a).below(of(b))),
            Self::Finite(a) => truth(of(a).finite()),
            Self::And(a, b) => truth(is(a) && is(b)),
            Self::Or(a, b) => truth(is(a) || is(b)),
            Self::Not(a) => truth(!is(a)),
        }
    }

    /// The places that the node reads.
    pub(crate) fn reads(self) -> Vec<Place> {
        match self {
            Self::Free(_) | Self::Number(_) | Self::Limit(_) | Self::Truth(_) => vec![],
            Self::Neg(a) | Self::Root(a) | Self::Finite(a) | Self::Not(a) => vec![a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
            Self::Below(a, b) | Self::And(a, b) | Self::Or(a, b) => vec![a, b],
            Self::Select(mask, a, b) => vec![mask, a, b],
        }
    }
}
