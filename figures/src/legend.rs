//! Legend of the series.

use super::geometry::{Place, Rect};
use super::markup::{Anchor, Lettering, Markup};
use super::palette::{INK, Stroke};
use super::series::{Series, Trace};
use super::text::{self, Weight};

const SIZE: f64 = 11.0;
const SWATCH: f64 = 20.0;
const BETWEEN: f64 = 16.0;
pub(super) const ROW_HEIGHT: f64 = 17.0;

/// Name in the legend with a piece of its line.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    label: String,
    stroke: Stroke,
    is_dotted: bool,
    width: f64,
}

/// Names of the series, in rows no wider than a given room.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Legend {
    rows: Vec<Vec<Entry>>,
}

impl Legend {
    pub(super) fn of(series: &[Series], room: f64) -> Self {
        let mut rows: Vec<Vec<Entry>> = Vec::new();
        let mut left = 0.0;
        for series in series.iter().filter(|series| !series.label.trim().is_empty()) {
            let label = text::fitted(&series.label, SIZE, Weight::Regular, room - SWATCH - 6.0);
            let entry = Entry {
                width: SWATCH + 6.0 + text::width(&label, SIZE, Weight::Regular),
                label,
                stroke: Stroke::of(series),
                is_dotted: series.trace == Trace::Dots,
            };
            let end = left + entry.width;
            match rows.last_mut() {
                Some(row) if end <= room => row.push(entry),
                _ => {
                    left = 0.0;
                    rows.push(vec![entry]);
                }
            }
            left +=
                rows.last().and_then(|row| row.last()).map_or(0.0, |entry| entry.width) + BETWEEN;
        }
        Self { rows }
    }

    pub(super) fn height(&self) -> f64 {
        self.rows.len() as f64 * ROW_HEIGHT
    }

    /// Width of the only row, if there is only one.
    pub(super) fn width_of_single_row(&self) -> Option<f64> {
        match self.rows.as_slice() {
            [row] => Some(row_width(row)),
            _ => None,
        }
    }

    pub(super) fn draw(&self, markup: &mut Markup, (left, top): Place) {
        for (index, row) in self.rows.iter().enumerate() {
            let baseline = top + (index as f64 + 1.0) * ROW_HEIGHT - 5.0;
            let mut x = left;
            for entry in row {
                let y = baseline - 0.36 * SIZE;
                if entry.is_dotted {
                    markup.dots(&[(x + 0.5 * SWATCH, y)], entry.stroke.colour, 4.0);
                } else {
                    let stroke = Stroke { width: entry.stroke.width.max(1.8), ..entry.stroke };
                    markup.lines(&[((x, y), (x + SWATCH, y))], stroke);
                }
                let lettering = Lettering::new(SIZE, INK, Anchor::Start);
                markup.text((x + SWATCH + 6.0, baseline), lettering, &entry.label);
                x += entry.width + BETWEEN;
            }
        }
    }
}

fn row_width(row: &[Entry]) -> f64 {
    let gaps = row.len().saturating_sub(1) as f64 * BETWEEN;
    row.iter().map(|entry| entry.width).sum::<f64>() + gaps
}

/// Heading and legend above a frame, in one row where both fit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Heading {
    title: String,
    legend: Legend,
    shares_row: bool,
}

impl Heading {
    const SIZE: f64 = 12.5;
    const GAP: f64 = 5.0;

    pub(super) fn of(title: &str, series: &[Series], room: f64) -> Self {
        let title = text::fitted(title, Self::SIZE, Weight::Bold, room);
        let legend = Legend::of(series, room);
        let taken = text::width(&title, Self::SIZE, Weight::Bold) + 28.0;
        let shares_row = title.trim().is_empty()
            || legend.width_of_single_row().is_some_and(|width| taken + width <= room);
        Self { title, legend, shares_row }
    }

    pub(super) fn height(&self) -> f64 {
        let has_title = !self.title.trim().is_empty();
        let title = if has_title { ROW_HEIGHT } else { 0.0 };
        let rows = if self.shares_row {
            title.max(self.legend.height())
        } else {
            title + self.legend.height()
        };
        rows + Self::GAP
    }

    /// Draws the heading so that its foot stands on the top of the frame.
    pub(super) fn draw(&self, markup: &mut Markup, frame: Rect) {
        let top = frame.top - self.height();
        let lettering =
            Lettering { weight: Weight::Bold, ..Lettering::new(Self::SIZE, INK, Anchor::Start) };
        markup.text((frame.left, top + ROW_HEIGHT - 5.0), lettering, &self.title);
        let place = match (self.shares_row, self.legend.width_of_single_row()) {
            (true, Some(width)) => (frame.right() - width, top),
            (true, None) => (frame.left, top),
            (false, _) => (frame.left, top + ROW_HEIGHT),
        };
        self.legend.draw(markup, place);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_names_take_several_rows_within_the_room() {
        let series: Vec<Series> = (0..30)
            .map(|index| Series::line(format!("series {index}"), index, Vec::new()))
            .collect();
        let legend = Legend::of(&series, 400.0);
        assert!(legend.rows.len() > 3);
        assert!(legend.rows.iter().all(|row| row_width(row) <= 400.0));
        let long = Legend::of(&[Series::line("x".repeat(500), 0, Vec::new())], 400.0);
        assert!(long.width_of_single_row().unwrap() <= 400.0);
        assert!(Legend::of(&[Series::default()], 400.0).rows.is_empty());
    }

    #[test]
    fn a_heading_shares_its_row_only_where_both_fit() {
        let series = [Series::line("with control", 0, Vec::new())];
        let wide = Heading::of("(a) position", &series, 600.0);
        let narrow = Heading::of("(a) position", &series, 150.0);
        assert!(wide.shares_row && !narrow.shares_row);
        assert!(narrow.height() > wide.height());
    }
}
