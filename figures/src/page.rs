//! Layout of the page.

use super::axes::{self, Axes, Numbers, Side};
use super::curve::Curve;
use super::drawing::{Anchor, Drawing, Lettering};
use super::figure::Figure;
use super::geometry::Rect;
use super::heat::HeatMap;
use super::legend::{Heading, Legend, Named};
use super::magnifier;
use super::palette::{FAINT_INK, INK};
use super::panel::{Numbering, Panel};
use super::reference;
use super::span::Span;
use super::text::{self, Weight};
use super::ticks::Ticks;

const MARGIN: f64 = 14.0;
const BETWEEN_COLUMNS: f64 = 20.0;
const BETWEEN_ROWS: f64 = 14.0;
/// Room to the right of a frame, for half of its last number.
const OVERHANG: f64 = 14.0;
const NUMBER_SIZE: f64 = 11.0;
const LABEL_SIZE: f64 = 12.0;
const TITLE_SIZE: f64 = 15.0;

/// Panel with the ranges and widths that its layout depends on.
#[derive(Debug)]
struct Cell<'a> {
    panel: &'a Panel,
    x: Span,
    y: Span,
    y_ticks: Ticks,
    /// Room to the left of the frame for the label, and for what the numbers leave out.
    label: f64,
    note: f64,
}

/// The division of the page into columns of equal width.
#[derive(Debug)]
struct Grid<'a> {
    cells: Vec<Cell<'a>>,
    columns: usize,
    cell_width: f64,
    frame_height: f64,
}

/// Number of panels side by side, and height of a frame.
pub(super) fn layout(figure: &Figure) -> (usize, f64) {
    let grid = Grid::of(figure, width(figure));
    (grid.columns, grid.frame_height)
}

fn width(figure: &Figure) -> f64 {
    if figure.width.is_nan() { 720.0 } else { figure.width.clamp(320.0, 4000.0) }
}

/// The drawing of a figure, its width and its height.
pub(super) fn compose(figure: &Figure) -> (Drawing, [f64; 2]) {
    let width = width(figure);
    let grid = Grid::of(figure, width);
    let mut drawing = Drawing::default();
    let left = MARGIN + grid.gutter(0);
    let room = width - left - MARGIN - OVERHANG;
    let mut top = MARGIN;
    for line in text::wrapped(&figure.title, TITLE_SIZE, Weight::Bold, room) {
        let lettering =
            Lettering { weight: Weight::Bold, ..Lettering::new(TITLE_SIZE, INK, Anchor::Start) };
        drawing.text((left, top + TITLE_SIZE), lettering, &line);
        top += TITLE_SIZE + 6.0;
    }
    if !figure.title.trim().is_empty() {
        top += 5.0;
    }
    let is_shared = has_shared_legend(&figure.panels);
    if is_shared {
        let legend = Legend::of(&Named::all(&figure.panels[0]), room);
        legend.draw(&mut drawing, (left, top));
        top += legend.height() + 4.0;
    }
    for (index, row) in grid.cells.chunks(grid.columns).enumerate() {
        if index > 0 {
            top += BETWEEN_ROWS;
        }
        top += grid.draw_row(&mut drawing, row, top, is_shared);
    }
    (drawing, [width, (top + MARGIN).max(40.0).ceil()])
}

/// Whether every panel has the same legend, so that one legend above all of them is enough.
fn has_shared_legend(panels: &[Panel]) -> bool {
    let Some((first, others)) = panels.split_first() else {
        return false;
    };
    let expected = Named::all(first);
    !others.is_empty()
        && !expected.is_empty()
        && others.iter().all(|panel| Named::all(panel) == expected)
}

impl<'a> Grid<'a> {
    fn of(figure: &'a Figure, width: f64) -> Self {
        const NARROWEST: f64 = 240.0;
        let most = ((width / NARROWEST) as usize).max(1);
        let columns = figure.columns.clamp(1, most).min(figure.panels.len().max(1));
        let gaps = (columns - 1) as f64 * BETWEEN_COLUMNS;
        let cell_width = (width - 2.0 * MARGIN - gaps) / columns as f64;
        let share = match (columns, figure.panels.len()) {
            (1, 1) => 0.46,
            (1, _) => 0.28,
            _ => 0.52,
        };
        let frame_height = figure
            .panel_height
            .filter(|height| height.is_finite())
            .unwrap_or((share * cell_width).max(130.0))
            .clamp(80.0, 2000.0);
        let cells = figure.panels.iter().map(|panel| Cell::of(panel, frame_height)).collect();
        Self { cells, columns, cell_width, frame_height }
    }

    /// Room to the left of every frame of a column, so that the frames line up.
    fn gutter(&self, column: usize) -> f64 {
        // Labels stand beside the widest numbers of the column, whichever panel has these.
        let label = self.widest(column, |cell| cell.label);
        let numbers = self.numbers_width(column) + 8.0;
        let note = self.widest(column, |cell| cell.note);
        (label + numbers).max(note).min(0.6 * self.cell_width)
    }

    /// Width of the numbers of a column, so that the labels beside them line up.
    fn numbers_width(&self, column: usize) -> f64 {
        self.widest(column, |cell| axes::widest(&cell.y_ticks, NUMBER_SIZE))
    }

    fn widest(&self, column: usize, width: impl Fn(&Cell<'a>) -> f64) -> f64 {
        self.cells.iter().skip(column).step_by(self.columns).map(width).fold(0.0, f64::max)
    }

    /// Draws one row of panels and returns its height.
    fn draw_row(&self, drawing: &mut Drawing, row: &[Cell<'a>], top: f64, is_shared: bool) -> f64 {
        let frames: Vec<(f64, f64)> = (0..row.len())
            .map(|column| {
                let gutter = self.gutter(column);
                let start = MARGIN + column as f64 * (self.cell_width + BETWEEN_COLUMNS);
                (start + gutter, self.cell_width - gutter - OVERHANG)
            })
            .collect();
        let headings: Vec<Heading> = row
            .iter()
            .zip(&frames)
            .map(|(cell, (_, width))| cell.heading(*width, is_shared))
            .collect();
        let heading_height = row
            .iter()
            .zip(&headings)
            .map(|(cell, heading)| cell.room_above(heading))
            .fold(0.0, f64::max);
        let frame_top = top + heading_height;
        for (index, (cell, heading)) in row.iter().zip(&headings).enumerate() {
            let (left, width) = frames[index];
            let area = Rect::new(left, frame_top, width, self.frame_height);
            heading.draw(drawing, area);
            cell.draw(drawing, area, self.numbers_width(index));
        }
        let room_below = row.iter().map(Cell::room_below).fold(0.0, f64::max);
        heading_height + self.frame_height + room_below
    }
}

/// The part of an axis that bears numbers, and its length on the page: all of it, or as much of a given range as the axis
/// shows.
fn numbered(axis: Span, range: Option<(f64, f64)>, length: f64) -> (Span, f64) {
    let part = Span::given(range).and_then(|range| {
        Span::given(Some((range.low.max(axis.low), range.high.min(axis.high))))
            .filter(|_| range.low <= axis.high && range.high >= axis.low)
    });
    let Some(part) = part else { return (axis, length) };
    (part, length * (part.half_width() / axis.half_width()).min(1.0))
}

impl<'a> Cell<'a> {
    fn of(panel: &'a Panel, frame_height: f64) -> Self {
        let x = panel.x_span();
        let y = panel.y_span(x);
        let y_ticks = match panel.rows.as_slice() {
            [] => {
                let (span, height) = numbered(y, panel.y_numbered, frame_height);
                axes::y_ticks(span, panel.y_numbers, height, NUMBER_SIZE)
            }
            rows => Ticks::named(rows),
        };
        let label = if panel.y_label.trim().is_empty() { 0.0 } else { LABEL_SIZE + 7.0 };
        let note = text::width(&y_ticks.note, NUMBER_SIZE, Weight::Regular) + 10.0;
        Self { panel, x, y, y_ticks, label, note }
    }

    fn heading(&self, width: f64, is_shared: bool) -> Heading {
        let names = if is_shared { Vec::new() } else { Named::all(self.panel) };
        Heading::of(&self.panel.title, &names, width)
    }

    fn room_above(&self, heading: &Heading) -> f64 {
        let note = if self.y_ticks.note.is_empty() { 0.0 } else { NUMBER_SIZE + 9.0 };
        heading.height().max(note)
    }

    fn room_below(&self) -> f64 {
        // With the most numbers that an axis can have, a factor beside the label is the likeliest.
        let is_plain = self.panel.x_numbers == Numbering::Plain;
        let has_note = is_plain && !Ticks::within(self.x, 12).note.is_empty();
        let has_label = has_note || !self.panel.x_label.trim().is_empty();
        let label = if has_label { LABEL_SIZE + 6.0 } else { 0.0 };
        NUMBER_SIZE + 8.0 + label
    }

    fn draw(&self, drawing: &mut Drawing, area: Rect, numbers_width: f64) {
        let room = self.panel.heat.as_ref().map_or(0.0, HeatMap::key_room);
        let area = Rect { width: area.width - room, ..area };
        let whole = Axes { area, x: self.x, y: self.y };
        let (main, magnifier) = magnifier::arrange(self.panel, whole);
        let (span, width) = numbered(self.x, self.panel.x_numbered, main.area.width);
        let numbers = Numbers {
            x: axes::x_ticks(span, self.panel.x_numbers, width, NUMBER_SIZE),
            y: self.y_ticks.clone(),
            size: NUMBER_SIZE,
            side: Side::Left,
            halo: false,
        };
        let curves = Curve::all(&self.panel.series, &main);
        match &self.panel.heat {
            Some(heat) => {
                heat.draw(drawing, main.area);
                heat.draw_key(drawing, main.area);
            }
            None => axes::draw_grid(drawing, &main, &numbers),
        }
        reference::draw_lines(drawing, &self.panel.guides, &main);
        if let Some(magnifier) = &magnifier {
            magnifier.draw_connections(drawing);
        }
        for curve in &curves {
            curve.draw(drawing);
        }
        axes::draw_frame(drawing, &main, &numbers);
        let mut taken = Vec::new();
        if let Some(magnifier) = &magnifier {
            magnifier.draw(drawing, self.panel);
            taken.push(magnifier.outer);
            taken.extend(magnifier.mark);
        }
        reference::draw_labels(drawing, &self.panel.guides, &main, &curves, taken);
        let has_heat = self.panel.heat.as_ref().is_some_and(|heat| !heat.is_empty());
        if curves.iter().all(Curve::is_empty) && !has_heat {
            let centre = (area.left + 0.5 * area.width, area.top + 0.5 * area.height);
            let lettering = Lettering::new(LABEL_SIZE, FAINT_INK, Anchor::Middle);
            drawing.text(centre, lettering, "no data in this range");
        }
        self.draw_labels(drawing, area, &main, &numbers);
        self.draw_y_label(drawing, area, numbers_width);
    }

    /// Writes the names of the axes and the factors and offsets that their numbers leave out.
    ///
    /// A magnified part beside the frame shares the name of the abscissa, unless a factor of the
    /// frame's own numbers stands between.
    fn draw_labels(&self, drawing: &mut Drawing, whole: Rect, main: &Axes, numbers: &Numbers) {
        let frame = main.area;
        let baseline = frame.bottom() + NUMBER_SIZE + LABEL_SIZE + 11.0;
        let note = Lettering::new(NUMBER_SIZE, FAINT_INK, Anchor::End);
        drawing.text((frame.left - 9.0, frame.top - 10.0), note, &numbers.y.note);
        drawing.text((frame.right(), baseline), note, &numbers.x.note);

        let note_width = text::width(&numbers.x.note, NUMBER_SIZE, Weight::Regular);
        let (width, room) = if note_width > 0.0 {
            (frame.width, frame.width - note_width - 12.0)
        } else {
            (whole.width, whole.width)
        };
        let label = text::fitted(&self.panel.x_label, LABEL_SIZE, Weight::Regular, room);
        let half = 0.5 * text::width(&label, LABEL_SIZE, Weight::Regular);
        let centre = (frame.left + 0.5 * width).min(frame.left + room - half);
        let lettering = Lettering::new(LABEL_SIZE, INK, Anchor::Middle);
        drawing.text((centre, baseline), lettering, &label);
    }

    /// Writes the name of the ordinate to the left of the widest numbers of the column.
    fn draw_y_label(&self, drawing: &mut Drawing, frame: Rect, numbers_width: f64) {
        let label = text::fitted(&self.panel.y_label, LABEL_SIZE, Weight::Regular, frame.height);
        let place = (frame.left - numbers_width - 13.0, frame.top + 0.5 * frame.height);
        let lettering =
            Lettering { upright: true, ..Lettering::new(LABEL_SIZE, INK, Anchor::Middle) };
        drawing.text(place, lettering, &label);
    }
}
