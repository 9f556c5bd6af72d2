//! What `lyapunov compare` takes, and what it tells of files that are no scenes.
//!
//! Each kind of file has a room of its own and a comparison with rows and columns of its own. How a comparison is run,
//! shown and written is the same for all of them, and is here.

mod compared;
mod sheet;
mod subject;

pub use compared::{CompareError, Compared, Watch};
pub use sheet::{Sheet, page};
pub use subject::Subject;
