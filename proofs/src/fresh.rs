//! Fresh values: signals, parameters and memories about which nothing is known but what is asked of them.

use lyapunov_core::{Mask, Requirement, Scalar, Signal};
use nalgebra::SVector;

use crate::paths;
use crate::symbolic::{Symbolic, Truth};

/// Whether `value` meets `requirement`, as [`Requirement::check`] has it.
pub(crate) fn meets(requirement: Requirement, value: Symbolic) -> Truth {
    let not_below = |least: Symbolic| value.above(least) | equal(value, least);
    match requirement {
        Requirement::Positive => value.finite() & value.above(Symbolic::of(0.0)),
        Requirement::NonNegative => value.finite() & not_below(Symbolic::of(0.0)),
        Requirement::Limit => not_below(Symbolic::of(0.0)),
        Requirement::AboveZero => value.above(Symbolic::of(0.0)),
        Requirement::AtMost(most) => {
            value.below(Symbolic::of(most)) | equal(value, Symbolic::of(most))
        }
        Requirement::AtLeast(least) => value.finite() & not_below(Symbolic::of(least)),
        _ => value.finite(),
    }
}

/// Whether two numbers are the same and no NaN; an infinity is not.
pub(crate) fn equal(a: Symbolic, b: Symbolic) -> Truth {
    a.finite() & b.finite() & !a.below(b) & !b.below(a)
}

/// A parameter of which a constructor asks `requirement`; it sees `witness`.
pub(crate) fn parameter(name: &str, requirement: Requirement, witness: f64) -> Symbolic {
    let value = Symbolic::free(name, witness);
    paths::assume(meets(requirement, value));
    value
}

/// Signal of symbols.
pub(crate) trait Axes: Signal<Scalar = Symbolic> + Memory {
    fn called(name: &str, witness: f64) -> Self;

    fn axes(&self) -> Vec<Symbolic>;
}

impl Axes for Symbolic {
    fn called(name: &str, witness: f64) -> Self {
        Symbolic::free(name, witness)
    }

    fn axes(&self) -> Vec<Symbolic> {
        vec![*self]
    }
}

impl<const N: usize> Axes for SVector<Symbolic, N> {
    fn called(name: &str, witness: f64) -> Self {
        Self::from_fn(|axis, _| Symbolic::free(&format!("{name}.{axis}"), witness))
    }

    fn axes(&self) -> Vec<Symbolic> {
        self.iter().copied().collect()
    }
}

/// Memory of a stabilizer.
pub(crate) trait Memory {
    fn fresh(name: &str) -> Self;

    /// Whether all of it is finite.
    fn sound(&self) -> Truth;
}

impl Memory for () {
    fn fresh(_name: &str) {}

    fn sound(&self) -> Truth {
        Truth::of(true)
    }
}

impl Memory for Symbolic {
    fn fresh(name: &str) -> Self {
        Self::free(name, 0.0)
    }

    fn sound(&self) -> Truth {
        self.finite()
    }
}

impl<M: Memory + nalgebra::Scalar, const N: usize> Memory for SVector<M, N> {
    fn fresh(name: &str) -> Self {
        Self::from_fn(|axis, _| M::fresh(&format!("{name}.{axis}")))
    }

    fn sound(&self) -> Truth {
        self.iter().fold(Truth::of(true), |all, axis| all & axis.sound())
    }
}

/// Slots are numbered from 0 to 7; all of them differ by their number only, so the first and the last are tried.
impl Memory for usize {
    fn fresh(_name: &str) -> Self {
        [0, 7][paths::choose(2)]
    }

    fn sound(&self) -> Truth {
        Truth::of(*self < 8)
    }
}

/// Ticks that are left: none, or some.
impl Memory for u32 {
    fn fresh(_name: &str) -> Self {
        paths::choose(2) as Self
    }

    fn sound(&self) -> Truth {
        Truth::of(true)
    }
}

impl<M: Memory> Memory for Option<M> {
    fn fresh(name: &str) -> Self {
        [None, Some(M::fresh(name))].into_iter().nth(paths::choose(2)).flatten()
    }

    fn sound(&self) -> Truth {
        self.as_ref().map_or(Truth::of(true), Memory::sound)
    }
}

macro_rules! tuple {
    ($($of:ident $index:tt),+) => {
        impl<$($of: Memory),+> Memory for ($($of,)+) {
            fn fresh(name: &str) -> Self {
                ($($of::fresh(&format!("{name}.{}", $index)),)+)
            }

            fn sound(&self) -> Truth {
                Truth::of(true) $(& self.$index.sound())+
            }
        }
    };
}

tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
