//! Values of several runs side by side.

use lyapunov::Scalar;

/// One value for each lane: alike in kind, different in numbers. Lanes beyond the last value repeat it.
#[derive(Debug)]
pub struct Lanes<'a, A>(&'a [A]);

impl<A> Clone for Lanes<'_, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for Lanes<'_, A> {}

impl<'a, A> Lanes<'a, A> {
    /// The lanes of `values`, of which there is at least one.
    pub(crate) fn new(values: &'a [A]) -> Self {
        Self(values)
    }

    /// The values, without repetitions.
    pub(crate) fn values(self) -> &'a [A] {
        self.0
    }

    /// A value for what all have in common.
    pub(crate) fn common(self) -> &'a A {
        self.lane(0)
    }

    /// The value of a lane.
    pub(crate) fn lane(self, index: usize) -> &'a A {
        &self.0[index.min(self.0.len() - 1)]
    }

    /// One number of each value, lane by lane.
    pub(crate) fn each<T: Scalar, N: Into<f64>>(self, number: impl Fn(&A) -> N) -> T {
        numbers(&mut |lane| number(self.lane(lane)).into())
    }
}

/// The number of each lane, by a call through a table: a scene reads some hundred, each compiled for every scalar
/// otherwise.
pub(super) fn numbers<T: Scalar>(number: &mut dyn FnMut(usize) -> f64) -> T {
    T::from_lanes(number)
}
