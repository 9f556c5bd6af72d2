//! Reset of the account by free motion.

/// Whether free motion is forgotten.
pub trait Reset {
    /// It is.
    const FORGETS: bool;
}

/// Where no force applied nothing is kept: the published reset.
#[derive(Clone, Copy, Debug)]
pub struct FreshContact;

impl Reset for FreshContact {
    const FORGETS: bool = true;
}

/// What free motion dissipated stays on the account.
#[derive(Clone, Copy, Debug)]
pub struct KeptCredit;

impl Reset for KeptCredit {
    const FORGETS: bool = false;
}
