//! Batches: many loops at once, on lanes and all cores, in arrays of NumPy that are not copied.

mod arrays;
mod closed_loop;
mod corrections;
mod lanes;
mod loops;
mod replay;

pub(crate) use closed_loop::closed_loop;
pub(crate) use corrections::Corrections;
pub(crate) use loops::Batch;
pub(crate) use replay::replay;
