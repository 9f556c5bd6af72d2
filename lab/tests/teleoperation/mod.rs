//! Teleoperators from files: their results, and the files that are refused.

mod bad;
mod found;
mod hand;
mod ledger;
mod page;
pub(crate) mod shipped;
mod springs;
