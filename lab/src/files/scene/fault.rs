//! Faults that the deserializer finds, before they are put into words.

use std::fmt;
use std::ops::Range;

use serde::de;

/// The place of a key or value: the table path, the name in that table, and the bytes in the text. The name is separate
/// from the path because a quoted name may contain a point.
#[derive(Clone, Debug, Default)]
pub(super) struct Place {
    pub(super) table: String,
    pub(super) name: String,
    pub(super) span: Range<usize>,
}

impl Place {
    /// The place of a key within this table.
    pub(super) fn child(&self, key: &str, span: Range<usize>) -> Self {
        Self { table: self.path(), name: key.to_owned(), span }
    }

    /// The same key with another span, such as that of its value.
    pub(super) fn spanning(&self, span: Range<usize>) -> Self {
        Self { span, ..self.clone() }
    }

    /// The name with its table path; empty for the whole text.
    pub(super) fn path(&self) -> String {
        if self.table.is_empty() {
            self.name.clone()
        } else {
            format!("{}.{}", self.table, self.name)
        }
    }
}

/// The kind of a value in words, which introduce the value if it is short enough to repeat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// A value to repeat after these words.
    Value(&'static str),
    /// A list or a table.
    Structure(&'static str),
}

/// The kinds of faults in a scene.
#[derive(Clone, Debug)]
pub(super) enum Problem {
    /// A key that the table does not have.
    UnknownKey { known: &'static [&'static str] },
    /// A word that is none of the allowed ones.
    UnknownWord { known: &'static [&'static str] },
    /// A required key absent from the table at the fault's place.
    Missing { key: &'static str },
    /// A value of the wrong kind.
    WrongKind { expected: &'static str, found: Found },
    /// Something other than a word where one of these words belongs.
    NotWord { known: &'static [&'static str], found: Found },
    /// A value of the right kind that its quantity rejects; the sentence continues after the key.
    Refused { sentence: String },
    /// A table that must choose one of several things and holds none of them.
    NoneChosen { known: &'static [&'static str] },
    /// A table that must choose one of several things and holds more than one.
    SeveralChosen { chosen: Vec<String>, known: &'static [&'static str] },
}

/// A problem, with its place once known.
#[derive(Clone, Debug)]
pub(super) struct Fault(Box<(Problem, Option<Place>)>);

impl Fault {
    pub(super) fn new(problem: Problem) -> Self {
        Self(Box::new((problem, None)))
    }

    /// The fault at this place, unless an inner part has already placed it.
    pub(super) fn at(mut self, place: &Place) -> Self {
        self.0.1.get_or_insert_with(|| place.clone());
        self
    }

    pub(super) fn into_parts(self) -> (Problem, Place) {
        let (problem, place) = *self.0;
        (problem, place.unwrap_or_default())
    }

    /// The fault in words that follow the name of its key, where there is no text to show.
    pub(super) fn into_words(self) -> String {
        let (problem, place) = self.into_parts();
        match problem {
            Problem::Refused { sentence } => sentence,
            Problem::UnknownKey { known } => {
                format!("there is no key `{}`; known: {}", place.path(), known.join(", "))
            }
            Problem::WrongKind { expected, .. } => format!("must be {expected}"),
            _ => format!("`{}` is wrong", place.path()),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:?}", self.0)
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::new(Problem::Refused { sentence: message.to_string() })
    }

    fn invalid_type(unexpected: de::Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        Self::custom(format_args!("must be {expected}, not {unexpected}"))
    }

    fn invalid_value(unexpected: de::Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        Self::invalid_type(unexpected, expected)
    }

    fn unknown_variant(_variant: &str, known: &'static [&'static str]) -> Self {
        Self::new(Problem::UnknownWord { known })
    }

    fn unknown_field(_field: &str, known: &'static [&'static str]) -> Self {
        Self::new(Problem::UnknownKey { known })
    }

    fn missing_field(key: &'static str) -> Self {
        Self::new(Problem::Missing { key })
    }
}
