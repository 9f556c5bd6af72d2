//! From SVG to PNG.

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::error::ChartError;
use super::text;

/// The largest picture, in pixels, that is made.
pub const MOST_PIXELS: f64 = 1e8;

pub(super) fn png(svg: &str, scale: f64) -> Result<Vec<u8>, ChartError> {
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
    // A last row or column that the drawing covers only in part must not show what lies behind.
    picture.fill(Color::WHITE);
    let enlarged = Transform::from_scale(scale as f32, scale as f32);
    resvg::render(&tree, enlarged, &mut picture.as_mut());
    picture.encode_png().map_err(|error| ChartError::Encoding { reason: error.to_string() })
}

pub(super) fn tree(svg: &str) -> Result<Tree, ChartError> {
    let options = Options {
        font_family: "DejaVu Sans".to_owned(),
        fontdb: text::database(),
        ..Options::default()
    };
    Tree::from_str(svg, &options).map_err(|error| ChartError::Drawing { reason: error.to_string() })
}
