//! Tape: the operations that a step was seen to make, each one once.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;

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
        let witness = tape.witness(node);
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

    fn witness(&self, node: Node) -> f64 {
        let of = |place: Place| self.witnesses[place as usize];
        let truth = |truth: bool| if truth { 1.0 } else { 0.0 };
        match node {
            Node::Free(_) => 0.0,
            Node::Number(bits) => f64::from_bits(bits),
            Node::Limit(Limit::SmallestNormal) => f64::MIN_POSITIVE,
            Node::Limit(Limit::SmallestPositive) => f64::from_bits(1),
            Node::Limit(Limit::Largest) => f64::MAX,
            Node::Limit(Limit::Epsilon) => f64::EPSILON,
            Node::Neg(a) => -of(a),
            Node::Add(a, b) => of(a) + of(b),
            Node::Sub(a, b) => of(a) - of(b),
            Node::Mul(a, b) => of(a) * of(b),
            Node::Div(a, b) => of(a) / of(b),
            Node::Root(a) => of(a).sqrt(),
            Node::Select(mask, a, b) => {
                if of(mask) == 1.0 {
                    of(a)
                } else {
                    of(b)
                }
            }
            Node::Truth(it) => truth(it),
            Node::Below(a, b) => truth(of(a) < of(b)),
            Node::Finite(a) => truth(of(a).is_finite()),
            Node::And(a, b) => of(a) * of(b),
            Node::Or(a, b) => of(a).max(of(b)),
            Node::Not(a) => 1.0 - of(a),
        }
    }
}

impl Node {
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
