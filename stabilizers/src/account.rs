//! Accounts: the observed energy of a stabilizer, read and changed between ticks.

use lyapunov_core::{Accumulator, Ledger, ParameterError, Requirement, Scalar, Work};

/// Stabilizer whose observed energy `L` can be read and changed between ticks.
///
/// What a change does to the promise that `L ≥ 0` bounds the energy which the port gives away:
///
/// | change | the port may from then on give, beyond what it absorbs |
/// |---|---|
/// | [`reset`](Self::reset) with credit in `L` | nothing: credit is forfeited, the bound is as at the start |
/// | [`reset`](Self::reset) with a debt | as at the start; the debt was given away for good |
/// | [`grant`](Self::grant) of `E` | `E` more: credit that nobody earned, and therefore has a name of its own |
/// | [`owe`](Self::owe) of `D` | `D` less: a debt carried over, from another controller or an earlier run |
///
/// A force that was given before acts on. Where a law bounds a force by what stands on its account, as
/// [`EnergyBounding`](crate::EnergyBounding) and a delayed [`ForceBounding`](crate::ForceBounding) do, a force that is held or under way
/// may still take what was there before a reset, which shows as a debt.
///
/// There is no way to set `L` to a number, since that would be one of these without saying which. Adaptors hand the
/// calls on to the stabilizer inside. A [window of credit](crate::WindowedCredit) counts a grant or a debt as a tick.
///
/// ```
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{Account, DampingLimit, Popc};
/// let mut popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// let tick = HeldTick { period: 1e-3, position: 0.0, velocity: 0.0, displacement: 1e-4, applied: 2.0 };
/// popc.stabilize(&tick.sample(), 2.0);
/// assert_eq!(popc.observed_energy(), 2e-4);
/// popc.owe(5e-4)?; // what the last run left behind
/// assert!(popc.observed_energy() < 0.0);
/// assert!(popc.owe(f64::NAN).is_err() && popc.grant(-1.0).is_err());
/// popc.reset();
/// assert_eq!(popc.observed_energy(), 0.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub trait Account<T: Scalar> {
    /// The observed energy `L`, J.
    fn observed_energy(&self) -> T;

    /// Sets `L` to 0: credit is forfeited, a debt forgiven.
    fn reset(&mut self);

    /// Adds `energy` joules of credit that were not absorbed.
    ///
    /// # Errors
    /// `energy` below 0, infinite or NaN, or more than the sum has room for; nothing is changed.
    fn grant(&mut self, energy: T) -> Result<(), ParameterError>;

    /// Adds a `debt` of as many joules.
    ///
    /// # Errors
    /// `debt` below 0, infinite or NaN, or more than the sum has room for; nothing is changed.
    fn owe(&mut self, debt: T) -> Result<(), ParameterError>;
}

/// `sum` with `energy` joules of credit more.
pub(crate) fn granted<T: Scalar, A>(
    sum: A,
    energy: T,
    book: impl FnOnce(&mut A, T) -> T::Mask,
) -> Result<A, ParameterError> {
    booked("granted credit", energy, sum, book)
}

/// `sum` with as many joules of `debt` more.
pub(crate) fn owed<T: Scalar, A>(
    sum: A,
    debt: T,
    book: impl FnOnce(&mut A, T) -> T::Mask,
) -> Result<A, ParameterError> {
    booked("debt carried over", debt, sum, |sum, debt| book(sum, -debt))
}

/// `sum` with `energy` joules booked; the error names `parameter`, also where `book` finds no room for them.
pub(crate) fn booked<T: Scalar, A>(
    parameter: &'static str,
    energy: T,
    mut sum: A,
    book: impl FnOnce(&mut A, T) -> T::Mask,
) -> Result<A, ParameterError> {
    let energy = Requirement::NonNegative.check(parameter, energy)?;
    let booked = book(&mut sum, energy);
    Requirement::InRange.require(parameter, energy, booked).map(|()| sum)
}

impl<T: Scalar, W: Work, A: Accumulator<T>> Account<T> for Ledger<W, A> {
    fn observed_energy(&self) -> T {
        self.energy()
    }

    fn reset(&mut self) {
        self.clear();
    }

    fn grant(&mut self, energy: T) -> Result<(), ParameterError> {
        *self = granted(*self, energy, Self::credit)?;
        Ok(())
    }

    fn owe(&mut self, debt: T) -> Result<(), ParameterError> {
        *self = owed(*self, debt, Self::credit)?;
        Ok(())
    }
}

/// Account of a pointer to a stabilizer.
macro_rules! account_behind {
    ($($(#[$only:meta])? $pointer:ty),+) => {$(
        $(#[$only])?
        impl<T: Scalar, S: Account<T> + ?Sized> Account<T> for $pointer {
            fn observed_energy(&self) -> T {
                (**self).observed_energy()
            }

            fn reset(&mut self) {
                (**self).reset();
            }

            fn grant(&mut self, energy: T) -> Result<(), ParameterError> {
                (**self).grant(energy)
            }

            fn owe(&mut self, debt: T) -> Result<(), ParameterError> {
                (**self).owe(debt)
            }
        }
    )+};
}

account_behind!(&mut S, #[cfg(feature = "alloc")] alloc::boxed::Box<S>);

/// Account of a stabilizer that is the account of one of its fields.
macro_rules! account {
    (impl[$($parameters:tt)*] $type:ty, in $scalar:ty, is $($field:ident).+ $(, where $inner:ty)?) => {
        impl<$($parameters)*> $crate::Account<$scalar> for $type
        $(where $inner: $crate::Account<$scalar>)?
        {
            fn observed_energy(&self) -> $scalar {
                $crate::Account::<$scalar>::observed_energy(&self.$($field).+)
            }

            fn reset(&mut self) {
                $crate::Account::<$scalar>::reset(&mut self.$($field).+);
            }

            fn grant(&mut self, energy: $scalar) -> Result<(), lyapunov_core::ParameterError> {
                $crate::Account::<$scalar>::grant(&mut self.$($field).+, energy)
            }

            fn owe(&mut self, debt: $scalar) -> Result<(), lyapunov_core::ParameterError> {
                $crate::Account::<$scalar>::owe(&mut self.$($field).+, debt)
            }
        }
    };
}

/// Account of a stabilizer that keeps its energy in an accumulator.
macro_rules! account_in_sum {
    (impl[$($parameters:tt)*] $type:ty, in $scalar:ty, is $field:ident) => {
        impl<$($parameters)*> $crate::Account<$scalar> for $type {
            fn observed_energy(&self) -> $scalar {
                self.$field.value()
            }

            fn reset(&mut self) {
                self.$field.clear();
            }

            fn grant(&mut self, energy: $scalar) -> Result<(), lyapunov_core::ParameterError> {
                self.$field = $crate::account::granted(self.$field, energy, Accumulator::book)?;
                Ok(())
            }

            fn owe(&mut self, debt: $scalar) -> Result<(), lyapunov_core::ParameterError> {
                self.$field = $crate::account::owed(self.$field, debt, Accumulator::book)?;
                Ok(())
            }
        }
    };
}

/// Adaptor that lends the stabilizer inside, with its account.
macro_rules! lends {
    (impl[$($parameters:tt)*] $type:ty, of $inner:ident, in $scalar:ty) => {
        impl<$($parameters)*> $type {
            /// The stabilizer inside.
            pub fn stabilizer(&self) -> &$inner {
                &self.stabilizer
            }

            /// The stabilizer inside, to be changed between ticks.
            pub fn stabilizer_mut(&mut self) -> &mut $inner {
                &mut self.stabilizer
            }
        }

        impl<$($parameters)*> $crate::StabilizerExt for $type {}

        $crate::account::account!(
            impl[$($parameters)*] $type, in $scalar, is stabilizer, where $inner
        );
    };
}

pub(crate) use {account, account_in_sum, lends};
