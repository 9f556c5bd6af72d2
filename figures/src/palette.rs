//! Colours and dashes.

use super::series::{Series, Trace};

/// Colours of the series, in the order of their index: those of Okabe and Ito that stand out on
/// white and stay distinct with every common form of colour blindness.
pub const PALETTE: [&str; 7] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

/// Colours of broad bars: the palette mixed half with white, and grey for black. Dashes would hide where a bar ends.
const TINTS: [&str; 7] =
    ["#80b9d9", "#eaaf80", "#80cfb9", "#e6bcd3", "#f3cf80", "#abdaf4", "#9a9a9a"];

/// Dash patterns, the first one solid.
const DASHES: [&str; 4] = ["", "6 3", "2 2.5", "9 3 2 3"];

pub(super) const INK: &str = "#222222";
pub(super) const FAINT_INK: &str = "#555555";
pub(super) const FRAME: &str = "#444444";
pub(super) const GRID: &str = "#e4e4e4";
pub(super) const PAPER: &str = "#ffffff";

/// Width of a bar.
const BAR: f64 = 11.0;

/// Colour, width and dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    pub(super) colour: &'static str,
    pub(super) width: f64,
    pub(super) dash: &'static str,
}

impl Stroke {
    pub(super) const fn solid(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dash: DASHES[0] }
    }

    pub(super) const fn dashed(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dash: "5 3" }
    }

    pub(super) fn of(series: &Series) -> Self {
        let (round, colour) = (series.colour / PALETTE.len(), series.colour % PALETTE.len());
        if series.trace == Trace::Bars {
            return Self::solid([PALETTE, TINTS][round % 2][colour], BAR);
        }
        let dash = (round % DASHES.len() + usize::from(series.dashed)) % DASHES.len();
        Self { colour: PALETTE[colour], width: 1.3, dash: DASHES[dash] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_index_has_a_look_of_its_own_until_colours_and_dashes_are_used_up() {
        let looks: Vec<_> = (0..PALETTE.len() * DASHES.len())
            .map(|colour| Stroke::of(&Series::line("", colour, Vec::new())))
            .map(|stroke| (stroke.colour, stroke.dash))
            .collect();
        for (index, look) in looks.iter().enumerate() {
            assert!(!looks[..index].contains(look), "{index}");
        }
        Stroke::of(&Series::line("", usize::MAX, Vec::new()));
    }
}
