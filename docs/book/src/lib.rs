//! The listings of the book, each a documentation test.

#[doc = include_str!("../chapters/candidate.md")]
pub mod candidate {}

#[doc = include_str!("../chapters/ledger.md")]
pub mod ledger {}

#[doc = include_str!("../chapters/port.md")]
pub mod port {}

#[doc = include_str!("../chapters/your-loop.md")]
pub mod your_loop {}
