//! What becomes of stored credit.
//!
//! A loop that dissipates for a while has credit, and may then give that much energy away before a controller acts. How
//! much of it may be kept, and how long, is a choice; debts are never forgotten.

mod bounded_credit;
mod contact_reset;
mod windowed_credit;

pub use bounded_credit::BoundedCredit;
pub use contact_reset::ContactReset;
pub use windowed_credit::WindowedCredit;

use lyapunov_core::Scalar;

/// A stabilizer whose stored credit can be taken away.
pub trait LimitCredit<T: Scalar> {
    /// Forgets what is stored above `most` joules, which is not below 0; a debt stays.
    fn limit_credit(&mut self, most: T);
}

impl<T: Scalar, S: LimitCredit<T> + ?Sized> LimitCredit<T> for &mut S {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        (**self).limit_credit(most);
    }
}
