//! Headings of columns: a name, and the unit that some logs write beside it.

use super::columns::Role;

/// Unit of a quantity as the headings of a log write it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Unit {
    symbol: &'static str,
    role: Role,
    /// Its numbers times this power of ten are in SI units.
    power: i32,
}

const fn unit(symbol: &'static str, role: Role, power: i32) -> Unit {
    Unit { symbol, role, power }
}

/// The units that are known. All are powers of ten of SI units, so that a number keeps every digit.
const UNITS: [Unit; 21] = [
    unit("s", Role::T, 0),
    unit("ms", Role::T, -3),
    unit("us", Role::T, -6),
    unit("\u{b5}s", Role::T, -6),
    unit("\u{3bc}s", Role::T, -6),
    unit("ns", Role::T, -9),
    unit("m", Role::X, 0),
    unit("cm", Role::X, -2),
    unit("mm", Role::X, -3),
    unit("um", Role::X, -6),
    unit("\u{b5}m", Role::X, -6),
    unit("\u{3bc}m", Role::X, -6),
    unit("N", Role::F, 0),
    unit("mN", Role::F, -3),
    unit("kN", Role::F, 3),
    unit("m/s", Role::V, 0),
    unit("cm/s", Role::V, -2),
    unit("mm/s", Role::V, -3),
    unit("um/s", Role::V, -6),
    unit("\u{b5}m/s", Role::V, -6),
    unit("\u{3bc}m/s", Role::V, -6),
];

impl Unit {
    /// The unit of a quantity with this symbol.
    fn of(symbol: &str, role: Role) -> Option<Self> {
        UNITS.into_iter().find(|unit| unit.symbol == symbol && unit.role == role)
    }

    /// The unit of a quantity that stands alone in a field, in brackets or not.
    pub(super) fn alone(field: &[u8], role: Role) -> Option<Self> {
        let text = str::from_utf8(field).ok()?;
        let bare = text.strip_prefix(['[', '(']).and_then(|it| it.strip_suffix([']', ')']));
        Self::of(bare.unwrap_or(text).trim(), role)
    }

    /// Its symbol.
    pub(super) fn symbol(self) -> &'static str {
        self.symbol
    }

    /// The power of ten from it to the SI unit.
    pub(super) fn power(self) -> i32 {
        self.power
    }

    /// The remedy for what is no unit of a quantity.
    pub(super) fn remedy(role: Role) -> String {
        let plain = UNITS.iter().filter(|unit| unit.role == role && unit.symbol.is_ascii());
        let symbols = plain.map(|unit| unit.symbol).collect::<Vec<_>>().join(", ");
        let letter = role.letter();
        format!(
            "the units are {symbols}; for another, give its factor to SI, as in --scale {letter}=1e-3, and {letter}=1 where it is SI"
        )
    }
}

/// Heading of a column, taken apart for one quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Heading<'a> {
    /// The name without the unit.
    pub(super) name: &'a str,
    /// What stands at the place of the unit; none without one.
    pub(super) written: Option<&'a str>,
    /// The unit, where that is one of the quantity.
    pub(super) unit: Option<Unit>,
}

impl<'a> Heading<'a> {
    /// The heading `text` of a column that may hold `role`: `x [mm]`, `x (mm)`, `x_mm` or `x`.
    ///
    /// Brackets hold a unit whatever is in them. What follows an underscore is one only if it is a unit of the
    /// quantity: names may contain one.
    pub(super) fn of(text: &'a str, role: Role) -> Self {
        for (open, close) in [('[', ']'), ('(', ')')] {
            if let Some((name, written)) =
                text.strip_suffix(close).and_then(|text| text.rsplit_once(open))
            {
                let (name, written) = (name.trim(), written.trim());
                return Self { name, written: Some(written), unit: Unit::of(written, role) };
            }
        }
        let suffixed = text.rsplit_once('_').and_then(|(name, written)| {
            let unit = Unit::of(written, role)?;
            Some(Self { name, written: Some(written), unit: Some(unit) })
        });
        suffixed.unwrap_or(Self { name: text, written: None, unit: None })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_stands_in_brackets_or_behind_an_underscore() {
        for text in ["x [mm]", "x(mm)", "x_mm", "x  ( mm )"] {
            let heading = Heading::of(text, Role::X);
            assert_eq!((heading.name, heading.unit.map(Unit::power)), ("x", Some(-3)), "{text}");
        }
        let micro = ["t_us", "t [\u{b5}s]", "t (\u{3bc}s)"];
        for text in micro {
            assert_eq!(Heading::of(text, Role::T).unit.map(Unit::power), Some(-6), "{text}");
        }
    }

    #[test]
    fn a_name_may_contain_an_underscore_and_a_unit_belongs_to_a_quantity() {
        for (text, role) in [("x_measured", Role::X), ("x_s", Role::X), ("f_m", Role::F)] {
            assert_eq!(Heading::of(text, role), Heading { name: text, written: None, unit: None });
        }
        let wrong = Heading::of("x [ms]", Role::X);
        assert_eq!((wrong.name, wrong.written, wrong.unit), ("x", Some("ms"), None));
        assert_eq!(Heading::of("x_m", Role::X).unit.map(Unit::power), Some(0));
    }

    #[test]
    fn each_symbol_is_one_unit() {
        for (index, unit) in UNITS.iter().enumerate() {
            let twin = UNITS[..index].iter().find(|other| other.symbol == unit.symbol);
            assert_eq!(twin, None);
            assert_eq!(Unit::of(unit.symbol, unit.role), Some(*unit));
        }
    }
}
