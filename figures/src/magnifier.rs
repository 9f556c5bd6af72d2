//! Magnified part of a panel on the page.

use super::axes::{self, Axes, Numbers, Side};
use super::curve::Curve;
use super::drawing::Drawing;
use super::geometry::{Place, Rect};
use super::inset::{Inset, Placement};
use super::palette::{PAPER, Stroke};
use super::panel::Panel;
use super::reference;
use super::span::Span;
use super::ticks::Ticks;

const SIZE: f64 = 9.5;
const MARK: Stroke = Stroke::solid("#444444", 0.8);
const CONNECTION: Stroke = Stroke::solid("#b0b0b0", 0.8);

/// Magnified part of a panel on the page.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Magnifier {
    axes: Axes,
    numbers: Numbers,
    /// Area of the frame with its numbers.
    pub(super) outer: Rect,
    /// Area of the magnified range in the panel, if the panel shows it.
    pub(super) mark: Option<Rect>,
}

/// Divides the room of a panel: its own axes, and the magnified part if it has one.
pub(super) fn arrange(panel: &Panel, whole: Axes) -> (Axes, Option<Magnifier>) {
    let ranges = panel.inset.and_then(|inset| ranges(panel, &inset, &whole));
    let (Some(inset), Some((x, y))) = (panel.inset, ranges) else {
        return (whole, None);
    };
    let has_room_beside = whole.area.width >= 200.0;
    if inset.placement != Placement::Beside || !has_room_beside {
        let (magnifier, hidden) = inside(panel, &whole, x, y);
        if hidden == 0 || inset.placement == Placement::Inside || !has_room_beside {
            return (whole, Some(magnifier));
        }
    }
    let (main, magnifier) = beside(panel, &whole, x, y);
    (main, Some(magnifier))
}

fn ranges(panel: &Panel, inset: &Inset, whole: &Axes) -> Option<(Span, Span)> {
    let x = Span::given(Some(inset.x_range))?;
    let y = Span::given(inset.y_range).or_else(|| panel.data_span(x)).unwrap_or(whole.y);
    Some((x, y))
}

/// The magnified part in the corner where it hides least, and how much it hides.
fn inside(panel: &Panel, whole: &Axes, x: Span, y: Span) -> (Magnifier, usize) {
    let curves = Curve::all(&panel.series, whole);
    let room = whole.area.grown(-7.0);
    let mark = mark(whole, x, y);
    let mut best: Option<(Magnifier, usize)> = None;
    for share in [0.48, 0.42, 0.36] {
        let width = (share * room.width).max(120.0).min(room.width.max(30.0));
        let height = (share * room.height).max(88.0).min(room.height.max(30.0));
        let (right, bottom) = (room.right() - width, room.bottom() - height);
        for (left, top) in
            [(right, room.top), (right, bottom), (room.left, room.top), (room.left, bottom)]
        {
            let outer = Rect::new(left, top, width, height);
            let mut hidden: usize = curves.iter().map(|curve| curve.pieces_within(&outer)).sum();
            if mark.is_some_and(|mark| mark.grown(6.0).overlaps(&outer)) {
                hidden += 100_000;
            }
            if best.as_ref().is_none_or(|(_, least)| hidden < *least) {
                best = Some((within(panel, outer, x, y, mark), hidden));
            }
        }
    }
    best.unwrap_or_else(|| (within(panel, room, x, y, mark), usize::MAX))
}

fn within(panel: &Panel, outer: Rect, x: Span, y: Span, mark: Option<Rect>) -> Magnifier {
    let (above, below, right) = (7.0, SIZE + 8.0, 12.0);
    let height = (outer.height - above - below).max(10.0);
    let y_ticks = axes::y_ticks(y, panel.y_numbers, height, SIZE);
    let left = axes::widest(&y_ticks, SIZE) + 11.0;
    let width = (outer.width - left - right).max(10.0);
    let area = Rect::new(outer.left + left, outer.top + above, width, height);
    Magnifier {
        axes: Axes { area, x, y },
        numbers: numbers(axes::x_ticks(x, panel.x_numbers, width, SIZE), y_ticks, Side::Left),
        outer,
        mark,
    }
}

/// The panel made narrower, and the magnified part to its right.
fn beside(panel: &Panel, whole: &Axes, x: Span, y: Span) -> (Axes, Magnifier) {
    const GAP: f64 = 40.0;
    let y_ticks = axes::y_ticks(y, panel.y_numbers, whole.area.height, SIZE);
    let numbers_width = axes::widest(&y_ticks, SIZE) + 8.0;
    let room = (whole.area.width - GAP - numbers_width).max(40.0);
    let main = Axes { area: Rect { width: 0.6 * room, ..whole.area }, ..*whole };
    let area = Rect { left: main.area.right() + GAP, width: 0.4 * room, ..whole.area };
    let magnifier = Magnifier {
        axes: Axes { area, x, y },
        numbers: numbers(axes::x_ticks(x, panel.x_numbers, area.width, SIZE), y_ticks, Side::Right),
        outer: area,
        mark: mark(&main, x, y),
    };
    (main, magnifier)
}

fn numbers(x: Ticks, y: Ticks, side: Side) -> Numbers {
    Numbers { x, y, size: SIZE, side, halo: true }
}

/// The magnified range on the page, large enough to be seen.
fn mark(axes: &Axes, x: Span, y: Span) -> Option<Rect> {
    const SMALLEST: f64 = 3.0;
    let (left, bottom) = axes.place((x.low, y.low));
    let (right, top) = axes.place((x.high, y.high));
    let area = axes.area;
    let mark = Rect::new(left, top, right - left, bottom - top);
    if !mark.overlaps(&area) {
        return None;
    }
    let (left, right) = (left.max(area.left), right.min(area.right()));
    let (top, bottom) = (top.max(area.top), bottom.min(area.bottom()));
    let widening = (0.5 * (SMALLEST - (right - left))).max(0.0);
    let heightening = (0.5 * (SMALLEST - (bottom - top))).max(0.0);
    Some(Rect::new(
        left - widening,
        top - heightening,
        right - left + 2.0 * widening,
        bottom - top + 2.0 * heightening,
    ))
}

impl Magnifier {
    /// Draws the lines from the magnified range to the frame, beneath the curves.
    pub(super) fn draw_connections(&self, drawing: &mut Drawing) {
        drawing.lines(&self.connections(), CONNECTION);
    }

    pub(super) fn draw(&self, drawing: &mut Drawing, panel: &Panel) {
        if let Some(mark) = self.mark {
            drawing.outline(mark, MARK);
        }
        drawing.area(self.outer, PAPER);
        // Numbers stand to the left of the frame and below it; a line through a number would change how it reads.
        if self.mark.is_some_and(|mark| is_above(mark, self.axes.area)) {
            let connections = self.connections().into_iter();
            let hidden: Vec<(Place, Place)> =
                connections.filter_map(|(from, to)| self.outer.cut(from, to)).collect();
            drawing.lines(&hidden, CONNECTION);
        }
        axes::draw_grid(drawing, &self.axes, &self.numbers);
        reference::draw_lines(drawing, &panel.guides, &self.axes);
        for curve in Curve::all(&panel.series, &self.axes) {
            curve.draw(drawing);
        }
        axes::draw_frame(drawing, &self.axes, &self.numbers);
        axes::draw_notes_inside(drawing, &self.axes, &self.numbers);
    }

    fn connections(&self) -> Vec<(Place, Place)> {
        let Some(mark) = self.mark else { return Vec::new() };
        let frame = self.axes.area;
        connections(mark, if is_above(mark, frame) { frame } else { self.outer })
    }
}

fn is_above(mark: Rect, frame: Rect) -> bool {
    mark.bottom() <= frame.top
}

/// Lines from the mark to the frame that cross neither: between the edges that face each other where one is above the
/// other, else between like corners.
fn connections(mark: Rect, frame: Rect) -> Vec<(Place, Place)> {
    let facing = |from: f64, to: f64| {
        vec![((mark.left, from), (frame.left, to)), ((mark.right(), from), (frame.right(), to))]
    };
    if is_above(mark, frame) {
        return facing(mark.bottom(), frame.top);
    }
    if is_above(frame, mark) {
        return facing(mark.top, frame.bottom());
    }
    let starts_before = mark.left < frame.left;
    let ends_before = mark.right() < frame.right();
    let foot_is_lower = mark.bottom() > frame.bottom();
    let head_is_lower = mark.top > frame.top;
    let corners = [
        (starts_before != foot_is_lower, (mark.left, mark.bottom()), (frame.left, frame.bottom())),
        (starts_before == head_is_lower, (mark.left, mark.top), (frame.left, frame.top)),
        (
            ends_before == foot_is_lower,
            (mark.right(), mark.bottom()),
            (frame.right(), frame.bottom()),
        ),
        (ends_before != head_is_lower, (mark.right(), mark.top), (frame.right(), frame.top)),
    ];
    corners
        .into_iter()
        .filter(|(is_outermost, _, _)| *is_outermost)
        .map(|(_, from, to)| (from, to))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the mark at every side of the frame and at its corners, whatever is larger.
    #[test]
    fn connections_cross_neither_mark_nor_frame() {
        let frame = Rect::new(0.0, 0.0, 100.0, 60.0);
        let places = (-6..=6)
            .flat_map(|x| (-6..=6).map(move |y| (31.0 * f64::from(x), 23.0 * f64::from(y))));
        for ((left, top), size) in places.flat_map(|at| [8.0, 150.0].map(|size| (at, size))) {
            let mark = Rect::new(left, top, size, 0.7 * size);
            if mark.overlaps(&frame) {
                continue;
            }
            let lines = connections(mark, frame);
            assert_eq!(lines.len(), 2, "{mark:?}");
            for (from, to) in lines {
                for rect in [mark, frame] {
                    assert!(rect.grown(-0.5).cut(from, to).is_none(), "{mark:?}: {from:?} {to:?}");
                }
            }
        }
    }
}
