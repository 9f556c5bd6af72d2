//! Limits on stored credit.
//!
//! A loop that dissipates for a while stores credit, and may then give that much energy away before the controller
//! acts. How much credit is kept, and how long, is a choice; debts never lapse.

mod bounded_credit;
mod contact_reset;
mod windowed_credit;

pub use bounded_credit::BoundedCredit;
pub use contact_reset::ContactReset;
pub use windowed_credit::WindowedCredit;

use lyapunov_core::Scalar;

/// Stabilizer whose stored credit can be limited from outside.
pub trait LimitCredit<T: Scalar> {
    /// Forfeits the stored credit above `most` joules, which is not below 0; a debt stays.
    fn limit_credit(&mut self, most: T);
}

impl<T: Scalar, S: LimitCredit<T> + ?Sized> LimitCredit<T> for &mut S {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        (**self).limit_credit(most);
    }
}

#[cfg(feature = "alloc")]
impl<T: Scalar, S: LimitCredit<T> + ?Sized> LimitCredit<T> for alloc::boxed::Box<S> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        (**self).limit_credit(most);
    }
}

/// Limit on the credit of a stabilizer that is the credit of one of its fields.
macro_rules! limits_credit {
    (impl[$($parameters:tt)*] $type:ty, in $scalar:ty, of $($field:ident).+) => {
        impl<$($parameters)*> $crate::LimitCredit<$scalar> for $type {
            #[inline]
            fn limit_credit(&mut self, most: $scalar) {
                self.$($field).+.limit_credit(most);
            }
        }
    };
}

pub(crate) use limits_credit;
