//! Frame with two axes, their grid and their numbers.

use super::drawing::{Anchor, Drawing, Lettering};
use super::geometry::{Place, Rect};
use super::palette::{FAINT_INK, FRAME, GRID, INK, Stroke};
use super::panel::Numbering;
use super::span::Span;
use super::text::{self, Weight};
use super::ticks::Ticks;

pub(super) const TICK_LENGTH: f64 = 3.5;

/// Side of the frame on which the numbers of the ordinate stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Frame on the page and the ranges that it shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axes {
    pub(super) area: Rect,
    pub(super) x: Span,
    pub(super) y: Span,
}

impl Axes {
    /// Place on the page of a point of the data, which may lie outside the frame.
    pub(super) fn place(&self, (x, y): (f64, f64)) -> Place {
        (
            self.area.left + self.x.fraction(x) * self.area.width,
            self.area.bottom() - self.y.fraction(y) * self.area.height,
        )
    }
}

/// Numbers along both axes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Numbers {
    pub(super) x: Ticks,
    pub(super) y: Ticks,
    pub(super) size: f64,
    pub(super) side: Side,
    /// The numbers get a halo, so that lines may run beneath them.
    pub(super) halo: bool,
}

/// Numbers of the abscissa, as many as fit without touching.
pub(super) fn x_ticks(span: Span, numbering: Numbering, width: f64, size: f64) -> Ticks {
    let mut count = ((width / (5.0 * size)) as usize).clamp(2, 12);
    if numbering == Numbering::PowersOfTen {
        return Ticks::powers(span, count);
    }
    loop {
        let mut ticks = Ticks::within(span, count);
        if stand_apart(&ticks, span, width, size) {
            return ticks;
        }
        if count == 2 {
            ticks.marks.truncate(1);
            return ticks;
        }
        count -= 1;
    }
}

/// Numbers of the ordinate, as many as fit without touching.
pub(super) fn y_ticks(span: Span, numbering: Numbering, height: f64, size: f64) -> Ticks {
    let count = ((height / (2.1 * size)) as usize).clamp(2, 12);
    match numbering {
        Numbering::Plain => Ticks::within(span, count),
        Numbering::PowersOfTen => Ticks::powers(span, count),
    }
}

fn stand_apart(ticks: &Ticks, span: Span, width: f64, size: f64) -> bool {
    let extents: Vec<(f64, f64)> = ticks
        .marks
        .iter()
        .map(|tick| {
            let centre = span.fraction(tick.value) * width;
            let half = 0.5 * text::width(&tick.label, size, Weight::Regular);
            (centre - half, centre + half)
        })
        .collect();
    extents.windows(2).all(|pair| pair[0].1 + size <= pair[1].0)
}

/// Width of the widest number.
pub(super) fn widest(ticks: &Ticks, size: f64) -> f64 {
    ticks
        .marks
        .iter()
        .map(|tick| text::width(&tick.label, size, Weight::Regular))
        .fold(0.0, f64::max)
}

pub(super) fn draw_grid(drawing: &mut Drawing, axes: &Axes, numbers: &Numbers) {
    let area = axes.area;
    let upright = numbers.x.marks.iter().map(|tick| {
        let (x, _) = axes.place((tick.value, axes.y.low));
        ((x, area.top), (x, area.bottom()))
    });
    let level = numbers.y.marks.iter().map(|tick| {
        let (_, y) = axes.place((axes.x.low, tick.value));
        ((area.left, y), (area.right(), y))
    });
    let lines: Vec<(Place, Place)> = upright.chain(level).collect();
    drawing.lines(&lines, Stroke::solid(GRID, 0.7));
}

pub(super) fn draw_frame(drawing: &mut Drawing, axes: &Axes, numbers: &Numbers) {
    let area = axes.area;
    let size = numbers.size;
    let lettering = |anchor| Lettering { halo: numbers.halo, ..Lettering::new(size, INK, anchor) };
    let mut strokes = Vec::new();
    for tick in &numbers.x.marks {
        let (x, _) = axes.place((tick.value, axes.y.low));
        let bottom = area.bottom();
        strokes.push(((x, bottom), (x, bottom + TICK_LENGTH)));
        let lettering = lettering(Anchor::Middle);
        drawing.text((x, bottom + TICK_LENGTH + 1.15 * size), lettering, &tick.label);
    }
    let (edge, outward, anchor) = match numbers.side {
        Side::Left => (area.left, -1.0, Anchor::End),
        Side::Right => (area.right(), 1.0, Anchor::Start),
    };
    for tick in &numbers.y.marks {
        let (_, y) = axes.place((axes.x.low, tick.value));
        strokes.push(((edge, y), (edge + outward * TICK_LENGTH, y)));
        let lettering = lettering(anchor);
        let x = edge + outward * (TICK_LENGTH + 3.0);
        drawing.text((x, y + 0.36 * size), lettering, &tick.label);
    }
    drawing.lines(&strokes, Stroke::solid(FRAME, 0.8));
    drawing.outline(area, Stroke::solid(FRAME, 0.8));
}

/// Writes the common factors and offsets inside the frame, for axes without a margin of their own.
pub(super) fn draw_notes_inside(drawing: &mut Drawing, axes: &Axes, numbers: &Numbers) {
    let area = axes.area;
    let lettering =
        |anchor| Lettering { halo: true, ..Lettering::new(numbers.size, FAINT_INK, anchor) };
    let y_place = match numbers.side {
        Side::Left => (area.left + 4.0, Anchor::Start),
        Side::Right => (area.right() - 4.0, Anchor::End),
    };
    drawing.text((y_place.0, area.top + 1.3 * numbers.size), lettering(y_place.1), &numbers.y.note);
    drawing.text(
        (area.right() - 4.0, area.bottom() - 0.5 * numbers.size),
        lettering(Anchor::End),
        &numbers.x.note,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_the_abscissa_never_touch() {
        for (low, high) in
            [(0.0, 2.0), (0.0, 1e12), (-1e-12, 1e-12), (1e12, 1e12 + 1.0), (0.1, 0.1001)]
        {
            let span = Span { low, high };
            for width in [20.0, 60.0, 150.0, 700.0] {
                let ticks = x_ticks(span, Numbering::Plain, width, 11.0);
                assert!(!ticks.marks.is_empty());
                let ends: Vec<(f64, f64)> = ticks
                    .marks
                    .iter()
                    .map(|tick| {
                        let half = 0.5 * text::width(&tick.label, 11.0, Weight::Regular);
                        let centre = (tick.value - low) / (high - low) * width;
                        (centre - half, centre + half)
                    })
                    .collect();
                let apart = ends.windows(2).all(|pair| pair[1].0 - pair[0].1 > 10.99);
                assert!(apart, "{low} {high} {width}: {ends:?}");
            }
        }
    }

    /// The largest count whose numbers do not touch.
    #[test]
    fn as_many_numbers_as_fit_stand_on_the_abscissa() {
        for (low, high) in [(0.0, 2.0), (0.0, 1e6), (-0.001, 0.0015), (0.1, 0.1001)] {
            let span = Span { low, high };
            for width in (6..60).map(|it| 12.0 * f64::from(it)) {
                let most = ((width / 55.0) as usize).clamp(2, 12);
                let fits =
                    |count: &usize| stand_apart(&Ticks::within(span, *count), span, width, 11.0);
                let expected = (2..=most).rev().find(fits).map(|it| Ticks::within(span, it));
                let found = x_ticks(span, Numbering::Plain, width, 11.0);
                assert!(expected.is_none_or(|it| it == found), "{low} {high} {width}");
            }
        }
    }

    #[test]
    fn the_corners_of_the_range_are_the_corners_of_the_frame() {
        let axes = Axes {
            area: Rect::new(10.0, 20.0, 100.0, 50.0),
            x: Span { low: 0.0, high: 2.0 },
            y: Span { low: -1.0, high: 1.0 },
        };
        assert_eq!(axes.place((0.0, -1.0)), (10.0, 70.0));
        assert_eq!(axes.place((2.0, 1.0)), (110.0, 20.0));
    }
}
