//! Colours and dashes.

use super::series::{Series, Trace};

/// Colours of the series, in the order of their index: those of Okabe and Ito that stand out on
/// white and stay distinct with every common form of colour blindness.
pub const PALETTE: [&str; 7] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

/// Colours of broad bars: the palette mixed half with white, and grey for black. Dashes would hide where a bar ends.
const TINTS: [&str; 7] =
    ["#80b9d9", "#eaaf80", "#80cfb9", "#e6bcd3", "#f3cf80", "#abdaf4", "#9a9a9a"];

/// Colours of the classes of a heat map, from dark to light: they differ in lightness by a third of its range, so that
/// they also read in grey, and from blue to yellow, which every common form of colour blindness tells apart.
pub(super) const CLASSES: [&str; 3] = ["#1b204f", "#2d88a8", "#f6df90"];

/// Red, green and blue of a colour like `#1b204f`; black of any other text.
pub(super) fn rgb(colour: &str) -> [u8; 3] {
    let number = colour.strip_prefix('#').and_then(|digits| u32::from_str_radix(digits, 16).ok());
    let [_, rgb @ ..] = number.unwrap_or_default().to_be_bytes();
    rgb
}

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

    /// The look of a class's name in a legend.
    pub(super) const fn of_class(class: usize) -> Self {
        Self::solid(CLASSES[class % CLASSES.len()], BAR)
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

    /// Lightness CIE L* (0 black, 100 white) of a colour of sRGB.
    fn lightness(rgb: [u8; 3]) -> f64 {
        let linear = |part: u8| {
            let share = f64::from(part) / 255.0;
            if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
        };
        let [red, green, blue] = rgb.map(linear);
        let luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
        116.0 * luminance.cbrt() - 16.0
    }

    #[test]
    fn classes_read_in_grey_and_apart_from_nothing() {
        let found = CLASSES.map(|class| lightness(rgb(class)));
        let with_paper: Vec<f64> = found.into_iter().chain([lightness([255; 3])]).collect();
        for pair in with_paper.windows(2) {
            assert!(pair[1] - pair[0] > 10.0, "{with_paper:?}");
        }
        assert!(found.windows(2).all(|pair| pair[1] - pair[0] > 30.0), "{found:?}");
    }

    #[test]
    fn a_colour_is_read_by_its_name() {
        assert_eq!(rgb("#1b204f"), [0x1b, 0x20, 0x4f]);
        assert_eq!(rgb(PAPER), [255; 3]);
    }

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
