//! Interrupts, and what has to be tidied up after one.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;
use std::{process, thread};

use crate::commands::End;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// The number of things to tidy up.
static UNTIDY: AtomicUsize = AtomicUsize::new(0);

/// Time after an interrupt at which a command with nothing to tidy up is ended. It may be blocked where it cannot look for
/// interrupts: opening a pipe that nobody writes to, or writing to one that nobody reads.
const GRACE: Duration = Duration::from_millis(500);

/// Time between two looks at whether there is still something to tidy up.
const BREATH: Duration = Duration::from_millis(50);

/// Something to tidy up before the process may end: a temporary file, a folder that was made. A command that has one looks
/// for interrupts itself.
#[derive(Debug)]
pub(crate) struct Untidy(());

impl Untidy {
    pub(crate) fn new() -> Self {
        UNTIDY.fetch_add(1, Ordering::SeqCst);
        Self(())
    }
}

impl Drop for Untidy {
    fn drop(&mut self) {
        UNTIDY.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Whether the command was interrupted.
pub(crate) fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// Takes note of interrupts from here on, for [`is_interrupted`]. A signal that is ignored stays ignored, as `nohup` and
/// shells ask for.
///
/// It has to be called before any thread is started. Where it fails an interrupt ends the process at once; only the
/// tidying up is lost.
pub(crate) fn heed() {
    system::heed(interrupt);
}

/// Interrupts the command that runs in this process, and ends the process once nothing has to be tidied up: for a program that heeds
/// signals itself, as an interpreter does.
pub fn interrupt() {
    INTERRUPTED.store(true, Ordering::Relaxed);
    thread::sleep(GRACE);
    while UNTIDY.load(Ordering::SeqCst) > 0 {
        thread::sleep(BREATH);
    }
    process::exit(End::Interrupted.report().into());
}

#[cfg(target_os = "linux")]
mod system {
    use std::fs;
    use std::thread;

    use nix::sys::signal::{SigSet, Signal};

    /// Calls `interrupted` at the first of the signals that ask a process to end, except those that are ignored.
    pub(super) fn heed(interrupted: impl Fn() + Send + 'static) {
        let ignored = ignored().unwrap_or_default();
        let mut heeded = SigSet::empty();
        for signal in [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP] {
            if ignored & 1 << (signal as i32 - 1) == 0 {
                heeded.add(signal);
            }
        }
        // Without this signal the call that writes beyond the limit of a file's size returns an error, as for a full disk.
        let _ = SigSet::from(Signal::SIGXFSZ).thread_block();
        // Every thread that is started later inherits what is blocked, so that the one below gets the signals.
        if heeded.thread_block().is_err() {
            return;
        }
        let waiting = thread::Builder::new().name("interrupts".into()).spawn(move || {
            while heeded.wait().is_err() {}
            interrupted();
        });
        if waiting.is_err() {
            let _ = heeded.thread_unblock();
        }
    }

    /// The signals that are ignored, a bit for each. There is no safe call that asks for them.
    fn ignored() -> Option<u64> {
        let status = fs::read_to_string("/proc/self/status").ok()?;
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
        u64::from_str_radix(mask.trim(), 16).ok()
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    /// Calls `interrupted` at the first of the signals that ask a process to end; at none if one of them is ignored: they
    /// stay as they are then.
    pub(super) fn heed(interrupted: impl Fn() + Send + 'static) {
        let _ = ctrlc::try_set_handler(interrupted);
    }
}
