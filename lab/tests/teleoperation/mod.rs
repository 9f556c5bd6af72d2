//! Teleoperators from files: what they come to, and what is refused.

mod bad;
mod hand;
mod ledger;
mod shipped;
mod springs;
