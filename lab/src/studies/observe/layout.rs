//! Places of the requested columns in a row.

use super::bad::Reason;
use super::columns::{Columns, Role, position};
use super::error::ObserveError;
use super::fields::{Fields, bare, delimiter, number};
use crate::text::{nearest, shorten};

/// The most names that a message lists.
const LISTED: usize = 12;

/// Places of the requested columns in a row.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    delimiter: u8,
    /// The number of fields in a row.
    width: usize,
    /// Index and role of each column, in the order of the indices.
    wanted: Vec<(usize, Role)>,
    /// Whether the line that it was read from is itself a row.
    pub(super) is_row: bool,
}

impl Layout {
    /// Layout of a log whose first line, line `at`, is `line`.
    pub(super) fn of(
        line: &[u8],
        columns: &Columns,
        name: &str,
        at: u64,
    ) -> Result<Self, ObserveError> {
        let wrong = |message: String| ObserveError::at(name, at, message);
        if line.contains(&0) {
            return Err(wrong("this is no text: it holds a byte 0".to_owned())
                .with_help("give a log of comma-separated values, as text in UTF-8"));
        }
        let delimiter = delimiter(line);
        let fields: Vec<&[u8]> = Fields::new(line, delimiter).map(bare).collect();
        let mut wanted = Vec::new();
        for (role, asked) in columns.roles() {
            let index = find(asked, &fields, columns).map_err(|(message, help)| {
                wrong(message).with_help(help.replace("{role}", role.letter()))
            })?;
            if let Some((_, other)) = wanted.iter().find(|(taken, _)| *taken == index) {
                let (other, role) = (Role::letter(*other), role.letter());
                return Err(wrong(format!(
                    "column {} would be both {other} and {role}",
                    index + 1
                ))
                .with_help("give --columns a column of its own for each"));
            }
            wanted.push((index, role));
        }
        wanted.sort_by_key(|(index, _)| *index);
        let is_row = columns.numbered()
            && wanted
                .iter()
                .any(|(index, _)| fields.get(*index).copied().and_then(number).is_some());
        Ok(Self { delimiter, width: fields.len(), wanted, is_row })
    }

    /// The requested fields, in the order of the roles.
    pub(super) fn pick<'a>(&self, line: &'a [u8]) -> Result<[&'a [u8]; 4], Reason<'a>> {
        let mut picked: [&[u8]; 4] = [b""; 4];
        let mut wanted = self.wanted.iter();
        let mut next = wanted.next();
        let mut found = 0;
        for field in Fields::new(line, self.delimiter) {
            if let Some((index, role)) = next
                && *index == found
            {
                picked[role.index()] = field;
                next = wanted.next();
            }
            found += 1;
        }
        if found == self.width {
            Ok(picked)
        } else {
            Err(Reason::Fields { found, expected: self.width })
        }
    }
}

/// The index of a column, or the fault and its remedy.
fn find(asked: &str, fields: &[&[u8]], columns: &Columns) -> Result<usize, (String, String)> {
    let mut named = fields.iter().enumerate().filter(|(_, field)| **field == asked.as_bytes());
    if let Some((index, _)) = named.next().filter(|_| !columns.numbered()) {
        return match named.next() {
            None => Ok(index),
            Some((other, _)) => Err((
                format!("there are two columns `{}`: {} and {}", asked, index + 1, other + 1),
                "give --columns the number of the right one".to_owned(),
            )),
        };
    }
    if let Some(index) = position(asked) {
        return if index < fields.len() {
            Ok(index)
        } else {
            let message = format!("there is no column {asked}: this line has {}", fields.len());
            Err((message, "columns are counted from 1".to_owned()))
        };
    }
    Err((format!("there is no column `{}`", shorten(asked)), missing(asked, fields)))
}

/// Remedy for a column that is not there.
fn missing(asked: &str, fields: &[&[u8]]) -> String {
    let names: Vec<String> =
        fields.iter().map(|field| String::from_utf8_lossy(field).into_owned()).collect();
    if !fields.is_empty() && fields.iter().all(|field| number(field).is_some()) {
        return "this line holds numbers, so the log has no names: give --columns the numbers of \
                the columns, from 1, as in 1,2,3"
            .to_owned();
    }
    let known: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut listed: Vec<String> = known.iter().take(LISTED).map(|name| shorten(name)).collect();
    if known.len() > LISTED {
        listed.push(format!("{} more", known.len() - LISTED));
    }
    let guess = match nearest(asked, &known) {
        Some(name) => format!("did you mean `{}`? ", shorten(name)),
        None => String::new(),
    };
    format!("{guess}name the column of {{role}} with --columns; there are {}", listed.join(", "))
}
