//! Data and drawing style of one curve.

/// Form in which the points of a series are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Trace {
    /// Straight lines from point to point.
    #[default]
    Line,
    /// Each value is held until the next point: a sampled-and-held quantity.
    Steps,
    /// One dot per point.
    Dots,
    /// A broad bar from each point to the next; a point that is not finite ends a bar.
    Bars,
}

/// Data and drawing style of one curve.
///
/// Points with a coordinate that is NaN or infinite are not drawn and leave a gap.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Name in the legend; a series with an empty name is left out of it.
    pub label: String,
    /// Index into [`PALETTE`](super::PALETTE); beyond its end the colours repeat with dashes.
    pub colour: usize,
    /// Abscissa and ordinate of each point, in the units that the axis labels name.
    pub points: Vec<(f64, f64)>,
    /// Form in which the points are drawn.
    pub trace: Trace,
    /// Draws the curve dashed, so that one beneath it stays visible.
    pub dashed: bool,
}

impl Series {
    /// A series drawn as straight lines from point to point.
    pub fn line(label: impl Into<String>, colour: usize, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), colour, points, ..Self::default() }
    }

    /// A series whose values are held until the next point.
    pub fn steps(label: impl Into<String>, colour: usize, points: Vec<(f64, f64)>) -> Self {
        Self { trace: Trace::Steps, ..Self::line(label, colour, points) }
    }

    /// A series drawn as one dot per point.
    pub fn dots(label: impl Into<String>, colour: usize, points: Vec<(f64, f64)>) -> Self {
        Self { trace: Trace::Dots, ..Self::line(label, colour, points) }
    }

    /// A series drawn as level bars, each from a start to an end at a height.
    pub fn bars(label: impl Into<String>, colour: usize, bars: &[(f64, f64, f64)]) -> Self {
        let points =
            bars.iter().flat_map(|(start, end, y)| [(*start, *y), (*end, *y), (f64::NAN, *y)]);
        Self { trace: Trace::Bars, ..Self::line(label, colour, points.collect()) }
    }

    /// The same series, drawn dashed.
    #[must_use]
    pub fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }
}
