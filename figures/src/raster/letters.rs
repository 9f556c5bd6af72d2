//! Outlines of letters.

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, OutlineBuilder};

use crate::drawing::{Anchor, Lettering};
use crate::text;

/// The outlines of a text, whose place is the origin; none where nothing of it is to be seen.
pub(super) fn outlines(text: &str, lettering: Lettering) -> Option<Path> {
    let Lettering { size, weight, anchor, .. } = lettering;
    let face = Face::parse(weight.bytes(), 0).ok()?;
    let advances = text::advances(text, size, weight);
    let width: f64 = advances.iter().map(|(_, advance)| advance).sum();
    let mut left = match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * width,
        Anchor::End => -width,
    };
    let unit = size / f64::from(face.units_per_em());
    let mut letters = Letters { path: PathBuilder::new(), unit: unit as f32, left: left as f32 };
    for (character, (_, advance)) in text.chars().zip(advances) {
        letters.left = left as f32;
        // The first glyph stands for characters that the typeface lacks.
        let glyph = face.glyph_index(character).unwrap_or_default();
        face.outline_glyph(glyph, &mut letters);
        left += advance;
    }
    letters.path.finish()
}

/// Outlines of letters in the making: a typeface has its ordinate upwards.
struct Letters {
    path: PathBuilder,
    /// The size of a unit of the typeface.
    unit: f32,
    /// Left end of the present letter.
    left: f32,
}

impl Letters {
    fn at(&self, x: f32, y: f32) -> [f32; 2] {
        [self.left + self.unit * x, -self.unit * y]
    }
}

impl OutlineBuilder for Letters {
    fn move_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let [[x1, y1], [x, y]] = [self.at(x1, y1), self.at(x, y)];
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let [[x1, y1], [x2, y2], [x, y]] = [self.at(x1, y1), self.at(x2, y2), self.at(x, y)];
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
