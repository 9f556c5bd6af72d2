//! Magnified part of a panel.

/// Place of the magnified part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Placement {
    /// Inside the panel if a corner is free of data, beside it otherwise.
    #[default]
    Automatic,
    /// Inside the panel, in the corner where it covers least.
    Inside,
    /// To the right of the panel, which becomes narrower.
    Beside,
}

/// Magnified part of a panel; the magnified range is marked in the panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inset {
    /// Range of the abscissa that is magnified; an inset whose range is not finite is left out.
    pub x_range: (f64, f64),
    /// Range of the ordinate; by default the range of the data within `x_range`.
    pub y_range: Option<(f64, f64)>,
    /// Place of the magnified part.
    pub placement: Placement,
}

impl Inset {
    /// Magnifies the abscissae from `low` to `high`.
    #[must_use]
    pub fn over(low: f64, high: f64) -> Self {
        Self { x_range: (low, high), y_range: None, placement: Placement::Automatic }
    }

    /// The same inset, magnifying the ordinates from `low` to `high`.
    #[must_use]
    pub fn with_y_range(self, low: f64, high: f64) -> Self {
        Self { y_range: Some((low, high)), ..self }
    }

    /// The same inset, drawn at `placement`.
    #[must_use]
    pub fn placed(self, placement: Placement) -> Self {
        Self { placement, ..self }
    }
}
