//! The listings of the book and of other pages, each a documentation test.

#[doc = include_str!("../chapters/candidate.md")]
pub mod candidate {}

#[doc = include_str!("../chapters/ledger.md")]
pub mod ledger {}

#[doc = include_str!("../chapters/port.md")]
pub mod port {}

#[doc = include_str!("../chapters/your-loop.md")]
pub mod your_loop {}

#[doc = include_str!("../../any-plant.md")]
pub mod any_plant {}

#[doc = include_str!("../../effects/dropout.md")]
pub mod dropout {}

#[doc = include_str!("../../effects/filter.md")]
pub mod filter {}

#[doc = include_str!("../../integrators.md")]
pub mod integrators {}

#[doc = include_str!("../../effects/noise.md")]
pub mod noise {}

#[doc = include_str!("../../order.md")]
pub mod order {}

#[doc = include_str!("../../poses.md")]
pub mod poses {}
