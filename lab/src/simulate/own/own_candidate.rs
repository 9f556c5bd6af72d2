//! An own candidate, as the lab has to know it.

use lyapunov::{LyapunovCandidate, ParameterError, Signal};

use crate::files::scene::own::{Loop, OwnNumber, Promise};

/// A candidate of your own: LOLC watches it, under the name `lolc-NAME` and with a `damping_cap` as LOLC has it.
pub trait OwnCandidate: 'static {
    /// The name behind `lolc-`: small letters and digits, joined by dashes.
    const NAME: &'static str;

    /// The numbers of its table besides `damping_cap`, seven at most.
    const NUMBERS: &'static [OwnNumber] = &[];

    /// The promise of LOLC with it. [`Promise::Serves`] promises the bounds of `hard`: for a candidate that credits nothing
    /// that may not have been dissipated. The sum itself is not recomputed, as nobody else knows the credit.
    const PROMISE: Promise = Promise::Damps;

    /// The candidate for a loop.
    ///
    /// # Errors
    /// A number out of the range of the scalar, alone or with others.
    fn make<V: Signal>(
        on: &Loop<'_>,
    ) -> Result<impl LyapunovCandidate<V> + 'static, ParameterError>;
}
