//! The lab of lyapunov for one static page: loops, runs, maps and explanations behind plain calls.

mod exchange;
mod explain;
mod live;
mod map;
mod observe;
mod run;
mod scene;

/// A third of the default allocator's code; all of it is sent with the page.
#[global_allocator]
static ALLOCATOR: rlsf::SmallGlobalTlsf = rlsf::SmallGlobalTlsf::new();
