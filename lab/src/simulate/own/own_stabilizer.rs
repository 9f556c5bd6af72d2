//! An own stabilizer, as the lab has to know it.

use lyapunov::{ParameterError, Signal, Stabilizer};

use crate::files::scene::own::{Loop, OwnNumber, Promise};

/// A stabilizer of your own: its name, its numbers, what it promises, and how one is made.
pub trait OwnStabilizer: 'static {
    /// The name on the command line, in scenes (`[stabilizer.NAME]`) and in every table and file: small letters and digits,
    /// joined by dashes.
    const NAME: &'static str;

    /// The numbers of its table, eight at most.
    const NUMBERS: &'static [OwnNumber] = &[];

    /// Its promise, to which `hard` holds it.
    const PROMISE: Promise;

    /// The stabilizer for a loop: mass, period, limit, delay, the scene, and its own numbers.
    ///
    /// # Errors
    /// A number out of the range of the scalar, alone or with others. A number that is wrong by itself is refused before,
    /// by what its [`OwnNumber`] allows.
    fn make<V: Signal>(on: &Loop<'_>) -> Result<impl Stabilizer<V> + 'static, ParameterError>;
}
