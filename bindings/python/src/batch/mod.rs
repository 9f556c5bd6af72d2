//! Batches: many loops at once, on lanes and all cores, in arrays of NumPy that are not copied.

mod arrays;
pub(crate) mod closed_loop;
mod corrections;
mod lanes;
mod loops;
pub(crate) mod replay;

pub(crate) use corrections::Corrections;
pub(crate) use loops::Batch;
