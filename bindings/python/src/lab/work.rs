//! Work of the lab on threads of its own, with progress and interrupts for the thread that waits.

use std::fmt::Display;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::errors;

/// Time between two looks at signals.
const BREATH: Duration = Duration::from_millis(50);

/// The longest time to wait for work that was told to stop.
const PATIENCE: Duration = Duration::from_secs(2);

/// Why work ended without a result.
#[derive(Debug)]
pub(crate) enum Fault {
    Stopped,
    Input(String),
    Internal(String),
    Raised(PyErr),
}

impl Fault {
    pub(crate) fn input(error: impl Display) -> Self {
        Self::Input(error.to_string())
    }

    pub(crate) fn internal(error: impl Display) -> Self {
        Self::Internal(error.to_string())
    }
}

impl From<PyErr> for Fault {
    fn from(error: PyErr) -> Self {
        Self::Raised(error)
    }
}

/// How far work is, and whether it has to end.
#[derive(Debug)]
pub(crate) struct Watched {
    stopped: Arc<AtomicBool>,
    done: AtomicU64,
    total: u64,
}

impl Watched {
    fn of(total: u64) -> Self {
        Self { stopped: Arc::default(), done: AtomicU64::new(0), total }
    }

    /// Whether it has to end, shared with what may live longer than the work.
    pub(crate) fn stop(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.stopped)
    }

    /// Adds to what is done, and says whether to go on.
    pub(crate) fn add(&self, more: u64) -> ControlFlow<()> {
        self.done.fetch_add(more, Ordering::Relaxed);
        self.go_on()
    }

    /// Says that `share` of all is done, and whether to go on.
    pub(crate) fn reach(&self, share: f64) -> ControlFlow<()> {
        self.done.store((share * self.total as f64) as u64, Ordering::Relaxed);
        self.go_on()
    }

    /// Whether to go on.
    pub(crate) fn go_on(&self) -> ControlFlow<()> {
        match self.stopped.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }
}

/// The result of `work`, of which `total` is to be done; `progress(done, total)` is called now and then.
///
/// The work runs without the interpreter's lock. An interrupt raises KeyboardInterrupt, and the work ends where it next looks.
pub(crate) fn wait<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    total: u64,
    work: impl FnOnce(&Watched) -> Result<T, Fault> + Send + 'static,
) -> PyResult<T> {
    let pool = pool()?;
    wait_asking(py, progress, total, move |watched| pool.install(|| work(watched)))
}

/// The same of work that may ask Python, which runs on a thread of its own.
///
/// Python may call the lab from there, or wait for a thread that calls it. Such work holds no thread of the pool: if each held
/// one, none might be left for the calls that they wait for.
pub(crate) fn wait_asking<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    total: u64,
    work: impl FnOnce(&Watched) -> Result<T, Fault> + Send + 'static,
) -> PyResult<T> {
    let watched = Arc::new(Watched::of(total));
    let (sender, mut results) = channel();
    let shared = Arc::clone(&watched);
    thread::spawn(move || {
        // The receiver is gone where the waiting thread was interrupted.
        let _ = sender.send(done(|| work(&shared)));
    });
    let told = |done: u64| progress.map_or(Ok(()), |it| it.call1((done, total)).map(drop));
    loop {
        let waiting = &mut results;
        match py.detach(move || waiting.recv_timeout(BREATH)) {
            Ok(Ok(result)) => return told(total).map(|()| result),
            Ok(Err(fault)) => return Err(raised(fault)),
            Err(RecvTimeoutError::Disconnected) => return Err(lost()),
            Err(RecvTimeoutError::Timeout) => {
                let done = watched.done.load(Ordering::Relaxed);
                if let Err(error) = py.check_signals().and_then(|()| told(done)) {
                    watched.stopped.store(true, Ordering::Relaxed);
                    let ending = &mut results;
                    let _ = py.detach(move || ending.recv_timeout(PATIENCE));
                    return Err(error);
                }
            }
        }
    }
}

/// The result of `work` on what the caller has borrowed: an interrupt is raised when the work has ended.
pub(crate) fn wait_here<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&Watched) -> Result<T, Fault> + Send,
) -> PyResult<T> {
    let (watched, pool) = (Watched::of(0), pool()?);
    let (sender, results) = channel();
    py.detach(move || {
        let (watched, pool) = (&watched, &pool);
        thread::scope(|scope| {
            scope.spawn(move || {
                let _ = sender.send(done(|| pool.install(|| work(watched))));
            });
            loop {
                match results.recv_timeout(BREATH) {
                    Ok(result) => return result.map_err(raised),
                    Err(RecvTimeoutError::Disconnected) => return Err(lost()),
                    Err(RecvTimeoutError::Timeout) => {}
                }
                if let Err(error) = Python::attach(|py| py.check_signals()) {
                    watched.stopped.store(true, Ordering::Relaxed);
                    return Err(error);
                }
            }
        })
    })
}

/// The result of `work`, a fault where it panics.
fn done<T>(work: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    let result = catch_unwind(AssertUnwindSafe(work));
    result.unwrap_or_else(|_| Err(Fault::internal("a part of lyapunov panicked")))
}

fn lost() -> PyErr {
    errors::internal("the work was lost")
}

fn raised(fault: Fault) -> PyErr {
    match fault {
        Fault::Stopped => errors::internal("the work was stopped"),
        Fault::Input(message) => errors::input(message.strip_prefix("error: ").unwrap_or(&message)),
        Fault::Internal(message) => errors::internal(message),
        Fault::Raised(error) => error,
    }
}

/// The threads of this process: those of a parent are not there after a fork.
pub(crate) fn pool() -> PyResult<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    match &*held {
        Some((of, pool)) if *of == process::id() => Ok(Arc::clone(pool)),
        other => {
            // To drop the parent's pool would wait for threads that are not there.
            other.iter().for_each(|(_, pool)| std::mem::forget(Arc::clone(pool)));
            let pool = Arc::new(ThreadPoolBuilder::new().build().map_err(errors::internal)?);
            *held = Some((process::id(), Arc::clone(&pool)));
            Ok(pool)
        }
    }
}
