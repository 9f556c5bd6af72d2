//! Symbolic scalar: a number that records what is done with it.

use core::fmt;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Div, Mul, MulAssign, Neg, Not, Sub, SubAssign};

use lyapunov_core::{Mask, Scalar, Signal};
use num_traits::{One, Zero};

use crate::paths;
use crate::tape::{self, Limit, Node, Place};

/// Number on the tape. It stands for any value of any format: what is recorded is the same for all of them.
#[derive(Clone, Copy)]
pub(crate) struct Symbolic(pub(crate) Place);

/// Truth on the tape.
#[derive(Clone, Copy)]
pub(crate) struct Truth(pub(crate) Place);

impl Symbolic {
    /// A free number called `name`, which the checks of constructors take for `witness`.
    pub(crate) fn free(name: &str, witness: f64) -> Self {
        Self(tape::free(name, witness))
    }
}

impl fmt::Debug for Symbolic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

impl fmt::Debug for Truth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

impl PartialEq for Symbolic {
    /// Steps compare by masks. A comparison as a `bool` would take one path without telling.
    fn eq(&self, _other: &Self) -> bool {
        unimplemented!("a step compared two numbers by ==, which is no mask")
    }
}

macro_rules! operator {
    ($($of:ident $name:ident $node:ident, $assign:ident $in_place:ident;)+) => {$(
        impl $of for Symbolic {
            type Output = Self;

            fn $name(self, other: Self) -> Self {
                Self(tape::push(Node::$node(self.0, other.0)))
            }
        }

        impl $assign for Symbolic {
            fn $in_place(&mut self, other: Self) {
                *self = $of::$name(*self, other);
            }
        }
    )+};
}

operator! {
    Add add Add, AddAssign add_assign;
    Sub sub Sub, SubAssign sub_assign;
    Mul mul Mul, MulAssign mul_assign;
}

impl Div for Symbolic {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self(tape::push(Node::Div(self.0, other.0)))
    }
}

impl Neg for Symbolic {
    type Output = Self;

    fn neg(self) -> Self {
        Self(tape::push(Node::Neg(self.0)))
    }
}

impl Zero for Symbolic {
    fn zero() -> Self {
        Self::of(0.0)
    }

    fn is_zero(&self) -> bool {
        unimplemented!("a step asked whether a number is 0, which is no mask")
    }
}

impl One for Symbolic {
    fn one() -> Self {
        Self::of(1.0)
    }
}

impl BitAnd for Truth {
    type Output = Self;

    fn bitand(self, other: Self) -> Self {
        Self(tape::push(Node::And(self.0, other.0)))
    }
}

impl BitOr for Truth {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(tape::push(Node::Or(self.0, other.0)))
    }
}

impl Not for Truth {
    type Output = Self;

    fn not(self) -> Self {
        Self(tape::push(Node::Not(self.0)))
    }
}

impl Mask for Truth {
    fn of(truth: bool) -> Self {
        Self(tape::push(Node::Truth(truth)))
    }

    fn lane(self, index: usize) -> bool {
        index == 0 && self.all()
    }

    fn all(self) -> bool {
        paths::decide(self)
    }
}

impl Signal for Symbolic {
    type Scalar = Self;

    fn splat(value: Self) -> Self {
        value
    }

    fn zip(self, other: Self, mut f: impl FnMut(Self, Self) -> Self) -> Self {
        f(self, other)
    }

    fn sum(self) -> Self {
        self
    }

    fn choose(mask: Truth, yes: Self, no: Self) -> Self {
        Self(tape::push(Node::Select(mask.0, yes.0, no.0)))
    }

    fn finite(self) -> Truth {
        Truth(tape::push(Node::Finite(self.0)))
    }
}

impl Scalar for Symbolic {
    type Mask = Truth;

    type Real = f64;

    const LANES: usize = 1;

    fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
        Self(tape::push(Node::Number(value(0).to_bits())))
    }

    fn lane(self, index: usize) -> f64 {
        if index == 0 { tape::with(|tape| tape.witnesses[self.0 as usize]) } else { f64::NAN }
    }

    fn from_reals(value: impl FnMut(usize) -> f64) -> Self {
        Self::from_lanes(value)
    }

    fn real(self, index: usize) -> f64 {
        self.lane(index)
    }

    fn smallest_normal() -> Self {
        Self(tape::push(Node::Limit(Limit::SmallestNormal)))
    }

    fn smallest_positive() -> Self {
        Self(tape::push(Node::Limit(Limit::SmallestPositive)))
    }

    fn largest() -> Self {
        Self(tape::push(Node::Limit(Limit::Largest)))
    }

    fn epsilon() -> Self {
        Self(tape::push(Node::Limit(Limit::Epsilon)))
    }

    fn sqrt(self) -> Self {
        Self(tape::push(Node::Root(self.0)))
    }

    fn below(self, other: Self) -> Truth {
        Truth(tape::push(Node::Below(self.0, other.0)))
    }
}
