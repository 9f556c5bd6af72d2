//! Maps of the verdicts over any two numbers of a scene, and sweeps over one, under several stabilizers.

mod axis;
mod bounds;
mod checkpoint;
mod document;
mod grid;
mod kernel;
mod merge;
mod picture;
mod refine;
mod rendered;
mod report;
mod run;
mod run_error;
mod shard;
mod survey;
mod sweep;
mod table;
mod table_error;
mod varied;
mod vary;
mod workload;

pub use crate::measure::runs::{Measure, Measures, Outcome};
pub use crate::simulate::Instructions;
pub use crate::simulate::family::BasicName;
pub use axis::{Axis, AxisError, Spacing};
pub use bounds::{Bounds, OverExact};
pub use checkpoint::{Checkpoint, CheckpointError, table_name};
pub use document::{Computation, document};
pub use grid::{Grid, GridError};
pub use kernel::{Ends, GoOn, Kernel, Lanes, Loops, Numbers, Recipe};
pub use merge::{MergeError, merge};

pub use picture::{NamedFigure, figure_names, figures};
pub use refine::{Edge, Refined, Shares, Side};
pub use rendered::Rendered;
pub use report::{areas, page};
pub use run::{Method, Run, TakeOutcomes};
pub use run_error::RunError;
pub use shard::{Shard, ShardError};
pub use survey::{Area, Reach, Survey};
pub use sweep::{Point, Sweep, SweepPlan};
pub use table::{Rows, TableHeader};
pub use table_error::TableError;
pub use vary::VaryError;
pub use workload::Workload;
