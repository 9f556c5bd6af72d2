//! Places of the requested columns in a row.

use super::axes::unread;
use super::bad::Reason;
use super::columns::{Column, Columns, Role, position};
use super::error::LogError;
use super::fields::{Fields, bare, delimiter};
use super::heading::{Heading, Unit};
use super::notation::is_number;
use crate::text::{nearest, shorten};

/// The most names that a message lists.
const LISTED: usize = 12;

/// Remedy for what is no log.
pub(super) const EXPECTED: &str =
    "give a log of comma-separated values, as text with one row per line";

/// Remedy for lines that are parted by carriage returns, as old programs do.
pub(super) const RETURNS: &str =
    "its lines end in CR alone, so that all are one: save it with line ends LF or CRLF";

/// Places of the requested columns in a row.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub(super) delimiter: u8,
    /// The number of fields in a row.
    pub(super) width: usize,
    /// Index and role of each column, in the order of the indices.
    wanted: Vec<(usize, Role)>,
    /// The heading of each column as asked for, in the order of the roles.
    headings: Vec<(Role, String, String)>,
    /// A sentence about axes that are not asked for.
    pub(super) unread_axes: Option<String>,
    /// The line of the headings.
    line: u64,
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
    ) -> Result<Self, LogError> {
        let wrong = |message: String| LogError::at(name, at, message);
        if line.contains(&0) {
            return Err(wrong("this is no text in UTF-8: it holds a byte 0".to_owned())
                .with_help("text in UTF-16 looks like this: save it as UTF-8"));
        }
        if has_returns(line) {
            return Err(
                wrong("this line holds a carriage return, CR".to_owned()).with_help(RETURNS)
            );
        }
        let delimiter = delimiter(line);
        let fields: Vec<&[u8]> = Fields::new(line, delimiter).map(bare).collect();
        let (mut wanted, mut headings, texts) = (Vec::new(), Vec::new(), texts(&fields));
        for (role, asked) in columns.roles() {
            let index = find(role, asked, &fields, columns).map_err(|(message, help)| {
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
            let place = wanted.partition_point(|(other, _)| *other < index);
            wanted.insert(place, (index, role));
            headings.push((role, asked.to_owned(), texts[index].clone()));
        }
        let unread_axes = unread(&headings[Role::X.index()].2, &texts);
        let is_row = columns.numbered()
            && wanted.iter().any(|(index, _)| is_number(fields[*index], delimiter));
        let width = fields.len();
        Ok(Self { delimiter, width, wanted, headings, unread_axes, line: at, is_row })
    }

    /// The columns with the units of their headings, and for each role the power of ten from its unit.
    ///
    /// In a column that is `scaled` a factor counts in place of a unit.
    pub(super) fn units(
        &self,
        name: &str,
        scaled: &[bool; 4],
    ) -> Result<(Vec<Column>, [i32; 4]), LogError> {
        let (mut read, mut powers) = (Vec::new(), [0; 4]);
        for (role, asked, text) in &self.headings {
            let (role, index) = (*role, role.index());
            if self.is_row {
                read.push(Column { role, heading: None, unit: None, is_guessed: false });
                continue;
            }
            let heading = Heading::of(text, role);
            let is_told = scaled[index];
            let unit = heading.unit.filter(|_| !is_told);
            if let (None, Some(written), false) = (unit, heading.written, is_told) {
                return Err(self.no_unit(name, role, text, written));
            }
            powers[index] = unit.map_or(0, Unit::power);
            let is_guessed = position(asked).is_none() && asked != text && asked != heading.name;
            let (heading, unit) = (Some(text.clone()), unit.map(Unit::symbol));
            read.push(Column { role, heading, unit, is_guessed });
        }
        Ok((read, powers))
    }

    fn no_unit(&self, name: &str, role: Role, heading: &str, written: &str) -> LogError {
        let (heading, written) = (shorten(heading), shorten(written));
        let message =
            format!("the column `{heading}`: `{written}` is no unit of {}", role.quantity());
        LogError::at(name, self.line, message).with_help(Unit::remedy(role))
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
fn find(
    role: Role,
    asked: &str,
    fields: &[&[u8]],
    columns: &Columns,
) -> Result<usize, (String, String)> {
    if !columns.numbered()
        && let Some(index) = only(asked, fields, |field| field == asked)?
    {
        return Ok(index);
    }
    if let Some(index) = position(asked) {
        return if index < fields.len() {
            Ok(index)
        } else {
            let message = format!("there is no column {asked}: this line has {}", fields.len());
            Err((message, "columns are counted from 1".to_owned()))
        };
    }
    if let Some(index) = only(asked, fields, |field| Heading::of(field, role).name == asked)? {
        return Ok(index);
    }
    let is_word = |field: &str| {
        let name = Heading::of(field, role).name;
        role.words().iter().any(|word| word.eq_ignore_ascii_case(name))
    };
    if asked == role.letter()
        && let Some(index) = only(role.quantity(), fields, is_word)?
    {
        return Ok(index);
    }
    let remedy = match asked {
        "0" => "columns are counted from 1".to_owned(),
        _ => missing(asked, fields),
    };
    Err((format!("there is no column `{}`", shorten(asked)), remedy))
}

/// The index of the one column whose heading `fits`; none without one.
fn only(
    asked: &str,
    fields: &[&[u8]],
    fits: impl Fn(&str) -> bool,
) -> Result<Option<usize>, (String, String)> {
    let mut found = fields.iter().enumerate().filter_map(|(index, field)| {
        str::from_utf8(field).ok().filter(|field| fits(field)).map(|field| (index, field))
    });
    let Some((index, first)) = found.next() else { return Ok(None) };
    let Some((other, second)) = found.next() else { return Ok(Some(index)) };
    let (at, and) = (index + 1, other + 1);
    let message = if first == second {
        format!("there are two columns `{}`: {at} and {and}", shorten(first))
    } else {
        let (first, second) = (shorten(first), shorten(second));
        format!("two columns may be `{asked}`: {at}, `{first}`, and {and}, `{second}`")
    };
    Err((message, "give --columns the number of the right one".to_owned()))
}

/// Whether carriage returns part lines within `line`.
pub(super) fn has_returns(line: &[u8]) -> bool {
    line.trim_ascii().contains(&b'\r')
}

/// The fields as text.
fn texts(fields: &[&[u8]]) -> Vec<String> {
    fields.iter().map(|field| String::from_utf8_lossy(field).into_owned()).collect()
}

/// Remedy for a column that is not there.
fn missing(asked: &str, fields: &[&[u8]]) -> String {
    let is_odd = |field: &&[u8]| field.iter().any(u8::is_ascii_control);
    let opens = |field: &&[u8]| matches!(field.first(), Some(b'{' | b'[' | b'<'));
    if fields.iter().any(is_odd) || fields.first().is_some_and(opens) {
        return EXPECTED.to_owned();
    }
    let names = texts(fields);
    if let Some(name) = names.iter().find(|name| name.contains(char::REPLACEMENT_CHARACTER)) {
        return format!(
            "the file is not UTF-8 in `{}`: save it as UTF-8, or give --columns the numbers of the columns, from 1, as in 1,2,3",
            shorten(name)
        );
    }
    if names.len() < 2 {
        return EXPECTED.to_owned();
    }
    if fields.iter().all(|field| is_number(field, b';')) {
        return "this line holds numbers, so the log has no names: give --columns the numbers of \
                the columns, from 1, as in 1,2,3"
            .to_owned();
    }
    let known: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut listed: Vec<String> = known.iter().take(LISTED).map(|name| shorten(name)).collect();
    if known.len() > LISTED {
        listed.push(format!("{} more", known.len() - LISTED));
    }
    let listed = listed.join(", ");
    if known.len() == 2 {
        return format!("a log needs columns of time, position and force; there are {listed}");
    }
    let guess = match nearest(asked, &known) {
        Some(name) => format!("did you mean `{}`? ", shorten(name)),
        None => String::new(),
    };
    format!("{guess}name the column of {{role}} with --columns; there are {listed}")
}
