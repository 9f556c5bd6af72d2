//! PNG of a figure, rasterised from its SVG.

mod error;

use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Source};
use resvg::usvg::{Options, Tree};

use super::figure::Figure;
use super::text::Weight;

pub use error::ChartError;

/// Largest number of pixels of a picture.
pub const MOST_PIXELS: f64 = 1e8;

impl Figure {
    /// The figure as a PNG, made from the SVG document with the included typeface.
    ///
    /// `scale` is the number of pixels per CSS pixel: 2 suits a screen, 4 suits print.
    ///
    /// # Errors
    ///
    /// [`ChartError::Scale`] if the scale is not positive and finite, [`ChartError::TooLarge`] if
    /// the picture would have more than [`MOST_PIXELS`]; the other two only if the rasteriser fails.
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>, ChartError> {
        png(&self.to_svg(), scale)
    }
}

fn png(svg: &str, scale: f64) -> Result<Vec<u8>, ChartError> {
    if !(scale.is_finite() && scale > 0.0) {
        return Err(ChartError::Scale { scale });
    }
    let tree = tree(svg)?;
    let width = (f64::from(tree.size().width()) * scale).ceil();
    let height = (f64::from(tree.size().height()) * scale).ceil();
    if width * height > MOST_PIXELS {
        return Err(ChartError::TooLarge { width, height });
    }
    let mut picture =
        Pixmap::new(width as u32, height as u32).ok_or(ChartError::TooLarge { width, height })?;
    // The drawing may cover the last row or column only in part, which must not become transparent.
    picture.fill(Color::WHITE);
    let enlarged = Transform::from_scale(scale as f32, scale as f32);
    resvg::render(&tree, enlarged, &mut picture.as_mut());
    picture.encode_png().map_err(|error| ChartError::Encoding { reason: error.to_string() })
}

pub(super) fn tree(svg: &str) -> Result<Tree, ChartError> {
    let options =
        Options { font_family: "DejaVu Sans".to_owned(), fontdb: database(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(|error| ChartError::Drawing { reason: error.to_string() })
}

/// The included typeface, so that a picture does not depend on the machine's fonts.
fn database() -> Arc<Database> {
    static DATABASE: OnceLock<Arc<Database>> = OnceLock::new();
    let fill = || {
        let mut database = Database::new();
        for weight in [Weight::Regular, Weight::Bold] {
            database.load_font_source(Source::Binary(Arc::new(weight.bytes())));
        }
        database.set_sans_serif_family("DejaVu Sans");
        Arc::new(database)
    };
    DATABASE.get_or_init(fill).clone()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_weights_of_the_typeface_are_there() {
        assert_eq!(database().len(), 2);
    }
}
