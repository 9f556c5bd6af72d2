//! Windowed credit: credit that expires.

use lyapunov_core::lanes::apart;
use lyapunov_core::{Accumulator, ParameterError, Requirement, Scalar, Snapshot};
use nalgebra::SVector;

/// Sum whose credit expires: `L(n) = min(L(n−1), W(n)) + e(n)`, with `W(n)` the sum of the earlier positive `e` in the
/// last `N` slots.
///
/// Debts are paid from the oldest credit first, so the minimum is exactly the credit that is neither spent nor too old.
/// Only credit expires: a debt stands until it is paid. A slot is a number of ticks; with one tick per slot
/// ([`Accumulator::zero`]) the window is `N` ticks, with `k` ([`WindowedCredit::of_ticks`]) it is between `(N − 1) k`
/// and `N k`. `W` is summed anew on every tick, since a running sum would gather rounding errors for a year: a step
/// costs `N` additions, so take few slots.
///
/// ```
/// use lyapunov_core::{Accumulator, Plain};
/// use lyapunov_stabilizers::WindowedCredit;
/// let mut sum = WindowedCredit::<f64, Plain<f64>, 3>::zero();
/// sum.add(1.0);
/// sum.add(-0.25); // paid from the 1 J
/// sum.add(0.0);
/// assert_eq!(sum.value(), 0.75);
/// sum.add(0.5); // the 1 J is more than three ticks old now
/// assert_eq!(sum.value(), 0.5);
/// sum.add(-2.0);
/// assert_eq!(sum.value(), -1.5);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct WindowedCredit<T, A, const N: usize> {
    sum: A,
    slots: [T; N],
    slot: usize,
    ticks: u32,
    left: u32,
}

impl<T: Scalar, A: Accumulator<T>, const N: usize> WindowedCredit<T, A, N> {
    /// The empty sum, over `N` slots of `ticks` ticks each.
    ///
    /// # Errors
    /// `ticks` is 0.
    pub fn of_ticks(ticks: u32) -> Result<Self, ParameterError> {
        Requirement::AtLeast(1.0).check("window ticks", f64::from(ticks))?;
        let slots = [T::of(0.0); N];
        Ok(Self { sum: A::zero(), slots, slot: 0, ticks, left: ticks })
    }

    /// Drops the expired credit, and turns to the slot of this tick.
    #[inline(always)]
    fn expire(&mut self) {
        let zero = T::of(0.0);
        if self.left == 0 {
            self.left = self.ticks;
            self.slot = if self.slot + 1 < N { self.slot + 1 } else { 0 };
            if let Some(oldest) = self.slots.get_mut(self.slot) {
                *oldest = zero;
            }
        }
        self.left -= 1;
        let mut window = zero;
        for slot in &self.slots {
            apart::<T>();
            window += *slot;
        }
        self.sum.lower(window);
    }

    /// Enters `term` in the slot of this tick.
    #[inline(always)]
    fn enter(&mut self, term: T) {
        if let Some(slot) = self.slots.get_mut(self.slot) {
            *slot = (*slot + term.larger(T::of(0.0))).smaller(T::largest());
        }
    }
}

impl<T: Scalar, A: Accumulator<T>, const N: usize> Accumulator<T> for WindowedCredit<T, A, N> {
    #[inline(always)]
    fn zero() -> Self {
        Self { sum: A::zero(), slots: [T::of(0.0); N], slot: 0, ticks: 1, left: 1 }
    }

    #[inline(always)]
    fn add(&mut self, term: T) {
        self.expire();
        self.enter(term);
        self.sum.add(term);
    }

    #[inline(always)]
    fn add_and_raise(&mut self, term: T, allowance: T) -> T {
        self.expire();
        self.enter(term);
        self.sum.add_and_raise(term, allowance)
    }

    #[inline(always)]
    fn lower(&mut self, most: T) {
        self.sum.lower(most);
    }

    fn clear(&mut self) {
        let Self { ticks, .. } = *self;
        *self = Self { ticks, left: ticks, ..Self::zero() };
    }

    #[inline(always)]
    fn value(&self) -> T {
        self.sum.value()
    }

    // Lanes share their slot: both are of the same tick.
    #[inline(always)]
    fn choose(mask: T::Mask, mut yes: Self, no: Self) -> Self {
        yes.sum = A::choose(mask, yes.sum, no.sum);
        for (slot, other) in yes.slots.iter_mut().zip(no.slots) {
            apart::<T>();
            *slot = T::choose(mask, *slot, other);
        }
        yes
    }

    #[inline(always)]
    fn book(&mut self, term: T) -> T::Mask {
        // A tick whose term is left out is a tick as well: credit expires.
        self.expire();
        let booked = self.sum.book(term);
        self.enter(T::choose(booked, term, T::of(0.0)));
        booked
    }
}

impl<T: Scalar, A: Snapshot, const N: usize> Snapshot for WindowedCredit<T, A, N> {
    /// The sum, the credit in the slots, J, the current slot, and the ticks left in it.
    type State = (A::State, SVector<T, N>, usize, u32);

    fn state(&self) -> Self::State {
        (self.sum.state(), SVector::from(self.slots), self.slot, self.left)
    }

    fn restored(self, (sum, slots, slot, left): Self::State) -> Result<Self, ParameterError> {
        let slots = Requirement::NonNegative.check_axes("stored credit", slots)?.into();
        Requirement::AtMost(N.saturating_sub(1) as f64).check("stored slot", slot as f64)?;
        Requirement::AtMost(f64::from(self.ticks)).check("stored ticks", f64::from(left))?;
        Ok(Self { sum: self.sum.restored(sum)?, slots, slot, left, ..self })
    }
}
