//! The shipped scenes: each runs to its end and shows what its comment says, and editors can check it.

mod effects;
mod environments;
mod hand;
pub(crate) mod rows;
mod schema;
mod table;
