//! Maps of the verdicts over any two numbers of a scene, under several stabilizers.

mod axis;
mod bounds;
mod checkpoint;
mod document;
mod grid;
mod kernel;
mod merge;
mod outcome;
mod picture;
mod rendered;
mod report;
mod run;
mod shard;
mod single;
mod survey;
mod table;
mod varied;
mod vary;

pub use crate::simulate::family::BasicName;
pub use axis::{Axis, AxisError, Spacing};
pub use bounds::{Bounds, OverExact};
pub use checkpoint::{Checkpoint, CheckpointError};
pub use document::{Computation, document};
pub use grid::{Grid, GridError};
pub use kernel::{Instructions, Kernel, Lanes};
pub use merge::{MergeError, merge};
pub use outcome::{Measure, Measures, Outcome};
pub use picture::{NamedFigure, figures};
pub use rendered::Rendered;
pub use report::{areas, page};
pub use run::{Method, Run, RunError, TakeOutcomes, Workload};
pub use shard::{Shard, ShardError};
pub use survey::{Area, Reach, Survey};
pub use table::{Rows, TableError, TableHeader};
pub use vary::VaryError;
