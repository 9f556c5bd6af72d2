//! Progress line by line, for logs and everything else that is no terminal.

use std::io;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle, TermLike};

use super::say;

/// Time between two lines; work that takes less has none.
const EVERY: Duration = Duration::from_secs(30);

const TEMPLATE: &str = "{msg}{percent} %, {eta} left";

/// `bar` as lines on standard error; where nobody knows how much there is, in the words of its `template`.
pub(super) fn in_lines(bar: ProgressBar, template: &str) -> ProgressBar {
    bar.set_draw_target(ProgressDrawTarget::term_like_with_hz(Box::new(Lines::new()), 1));
    let style = ProgressStyle::with_template(match bar.length() {
        Some(_) => TEMPLATE,
        None => template.trim_start_matches("{spinner} "),
    });
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Stand-in for a terminal: now and then it prints the line that was drawn last.
#[derive(Debug)]
struct Lines(Mutex<State>);

#[derive(Debug)]
struct State {
    line: String,
    printed: Instant,
}

impl Lines {
    fn new() -> Self {
        Self(Mutex::new(State { line: String::new(), printed: Instant::now() }))
    }

    /// The state; a panic elsewhere does not matter to it.
    fn with<R>(&self, change: impl FnOnce(&mut State) -> R) -> R {
        change(&mut self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner))
    }
}

impl TermLike for Lines {
    fn width(&self) -> u16 {
        200
    }

    fn move_cursor_up(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_down(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_right(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_left(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn write_line(&self, text: &str) -> io::Result<()> {
        self.write_str(text)
    }

    fn write_str(&self, text: &str) -> io::Result<()> {
        self.with(|state| state.line += text);
        Ok(())
    }

    fn clear_line(&self) -> io::Result<()> {
        self.with(|state| state.line.clear());
        Ok(())
    }

    fn flush(&self) -> io::Result<()> {
        self.with(|state| {
            let line = std::mem::take(&mut state.line);
            if !line.trim().is_empty() && state.printed.elapsed() >= EVERY {
                say(line.trim());
                state.printed = Instant::now();
            }
        });
        Ok(())
    }
}
