//! Legend of the series and of the classes of a heat map.

use super::drawing::{Anchor, Drawing, Lettering};
use super::geometry::{Place, Rect};
use super::palette::{INK, Stroke};
use super::panel::Panel;
use super::series::Trace;
use super::text::{self, Weight};

const SIZE: f64 = 11.0;
const SWATCH: f64 = 20.0;
const BETWEEN: f64 = 16.0;
pub(super) const ROW_HEIGHT: f64 = 17.0;

/// Name for the legend with the look of what it names.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Named {
    label: String,
    stroke: Stroke,
    is_dotted: bool,
}

impl Named {
    /// All names of a panel: the classes of its heat map, then its series.
    pub(super) fn all(panel: &Panel) -> Vec<Self> {
        let classes = panel.heat.iter().flat_map(|heat| heat.classes()).enumerate();
        let classes = classes.map(|(class, label)| Self {
            label: label.clone(),
            stroke: Stroke::of_class(class),
            is_dotted: false,
        });
        let series = panel.series.iter().map(|series| Self {
            label: series.label.clone(),
            stroke: Stroke::of(series),
            is_dotted: series.trace == Trace::Dots,
        });
        classes.chain(series).filter(|named| !named.label.trim().is_empty()).collect()
    }
}

/// Name in the legend as it is drawn, with its width.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    named: Named,
    width: f64,
}

/// Names in rows no wider than a given room.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Legend {
    rows: Vec<Vec<Entry>>,
}

impl Legend {
    pub(super) fn of(names: &[Named], room: f64) -> Self {
        let mut rows: Vec<Vec<Entry>> = Vec::new();
        let mut left = 0.0;
        for named in names {
            let label = text::fitted(&named.label, SIZE, Weight::Regular, room - SWATCH - 6.0);
            let width = SWATCH + 6.0 + text::width(&label, SIZE, Weight::Regular);
            let entry = Entry { named: Named { label, ..named.clone() }, width };
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

    pub(super) fn draw(&self, drawing: &mut Drawing, (left, top): Place) {
        for (index, row) in self.rows.iter().enumerate() {
            let baseline = top + (index as f64 + 1.0) * ROW_HEIGHT - 5.0;
            let mut x = left;
            for Entry { named: Named { label, stroke, is_dotted }, width } in row {
                let y = baseline - 0.36 * SIZE;
                if *is_dotted {
                    drawing.dots(vec![(x + 0.5 * SWATCH, y)], stroke.colour, 4.0);
                } else {
                    let stroke = Stroke { width: stroke.width.max(1.8), ..*stroke };
                    drawing.lines(&[((x, y), (x + SWATCH, y))], stroke);
                }
                let lettering = Lettering::new(SIZE, INK, Anchor::Start);
                drawing.text((x + SWATCH + 6.0, baseline), lettering, label);
                x += width + BETWEEN;
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

    pub(super) fn of(title: &str, names: &[Named], room: f64) -> Self {
        let title = text::fitted(title, Self::SIZE, Weight::Bold, room);
        let legend = Legend::of(names, room);
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
    pub(super) fn draw(&self, drawing: &mut Drawing, frame: Rect) {
        let top = frame.top - self.height();
        let lettering =
            Lettering { weight: Weight::Bold, ..Lettering::new(Self::SIZE, INK, Anchor::Start) };
        drawing.text((frame.left, top + ROW_HEIGHT - 5.0), lettering, &self.title);
        let place = match (self.shares_row, self.legend.width_of_single_row()) {
            (true, Some(width)) => (frame.right() - width, top),
            (true, None) => (frame.left, top),
            (false, _) => (frame.left, top + ROW_HEIGHT),
        };
        self.legend.draw(drawing, place);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heat::HeatMap;
    use crate::series::Series;

    fn names(series: impl IntoIterator<Item = Series>) -> Vec<Named> {
        Named::all(&series.into_iter().fold(Panel::default(), Panel::with_series))
    }

    #[test]
    fn the_classes_of_a_heat_map_stand_before_the_series() {
        let heat = HeatMap::of_classes(2, vec![0.0, 1.0], &["dark", "light"]);
        let panel = Panel::default().with_heat(heat).with_series(Series::line("limit", 0, vec![]));
        let named = Named::all(&panel);
        let labels: Vec<&str> = named.iter().map(|named| named.label.as_str()).collect();
        assert_eq!(labels, ["dark", "light", "limit"]);
        assert!(named[0].stroke.width > named[2].stroke.width);
        assert_ne!(named[0].stroke.colour, named[1].stroke.colour);
        assert!(Named::all(&Panel::default().with_heat(HeatMap::new(1, vec![1.0]))).is_empty());
    }

    #[test]
    fn many_names_take_several_rows_within_the_room() {
        let series = (0..30).map(|index| Series::line(format!("series {index}"), index, vec![]));
        let legend = Legend::of(&names(series), 400.0);
        assert!(legend.rows.len() > 3);
        assert!(legend.rows.iter().all(|row| row_width(row) <= 400.0));
        let long = Legend::of(&names([Series::line("x".repeat(500), 0, Vec::new())]), 400.0);
        assert!(long.width_of_single_row().unwrap() <= 400.0);
        assert!(Legend::of(&names([Series::default()]), 400.0).rows.is_empty());
    }

    #[test]
    fn a_heading_shares_its_row_only_where_both_fit() {
        let series = names([Series::line("with control", 0, Vec::new())]);
        let wide = Heading::of("(a) position", &series, 600.0);
        let narrow = Heading::of("(a) position", &series, 150.0);
        assert!(wide.shares_row && !narrow.shares_row);
        assert!(narrow.height() > wide.height());
    }
}
