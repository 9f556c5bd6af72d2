//! Threads of a map or a sweep.

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::run_error::RunError;

/// The most threads: more than any machine has cores for.
const MOST: usize = 1024;

/// A pool for work in `parts`: of `asked` threads, but none without a part, or of as many as there are cores.
///
/// # Errors
/// More threads than [`MOST`]; threads that cannot be started.
pub(super) fn pool(asked: Option<usize>, parts: u64) -> Result<ThreadPool, RunError> {
    let count = asked.unwrap_or_default();
    if count > MOST {
        return Err(RunError::Threads(format!("{count} are more than {MOST}")));
    }
    let useful = count.min(usize::try_from(parts).unwrap_or(usize::MAX));
    let pool = ThreadPoolBuilder::new().num_threads(useful).build();
    pool.map_err(|error| RunError::Threads(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_are_as_many_as_there_is_work_for() {
        let count = |asked, parts| pool(Some(asked), parts).map(|pool| pool.current_num_threads());
        assert_eq!(count(3, 100).unwrap(), 3);
        assert_eq!(count(MOST, 4).unwrap(), 4);
        let refused = count(100_000, 4).unwrap_err().to_string();
        assert_eq!(
            refused,
            "threads cannot be started: 100000 are more than 1024\n  = give fewer threads"
        );
    }
}
