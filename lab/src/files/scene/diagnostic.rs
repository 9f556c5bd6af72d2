//! Messages about faults of a scene.

use std::fmt;
use std::ops::Range;

use crate::text::excerpt::Excerpt;
use crate::text::{folded, legible};

/// A fault that keeps a scene from being read: the problem, its place and the remedy.
///
/// `Display` gives the whole message, over several lines and without a final newline; the methods give its parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic(Box<Parts>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Parts {
    name: String,
    message: String,
    key: Option<String>,
    value: Option<String>,
    excerpt: Option<Excerpt>,
    help: Vec<String>,
}

impl Diagnostic {
    pub(crate) fn new(name: &str, message: impl Into<String>) -> Self {
        Self(Box::new(Parts {
            name: legible(name),
            message: message.into(),
            key: None,
            value: None,
            excerpt: None,
            help: Vec::new(),
        }))
    }

    pub(super) fn with_key(mut self, key: impl Into<String>) -> Self {
        self.0.key = Some(key.into()).filter(|key| !key.is_empty());
        self
    }

    pub(super) fn with_value(mut self, value: Option<String>) -> Self {
        self.0.value = value;
        self
    }

    pub(crate) fn with_help(mut self, line: impl Into<String>) -> Self {
        self.0.help.push(line.into());
        self
    }

    pub(super) fn with_excerpt(mut self, text: &str, span: Range<usize>) -> Self {
        self.0.excerpt = Some(Excerpt::new(text, span));
        self
    }

    /// The name of the text, usually the path of its file.
    pub fn name(&self) -> &str {
        &self.0.name
    }

    /// The problem in one line, without its place.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The key at fault with its table path, as in `environment.wall.stiffness`.
    pub fn key(&self) -> Option<&str> {
        self.0.key.as_deref()
    }

    /// The value at fault as it stands in the text, cut if it is long.
    pub fn value(&self) -> Option<&str> {
        self.0.value.as_deref()
    }

    /// The line in the text, from 1; none if the file as a whole is at fault.
    pub fn line(&self) -> Option<usize> {
        self.0.excerpt.as_ref().map(|excerpt| excerpt.line)
    }

    /// The column in the line in characters, from 1.
    pub fn column(&self) -> Option<usize> {
        self.0.excerpt.as_ref().map(|excerpt| excerpt.column)
    }

    /// The remedies, one piece of advice each.
    pub fn help(&self) -> &[String] {
        &self.0.help
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "error: {}", self.0.name)?;
        if let Some(excerpt) = &self.0.excerpt {
            write!(formatter, ":{}:{}", excerpt.line, excerpt.column)?;
        }
        write!(formatter, ": {}", self.0.message)?;
        let mut margin = 1;
        if let Some(excerpt) = &self.0.excerpt {
            write!(formatter, "\n{}", excerpt.render())?;
            margin = excerpt.line.to_string().len();
        }
        for advice in &self.0.help {
            write_advice(formatter, advice, margin)?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostic {}

/// Writes one piece of advice: the first line folded between words, the lines of code below it unchanged.
fn write_advice(formatter: &mut fmt::Formatter<'_>, advice: &str, margin: usize) -> fmt::Result {
    let mut lines = advice.split('\n');
    let label = format!("{:margin$} = ", "");
    write!(formatter, "\n{}", folded(&label, lines.next().unwrap_or_default()))?;
    lines.try_for_each(|line| write!(formatter, "\n{:margin$}       {line}", ""))
}
