//! The study against figures that are known.
