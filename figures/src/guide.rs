//! Reference lines: a level, a limit, the moment of an event.

/// Direction of a guide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Along the abscissa, at one ordinate.
    Horizontal,
    /// Along the ordinate, at one abscissa.
    Vertical,
}

/// Dashed grey line across a panel, with a label.
///
/// The panel's automatic range includes it; one outside a given range is not drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Guide {
    /// Direction of the line.
    pub direction: Direction,
    /// Its value on the other axis, in that axis's unit.
    pub at: f64,
    /// Text beside the line, placed where it covers least; may be empty.
    pub label: String,
}

impl Guide {
    /// A line along the abscissa at the ordinate `at`.
    pub fn horizontal(at: f64, label: impl Into<String>) -> Self {
        Self { direction: Direction::Horizontal, at, label: label.into() }
    }

    /// A line along the ordinate at the abscissa `at`.
    pub fn vertical(at: f64, label: impl Into<String>) -> Self {
        Self { direction: Direction::Vertical, at, label: label.into() }
    }
}
