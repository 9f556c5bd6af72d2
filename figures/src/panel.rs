//! Pair of axes with everything drawn on it.

use super::guide::{Direction, Guide};
use super::heat::HeatMap;
use super::inset::Inset;
use super::series::{Series, Trace};
use super::span::Span;

/// Form of the numbers of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Numbering {
    /// The numbers themselves.
    #[default]
    Plain,
    /// Logarithmic axis: the data are exponents of ten, the numbers at the axis are the powers.
    PowersOfTen,
}

/// Pair of axes with everything drawn on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Panel {
    /// Heading, such as "(a) position".
    pub title: String,
    /// Name and unit of the abscissa, such as "time, s".
    pub x_label: String,
    /// Name and unit of the ordinate, such as "position, mm".
    pub y_label: String,
    /// Range of the abscissa; by default the range of series and guides.
    pub x_range: Option<(f64, f64)>,
    /// Range of the ordinate; by default the range of series and guides, with a little room.
    pub y_range: Option<(f64, f64)>,
    /// Form of the numbers of the abscissa.
    pub x_numbers: Numbering,
    /// Form of the numbers of the ordinate.
    pub y_numbers: Numbering,
    /// Range of the abscissa that bears numbers; by default all of it.
    pub x_numbered: Option<(f64, f64)>,
    /// Range of the ordinate that bears numbers; by default all of it.
    pub y_numbered: Option<(f64, f64)>,
    /// Names instead of numbers at the ordinate; if empty, the numbers are written.
    pub rows: Vec<String>,
    /// Heat map below everything else, over the whole frame.
    pub heat: Option<HeatMap>,
    /// Curves, the first one lowest.
    pub series: Vec<Series>,
    /// Reference lines.
    pub guides: Vec<Guide>,
    /// Magnified part.
    pub inset: Option<Inset>,
}

impl Panel {
    /// Empty axes with a heading and labels that name the units.
    pub fn new(
        title: impl Into<String>,
        x_label: impl Into<String>,
        y_label: impl Into<String>,
    ) -> Self {
        Self {
            title: title.into(),
            x_label: x_label.into(),
            y_label: y_label.into(),
            ..Self::default()
        }
    }

    /// The same panel with one curve more, on top of the earlier ones.
    #[must_use]
    pub fn with_series(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// The same panel with one reference line more.
    #[must_use]
    pub fn with_guide(mut self, guide: Guide) -> Self {
        self.guides.push(guide);
        self
    }

    /// The same panel on a heat map.
    #[must_use]
    pub fn with_heat(mut self, heat: HeatMap) -> Self {
        self.heat = Some(heat);
        self
    }

    /// The same panel with these forms of the numbers of both axes.
    #[must_use]
    pub fn with_numbers(self, x_numbers: Numbering, y_numbers: Numbering) -> Self {
        Self { x_numbers, y_numbers, ..self }
    }

    /// The same panel with numbers within these ranges of the axes only, such as from the first to the last cell of a
    /// heat map whose frame reaches half a cell further.
    #[must_use]
    pub fn with_numbers_within(self, x: (f64, f64), y: (f64, f64)) -> Self {
        Self { x_numbered: Some(x), y_numbered: Some(y), ..self }
    }

    /// The same panel with named rows instead of an ordinate: row `i`, from the top, is at `y = −i`.
    #[must_use]
    pub fn with_rows(self, rows: Vec<String>) -> Self {
        let last = rows.len().saturating_sub(1) as f64;
        Self { rows, ..self.with_y_range(-last - 0.6, 0.6) }
    }

    /// The same panel with a magnified part.
    #[must_use]
    pub fn with_inset(mut self, inset: Inset) -> Self {
        self.inset = Some(inset);
        self
    }

    /// The same panel with a fixed range of the abscissa.
    #[must_use]
    pub fn with_x_range(mut self, low: f64, high: f64) -> Self {
        self.x_range = Some((low, high));
        self
    }

    /// The same panel with a fixed range of the ordinate; curves are cut off at the frame.
    #[must_use]
    pub fn with_y_range(mut self, low: f64, high: f64) -> Self {
        self.y_range = Some((low, high));
        self
    }

    pub(super) fn x_span(&self) -> Span {
        let points = self.finite_points().map(|(x, _)| x);
        let automatic = Span::of(points.chain(self.guides_along(Direction::Vertical)));
        // A curve may run from edge to edge; a dot on the edge would be cut in half.
        let has_dots = self
            .series
            .iter()
            .any(|series| series.trace == Trace::Dots || series.points.len() == 1);
        let has_bars = self.series.iter().any(|series| series.trace == Trace::Bars);
        let room = if has_dots { 0.03 } else { 0.0 };
        // A bar starts at the low edge; room at the high edge shows where it ends.
        let shown = |span: Span| if has_bars { span.beyond(0.03) } else { span.padded(room) };
        Span::given(self.x_range)
            .or_else(|| automatic.map(|span| shown(span.readable())))
            .unwrap_or(Span::UNIT)
    }

    pub(super) fn y_span(&self, x: Span) -> Span {
        Span::given(self.y_range)
            .or_else(|| {
                let points =
                    self.finite_points().filter(|point| x.contains(point.0)).map(|(_, y)| y);
                Span::of(points.chain(self.guides_along(Direction::Horizontal)))
                    .map(|span| span.readable().padded(0.05))
            })
            .unwrap_or(Span::UNIT)
    }

    /// Range of the data alone, without guides, over `x`, for a magnified part.
    pub(super) fn data_span(&self, x: Span) -> Option<Span> {
        let points = self.finite_points().filter(|point| x.contains(point.0)).map(|(_, y)| y);
        Span::of(points).map(|span| span.readable().padded(0.08))
    }

    fn finite_points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.series
            .iter()
            .flat_map(|series| series.points.iter().copied())
            .filter(|(x, y)| x.is_finite() && y.is_finite())
    }

    fn guides_along(&self, direction: Direction) -> impl Iterator<Item = f64> {
        self.guides.iter().filter(move |guide| guide.direction == direction).map(|guide| guide.at)
    }
}
