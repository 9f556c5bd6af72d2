//! Log as a stream of bytes, with progress and interrupts.

use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use indicatif::ProgressBar;
use lyapunov_lab::observe::opened;
use lyapunov_lab::{legible, shell_word};

use super::{BAR, End, named, shown};

/// Bytes that the reading thread hands over at once.
const PIECE: usize = 1 << 16;

/// Time between two checks for interrupts while the stream has no data.
const BREATH: Duration = Duration::from_millis(100);

/// Size in bytes below which a file gets no progress bar.
const SMALL: u64 = 1 << 24;

/// Bytes of a refused file in which the first line of a scene is looked for.
const HEAD: u64 = 1 << 12;

/// Log as a stream of bytes that shows progress and ends at an interrupt.
#[derive(Debug)]
pub(crate) struct Source {
    stream: Stream,
    size: Option<u64>,
    read: u64,
    bar: ProgressBar,
}

#[derive(Debug)]
enum Stream {
    /// A file, whose reads never block for long.
    File(File),
    /// Anything else, read by a thread of its own: a read that blocks cannot be ended otherwise.
    Thread { pieces: Receiver<io::Result<Vec<u8>>>, piece: Vec<u8>, used: usize },
}

impl Source {
    fn standard_input() -> io::Result<Self> {
        Ok(Self::of(waiting(|| Ok(io::stdin()))?, None))
    }

    /// Opens the file at `path`, or whatever else is there.
    fn open(path: &Path) -> io::Result<Self> {
        if fs::metadata(path).is_ok_and(|it| !it.is_file() && !it.is_dir()) {
            // Opening a pipe blocks until somebody writes to it, so the thread does that too.
            let path = path.to_owned();
            return Ok(Self::of(waiting(move || opened(&path))?, None));
        }
        let file = opened(path)?;
        let size = file.metadata()?.len();
        Ok(Self::of(Stream::File(file), Some(size)))
    }

    fn of(stream: Stream, size: Option<u64>) -> Self {
        Self { stream, size, read: 0, bar: ProgressBar::hidden() }
    }

    /// The log at `path`, or of standard input for `-`, with its name in messages.
    ///
    /// # Errors
    /// A place without a file that can be read.
    fn named(path: &Path) -> Result<(Self, String), End> {
        let standard = path == Path::new("-");
        let name = if standard { "standard input".to_owned() } else { named(path) };
        let source = if standard { Self::standard_input() } else { Self::open(path) };
        Ok((source.map_err(|error| End::input(format!("{name}: {error}")))?, name))
    }

    /// Result of `read` on the log at `path` and its name, with progress unless `quiet`.
    ///
    /// # Errors
    /// Those of [`Source::named`] and of `read`, and an interrupt.
    pub(crate) fn read_by<T, E: Display>(
        path: &Path,
        quiet: bool,
        read: impl FnOnce(Self, &str) -> Result<T, E>,
    ) -> Result<T, End> {
        let (mut source, name) = Self::named(path)?;
        source.show_progress(quiet);
        let result = read(source, &name);
        // An interrupted stream also ends with an error of its own, which would hide the interrupt.
        End::if_interrupted()?;
        result.map_err(|error| scene_at(path).unwrap_or_else(|| End::input(error)))
    }

    /// Shows a progress bar, unless the command is `quiet` or the file small.
    fn show_progress(&mut self, quiet: bool) {
        let (bar, template) = match self.size {
            Some(size) if size < SMALL => return,
            Some(size) => (ProgressBar::new(size), BAR),
            None => (ProgressBar::new_spinner(), "{spinner} {bytes} read, {bytes_per_sec}"),
        };
        self.bar = shown(bar, template, quiet);
    }
}

/// The end of a command that was given a scene where a log belongs: what stands at `path` begins as no log does.
fn scene_at(path: &Path) -> Option<End> {
    fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    let mut head = Vec::new();
    File::open(path).ok()?.take(HEAD).read_to_end(&mut head).ok()?;
    let head = String::from_utf8_lossy(&head);
    let mut lines = head.trim_start_matches('\u{feff}').lines().zip(1..);
    let is_note = |line: &str| line.trim().is_empty() || line.trim_start().starts_with('#');
    let (line, number) = lines.find(|(line, _)| !is_note(line))?;
    let line = line.split('#').next().unwrap_or_default().trim();
    let is_name = |it: char| it.is_ascii_alphanumeric() || "_-.".contains(it);
    let is_key = |key: &str| !key.is_empty() && key.chars().all(is_name);
    let is_table = line.strip_prefix('[').and_then(|it| it.strip_suffix(']')).is_some_and(is_key);
    let is_pair = line.split_once('=').is_some_and(|(key, value)| {
        let value = value.trim();
        // More than one `=` outside of a table may be fields such as `t=0,x=1`.
        is_key(key.trim()) && (value.starts_with('{') || !value.contains('='))
    });
    (is_table || is_pair).then(|| {
        let (name, word) = (named(path), shell_word(&path.to_string_lossy()));
        End::input(format!(
            "{name}:{number}: this looks like a scene: `{}`\n  = give a log of comma-separated values; \
             `lyapunov run {word}` simulates a scene",
            legible(line)
        ))
    })
}

/// A stream that a thread opens and reads.
fn waiting<R: Read>(open: impl FnOnce() -> io::Result<R> + Send + 'static) -> io::Result<Stream> {
    let (sender, pieces) = sync_channel(4);
    thread::Builder::new().spawn(move || {
        let mut reader = match open() {
            Ok(reader) => reader,
            Err(error) => return drop(sender.send(Err(error))),
        };
        loop {
            let mut piece = vec![0; PIECE];
            let read = match reader.read(&mut piece) {
                Ok(read) => read,
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                Err(error) => return drop(sender.send(Err(error))),
            };
            piece.truncate(read);
            // The receiver is gone, or an empty piece has marked the end.
            if sender.send(Ok(piece)).is_err() || read == 0 {
                return;
            }
        }
    })?;
    Ok(Stream::Thread { pieces, piece: Vec::new(), used: 0 })
}

impl Read for Source {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let interrupted = || io::Error::other("interrupted");
        End::if_interrupted().map_err(|_| interrupted())?;
        let read = match &mut self.stream {
            Stream::File(file) => file.read(buffer)?,
            Stream::Thread { pieces, piece, used } => {
                while *used == piece.len() {
                    match pieces.recv_timeout(BREATH) {
                        Ok(next) => (*piece, *used) = (next?, 0),
                        Err(RecvTimeoutError::Disconnected) => return Ok(0),
                        Err(RecvTimeoutError::Timeout) => {
                            End::if_interrupted().map_err(|_| interrupted())?;
                        }
                    }
                }
                let size = buffer.len().min(piece.len() - *used);
                buffer[..size].copy_from_slice(&piece[*used..*used + size]);
                *used += size;
                size
            }
        };
        self.read += read as u64;
        self.bar.set_position(self.read);
        Ok(read)
    }
}

impl Drop for Source {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
