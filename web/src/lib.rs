//! The lab of lyapunov for one static page: loops, runs, maps and explanations behind plain calls.

mod exchange;
mod explain;
mod live;
mod map;
mod observe;
mod run;
mod scene;
