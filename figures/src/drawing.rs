//! Drawing in the making: what is to be seen, before it is text or pixels.

use super::geometry::{Place, Rect};
use super::palette::Stroke;
use super::picture::Picture;
use super::text::{Weight, shown};

/// Part of a text that its place refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Size, colour and position of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lettering {
    pub(super) size: f64,
    pub(super) weight: Weight,
    pub(super) colour: &'static str,
    pub(super) anchor: Anchor,
    /// A white outline keeps the letters readable on top of lines.
    pub(super) halo: bool,
    /// The text reads from bottom to top.
    pub(super) upright: bool,
}

/// Width of the outline that keeps letters readable on top of lines.
pub(super) const HALO: f64 = 3.0;

impl Lettering {
    pub(super) const fn new(size: f64, colour: &'static str, anchor: Anchor) -> Self {
        Self { size, weight: Weight::Regular, colour, anchor, halo: false, upright: false }
    }
}

/// Mark of a drawing: an area, a line, a text or a picture.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Mark {
    /// A filled rectangle.
    Area {
        area: Rect,
        fill: &'static str,
    },
    /// The edge of a rectangle.
    Outline {
        area: Rect,
        stroke: Stroke,
    },
    /// Lines through points, each by itself.
    Lines {
        lines: Vec<Vec<Place>>,
        stroke: Stroke,
        join: Join,
    },
    Dots {
        dots: Vec<Place>,
        colour: &'static str,
        diameter: f64,
    },
    /// A text in one line, without spaces at its ends or beside each other.
    Text {
        place: Place,
        lettering: Lettering,
        text: String,
    },
    /// A bitmap over an area, with sharp edges between its pixels; a page finds those of a heat map.
    Bitmap {
        area: Rect,
        picture: Picture,
        is_heat_map: bool,
    },
}

/// Look of the corner between two parts of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Join {
    Miter,
    Round,
}

/// Drawing in the making, in CSS pixels.
#[derive(Debug, Clone, Default)]
pub(super) struct Drawing {
    pub(super) marks: Vec<Mark>,
}

impl Drawing {
    pub(super) fn area(&mut self, area: Rect, fill: &'static str) {
        self.marks.push(Mark::Area { area, fill });
    }

    pub(super) fn picture(&mut self, area: Rect, picture: Picture) {
        self.marks.push(Mark::Bitmap { area, picture, is_heat_map: false });
    }

    /// Draws the bitmap of a heat map.
    pub(super) fn cells(&mut self, area: Rect, picture: Picture) {
        self.marks.push(Mark::Bitmap { area, picture, is_heat_map: true });
    }

    pub(super) fn outline(&mut self, area: Rect, stroke: Stroke) {
        self.marks.push(Mark::Outline { area, stroke });
    }

    /// Draws separate straight lines of one stroke.
    pub(super) fn lines(&mut self, lines: &[(Place, Place)], stroke: Stroke) {
        let lines = lines.iter().map(|(from, to)| vec![*from, *to]).collect();
        self.marks.push(Mark::Lines { lines, stroke, join: Join::Miter });
    }

    /// Draws lines through many points.
    pub(super) fn curves(&mut self, curves: Vec<Vec<Place>>, stroke: Stroke) {
        self.marks.push(Mark::Lines { lines: curves, stroke, join: Join::Round });
    }

    pub(super) fn dots(&mut self, dots: Vec<Place>, colour: &'static str, diameter: f64) {
        self.marks.push(Mark::Dots { dots, colour, diameter });
    }

    pub(super) fn text(&mut self, place: Place, lettering: Lettering, text: &str) {
        let words: Vec<_> = text.split_ascii_whitespace().collect();
        let text: String = words.join(" ").chars().map(shown).collect();
        if !text.is_empty() {
            self.marks.push(Mark::Text { place, lettering, text });
        }
    }
}
