//! Line of units below the names.

use super::columns::{Column, Role};
use super::error::LogError;
use super::fields::{Fields, bare};
use super::heading::Unit;
use super::layout::Layout;
use super::notation::is_number;
use crate::text::shorten;

/// Reads the units of `line`, line `at` of the log called `name`, into `columns` and the powers of ten of their roles, and
/// tells whether it is a line of units: one without a number, in which some field is a unit; of a comment several are.
///
/// A column that is `scaled` by a factor takes no unit; an empty field has none.
///
/// # Errors
/// A line of units with a field that is no unit of its column, or with other columns than the names.
pub(super) fn take_units(
    layout: &Layout,
    line: &[u8],
    (name, at): (&str, u64),
    scaled: &[bool; 4],
    columns: &mut [Column],
    powers: &mut [i32; 4],
) -> Result<bool, LogError> {
    let (text, least) = line.strip_prefix(b"#").map_or((line, 1), |comment| (comment, 2));
    let fields = || Fields::new(text, layout.delimiter).map(bare);
    let is_unit = |field: &&[u8]| Role::ALL.into_iter().any(|it| Unit::alone(field, it).is_some());
    let has_number = fields().any(|field| is_number(field, layout.delimiter));
    if has_number || fields().filter(is_unit).count() < least {
        return Ok(false);
    }
    let Ok(picked) = layout.pick(text) else {
        return Err(LogError::at(name, at, "a line of units without the fields of the names")
            .with_help("give each column its unit"));
    };
    for column in columns {
        let index = column.role.index();
        let field = bare(picked[index]);
        if scaled[index] || field.is_empty() {
            continue;
        }
        let unit = Unit::alone(field, column.role);
        match unit.filter(|unit| column.unit.is_none() || unit.power() == powers[index]) {
            Some(unit) => (powers[index], column.unit) = (unit.power(), Some(unit.symbol())),
            None => {
                let written = shorten(&String::from_utf8_lossy(field));
                let message = format!(
                    "`{written}` is no unit of {}, or not the one of its name",
                    column.role.quantity()
                );
                return Err(LogError::at(name, at, message).with_help(Unit::remedy(column.role)));
            }
        }
    }
    Ok(true)
}
