//! Reset of the account by free motion.

/// Reset of the account by free motion, or none.
pub trait Reset {
    /// Whether free motion is forgotten.
    const FORGETS: bool;
}

/// Reset of the account where no force acted, as published.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FreshContact;

impl Reset for FreshContact {
    const FORGETS: bool = true;
}

/// Account that keeps the energy dissipated in free motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeptCredit;

impl Reset for KeptCredit {
    const FORGETS: bool = false;
}
