//! Runs of many scenes, judged and measured: on lanes where they are alike, and else one by one.

mod alike;
mod loops;
mod meters;
mod outcome;

pub(crate) use alike::has_lanes;
pub(crate) use loops::{Judged, Runs};
pub(crate) use meters::{AllMeasures, Instant, Meter, Metering, Meters, Ran};
pub use outcome::{Measure, Measures, Outcome};
