//! Work on a thread of its own, so that an interrupt need not wait for its end.

use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use super::End;

/// Time between two checks for interrupts.
const BREATH: Duration = Duration::from_millis(50);

/// The result of `work`; after an interrupt the process ends without it.
pub(super) fn apart<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<T, End> {
    let (sender, results) = sync_channel(1);
    thread::spawn(move || {
        // After an interrupt the receiver is gone.
        let _ = sender.send(work());
    });
    loop {
        match results.recv_timeout(BREATH) {
            Ok(result) => return Ok(result),
            Err(RecvTimeoutError::Timeout) => End::if_interrupted()?,
            Err(RecvTimeoutError::Disconnected) => return Err(End::internal("the work broke off")),
        }
    }
}
