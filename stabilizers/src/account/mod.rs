//! What becomes of stored credit.
//!
//! A loop that dissipates for a while has credit, and may then give that much energy away before a controller acts. How
//! much of it may be kept, and how long, is a choice; debts are never forgotten.

mod bounded;
mod contact_reset;
mod windowed;

pub use bounded::Bounded;
pub use contact_reset::ContactReset;
pub use windowed::Windowed;

use lyapunov_core::Scalar;

/// A stabilizer whose stored credit can be taken away.
pub trait Account<T: Scalar> {
    /// Forgets what is stored above `most` joules, which is not below 0; a debt stays.
    fn forget_above(&mut self, most: T);
}

impl<T: Scalar, S: Account<T> + ?Sized> Account<T> for &mut S {
    #[inline]
    fn forget_above(&mut self, most: T) {
        (**self).forget_above(most);
    }
}
