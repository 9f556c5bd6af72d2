//! Work on a thread of its own.

use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use super::End;

/// Time between two looks for interrupts.
const BREATH: Duration = Duration::from_millis(50);

/// The result of `work`; an interrupt ends the wait at once, and the work goes on unheard.
///
/// # Errors
/// An interrupt; work that broke off.
pub(super) fn apart<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<T, End> {
    let (sender, results) = sync_channel(1);
    // After an interrupt the receiver is gone.
    thread::spawn(move || drop(sender.send(work())));
    loop {
        match results.recv_timeout(BREATH) {
            Ok(result) => return Ok(result),
            Err(RecvTimeoutError::Timeout) => End::if_interrupted()?,
            Err(RecvTimeoutError::Disconnected) => return Err(End::internal("the work broke off")),
        }
    }
}
