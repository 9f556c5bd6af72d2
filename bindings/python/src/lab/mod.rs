//! The lab: scenes, and a function for each study.

mod accuracy;
mod bound;
mod columns;
mod compare;
mod ensemble;
mod explain;
mod map;
mod observe;
mod run;
mod scene;
mod shard;
mod told;
mod tune;
mod work;

pub(crate) use accuracy::accuracy;
pub(crate) use bound::bound;
pub(crate) use compare::compare;
pub(crate) use ensemble::ensemble;
pub(crate) use explain::explain;
pub(crate) use map::map;
pub(crate) use observe::observe;
pub(crate) use run::run;
pub(crate) use scene::Scene;
pub(crate) use shard::{map_merge, map_shard, shard_head};
pub(crate) use told::Told;
pub(crate) use tune::tune;
pub(crate) use work::pool;
