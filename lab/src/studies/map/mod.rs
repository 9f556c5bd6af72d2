//! Stability maps: any two numbers of a scene on a grid, under several stabilizers.

mod axis;
mod bounds;
mod checkpoint;
mod document;
mod grid;
mod kernel;
mod merge;
mod outcome;
mod picture;
mod report;
mod run;
mod shard;
mod single;
mod survey;
mod table;
mod vary;

pub use crate::simulate::family::BasicName;
pub use axis::{Axis, NoAxis, Spacing};
pub use bounds::{Bounds, OverExact};
pub use checkpoint::{Checkpoint, CheckpointError};
pub use document::{Computation, document};
pub use grid::{Grid, GridError};
pub use kernel::{Instructions, Kernel, Lanes};
pub use merge::{MergeError, merge};
pub use outcome::{Measure, Measures, Outcome};
pub use picture::{Drawn, figures};
pub use report::{areas, page};
pub use run::{Effort, Method, Put, Run, RunError};
pub use shard::{NoShard, Shard};
pub use survey::{Area, Reach, Survey};
pub use table::{Head, Rows, TableError};
pub use vary::VaryError;
