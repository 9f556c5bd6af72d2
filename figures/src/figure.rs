//! Figure of one or several panels.

use super::data;
use super::markup;
use super::page;
use super::panel::Panel;

/// Figure of one or several panels, row by row.
///
/// The same figure always gives the same bytes, as SVG and as PNG.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Text above all panels; may be empty.
    pub title: String,
    /// Width of the drawing in CSS pixels, limited to 320 to 4000; the height follows.
    pub width: f64,
    /// Height of each frame in CSS pixels; by default it follows from the width.
    pub panel_height: Option<f64>,
    /// Panels side by side: 1 stacks them, 2 makes a grid of two columns.
    pub columns: usize,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
}

impl Default for Figure {
    fn default() -> Self {
        Self {
            title: String::new(),
            width: 720.0,
            panel_height: None,
            columns: 1,
            panels: Vec::new(),
        }
    }
}

impl Figure {
    /// A figure without panels, 720 pixels wide.
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// The same figure with one panel more.
    #[must_use]
    pub fn with_panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// The same figure with `columns` panels side by side.
    #[must_use]
    pub fn with_columns(self, columns: usize) -> Self {
        Self { columns, ..self }
    }

    /// The same figure, `width` CSS pixels wide.
    #[must_use]
    pub fn with_width(self, width: f64) -> Self {
        Self { width, ..self }
    }

    /// The same figure with frames `height` CSS pixels high.
    #[must_use]
    pub fn with_panel_height(self, height: f64) -> Self {
        Self { panel_height: Some(height), ..self }
    }

    /// The figure as an SVG document, on a white ground.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let (drawing, size) = page::compose(self);
        markup::document(&drawing, size, &self.title)
    }

    /// The figure's data for a page that draws it once more: JSON, deflated (RFC 1950), in base64.
    ///
    /// Panels with their ranges, guides and curves; `x` of a curve is an index into the lists of abscissae at the end. A
    /// coordinate that is not finite is null. Abscissae have nine digits, ordinates six; beyond 40 000 points together all
    /// long curves are thinned by the same share, and `thinned` is true. The elements of heat maps have four to two digits, the
    /// fewer the more there are; a ramp of very many has none.
    #[must_use]
    pub fn to_data(&self) -> String {
        data::packed(self)
    }
}
