//! Heat map over a frame.

use super::axes::TICK_LENGTH;
use super::drawing::{Anchor, Drawing, Lettering};
use super::geometry::Rect;
use super::palette::{CLASSES, FRAME, INK, Stroke, rgb};
use super::picture::Picture;
use super::span::Span;
use super::ticks::Ticks;

/// Room that the colour key takes.
const KEY_ROOM: f64 = 64.0;

const KEY_WIDTH: f64 = 11.0;
const KEY_GAP: f64 = 10.0;
const NUMBER_SIZE: f64 = 11.0;

/// Colour ramp from light to dark in even steps of lightness, so that it also reads in grey.
const RAMP: [[u8; 3]; 6] = [
    [0xf1, 0xf5, 0xd8],
    [0xb9, 0xdd, 0xb5],
    [0x66, 0xb9, 0xb4],
    [0x2d, 0x88, 0xa8],
    [0x27, 0x52, 0x86],
    [0x1b, 0x20, 0x4f],
];

/// Colour of a missing value.
const NOTHING: [u8; 3] = [0xff, 0xff, 0xff];

/// Heat map: a value for each element of a grid that fills the frame.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HeatMap {
    /// Number of elements in a row.
    pub columns: usize,
    /// The values, row by row from the bottom; one that is not finite leaves its element white.
    pub values: Vec<f64>,
    /// The meaning of the colours.
    pub colouring: Colouring,
}

/// Meaning of the colours of a heat map.
#[derive(Debug, Clone, PartialEq)]
pub enum Colouring {
    /// A ramp over a range, by default that of the values, with a key beside the frame.
    Ramp(Option<(f64, f64)>),
    /// A colour for each class, the darkest first; the names stand in the legend. A value is the number of its class, from
    /// 0. There are three colours, which repeat.
    Classes(Vec<String>),
}

impl Default for Colouring {
    fn default() -> Self {
        Self::Ramp(None)
    }
}

impl HeatMap {
    /// The map of `values`, row by row from the bottom, `columns` in a row.
    pub fn new(columns: usize, values: Vec<f64>) -> Self {
        Self { columns, values, colouring: Colouring::default() }
    }

    /// The map of `values` that are the numbers of `classes`.
    pub fn of_classes(columns: usize, values: Vec<f64>, classes: &[&str]) -> Self {
        let classes = classes.iter().map(|&class| class.to_owned()).collect();
        Self { columns, values, colouring: Colouring::Classes(classes) }
    }

    /// The same map with a fixed range of the colours.
    #[must_use]
    pub fn with_range(self, low: f64, high: f64) -> Self {
        Self { colouring: Colouring::Ramp(Some((low, high))), ..self }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.values.iter().all(|value| !value.is_finite())
    }

    /// The names of its classes.
    pub(super) fn classes(&self) -> &[String] {
        match &self.colouring {
            Colouring::Classes(names) => names,
            Colouring::Ramp(_) => &[],
        }
    }

    /// Room to the right of the frame for the colour key.
    pub(super) fn key_room(&self) -> f64 {
        match self.colouring {
            Colouring::Ramp(_) => KEY_ROOM,
            Colouring::Classes(_) => 0.0,
        }
    }

    fn span(&self, range: Option<(f64, f64)>) -> Span {
        Span::given(range)
            .or_else(|| Span::of(self.values.iter().copied()).map(Span::readable))
            .unwrap_or(Span::UNIT)
    }

    pub(super) fn draw(&self, drawing: &mut Drawing, area: Rect) {
        let classes = CLASSES.map(rgb);
        let colour: &dyn Fn(f64) -> [u8; 3] = match self.colouring {
            Colouring::Ramp(range) => {
                let span = self.span(range);
                &move |value| shade(value, span)
            }
            Colouring::Classes(_) => &|value| classes[value.max(0.0) as usize % classes.len()],
        };
        let rows = self.values.len() / self.columns.max(1);
        let picture = Picture::of(self.columns, rows, |column, row| {
            let value = self.values[(rows - 1 - row) * self.columns + column];
            if value.is_finite() { colour(value) } else { NOTHING }
        });
        if let Some(picture) = picture {
            drawing.cells(area, picture);
        }
    }

    /// Draws the colour key of a ramp to the right of the frame.
    pub(super) fn draw_key(&self, drawing: &mut Drawing, frame: Rect) {
        const STEPS: usize = 64;
        let Colouring::Ramp(range) = self.colouring else { return };
        let span = self.span(range);
        let area = Rect::new(frame.right() + KEY_GAP, frame.top, KEY_WIDTH, frame.height);
        let value = |row: usize| {
            let share = 1.0 - (row as f64 + 0.5) / STEPS as f64;
            span.low + share * (span.high - span.low)
        };
        if let Some(picture) = Picture::of(1, STEPS, |_, row| shade(value(row), span)) {
            drawing.picture(area, picture);
        }
        let ticks = Ticks::within(span, 5);
        let mut strokes = Vec::new();
        for tick in &ticks.marks {
            let y = area.bottom() - span.fraction(tick.value) * area.height;
            strokes.push(((area.right(), y), (area.right() + TICK_LENGTH, y)));
            let place = (area.right() + TICK_LENGTH + 3.0, y + 0.36 * NUMBER_SIZE);
            drawing.text(place, Lettering::new(NUMBER_SIZE, INK, Anchor::Start), &tick.label);
        }
        drawing.lines(&strokes, Stroke::solid(FRAME, 0.8));
        drawing.outline(area, Stroke::solid(FRAME, 0.8));
        let note = (area.left + KEY_WIDTH, area.top - 5.0);
        drawing.text(note, Lettering::new(NUMBER_SIZE, INK, Anchor::Middle), &ticks.note);
    }
}

/// Shade of the ramp.
fn shade(value: f64, span: Span) -> [u8; 3] {
    // Few enough shades for a bitmap of one byte for each element.
    const SHADES: f64 = 250.0;
    let share = (SHADES * span.fraction(value).clamp(0.0, 1.0)).round() / SHADES;
    let place = share * (RAMP.len() - 1) as f64;
    let step = (place as usize).min(RAMP.len() - 2);
    let share = place - step as f64;
    let mut shade = RAMP[step];
    for (part, colour) in shade.iter_mut().enumerate() {
        let [from, to] = [f64::from(*colour), f64::from(RAMP[step + 1][part])];
        *colour = (from + share * (to - from)).round() as u8;
    }
    shade
}
