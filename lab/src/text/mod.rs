//! The ground floor: text that any other floor shows, of which nothing knows what it is about.

pub(crate) mod excerpt;
pub(crate) mod numbers;
pub(crate) mod suggest;
pub(crate) mod words;
