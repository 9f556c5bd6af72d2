//! The lab: scenes, and a function for each study.

pub(crate) mod accuracy;
pub(crate) mod bound;
mod columns;
pub(crate) mod compare;
pub(crate) mod ensemble;
pub(crate) mod explain;
pub(crate) mod map;
pub(crate) mod observe;
mod rows;
pub(crate) mod run;
mod scene;
pub(crate) mod scenes;
mod shard;
mod tables;
mod told;
pub(crate) mod tune;
pub(crate) mod units;
mod work;

pub(crate) use scene::Scene;
pub(crate) use shard::{MapMerge, map_cells, map_shard, shard_head};
pub(crate) use told::Told;
pub(crate) use work::{Fault, pool, wait_here};
