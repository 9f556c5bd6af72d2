//! PNG of a figure, painted mark by mark.

mod error;
mod letters;

use tiny_skia::{
    Color, FillRule, FilterQuality, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap,
    PixmapPaint, Stroke as Pen, StrokeDash, Transform,
};

use super::drawing::{HALO, Join, Lettering, Mark};
use super::figure::Figure;
use super::geometry::{Place, Rect};
use super::page;
use super::palette::{PAPER, Stroke};
use super::picture::Picture;

pub use error::ChartError;

/// Largest number of pixels of a picture.
pub const MOST_PIXELS: f64 = 1e8;

impl Figure {
    /// The figure as a PNG, in the included typeface: what [`Figure::to_svg`] writes, painted.
    ///
    /// `scale` is the number of pixels per CSS pixel: 2 suits a screen, 4 suits print. Characters stand one after the
    /// other, from left to right and without ligatures.
    ///
    /// # Errors
    ///
    /// [`ChartError::Scale`] if the scale is not positive and finite, [`ChartError::TooLarge`] if
    /// the picture would have more than [`MOST_PIXELS`]; the other one only if the encoder fails.
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>, ChartError> {
        if !(scale.is_finite() && scale > 0.0) {
            return Err(ChartError::Scale { scale });
        }
        let (drawing, size) = page::compose(self);
        let [width, height] = size.map(|side| (side * scale).ceil());
        if width * height > MOST_PIXELS {
            return Err(ChartError::TooLarge { width, height });
        }
        let mut pixels = Pixmap::new(width as u32, height as u32)
            .ok_or(ChartError::TooLarge { width, height })?;
        pixels.fill(colour(PAPER));
        let scale = Transform::from_scale(scale as f32, scale as f32);
        let mut painter = Painter { pixels, scale };
        drawing.marks.iter().for_each(|mark| painter.mark(mark));
        let png = painter.pixels.encode_png();
        png.map_err(|error| ChartError::Encoding { reason: error.to_string() })
    }
}

struct Painter {
    pixels: Pixmap,
    scale: Transform,
}

impl Painter {
    fn mark(&mut self, mark: &Mark) {
        match mark {
            Mark::Area { area, fill } => self.fill(rectangle(*area), fill, self.scale),
            Mark::Outline { area, stroke } => {
                self.stroke(
                    rectangle(*area),
                    stroke.colour,
                    &pen(*stroke, Join::Miter),
                    self.scale,
                );
            }
            Mark::Lines { lines, stroke, join } => {
                self.stroke(through(lines), stroke.colour, &pen(*stroke, *join), self.scale);
            }
            Mark::Dots { dots, colour, diameter } => {
                self.fill(circles(dots, *diameter), colour, self.scale);
            }
            Mark::Text { place, lettering, text } => self.text(*place, *lettering, text),
            Mark::Bitmap { area, picture, .. } => self.bitmap(*area, picture),
        }
    }

    /// Fills a path; nothing where there is none, or where it lies outside of all numbers.
    fn fill(&mut self, path: Option<Path>, colour: &str, transform: Transform) {
        if let Some(path) = path {
            self.pixels.fill_path(&path, &paint(colour), FillRule::Winding, transform, None);
        }
    }

    fn stroke(&mut self, path: Option<Path>, colour: &str, pen: &Pen, transform: Transform) {
        if let Some(path) = path {
            self.pixels.stroke_path(&path, &paint(colour), pen, transform, None);
        }
    }

    fn text(&mut self, (x, y): Place, lettering: Lettering, text: &str) {
        let outlines = letters::outlines(text, lettering);
        let at = self.scale.pre_translate(x as f32, y as f32);
        // A quarter of a turn, without a rounded sine.
        let upright = Transform::from_row(0.0, -1.0, 1.0, 0.0, 0.0, 0.0);
        let place = if lettering.upright { at.pre_concat(upright) } else { at };
        if lettering.halo {
            let halo = pen(Stroke::solid(PAPER, HALO), Join::Round);
            self.stroke(outlines.clone(), PAPER, &halo, place);
        }
        self.fill(outlines, lettering.colour, place);
    }

    fn bitmap(&mut self, area: Rect, picture: &Picture) {
        let [columns, rows] = picture.size();
        let Some(mut pixels) = Pixmap::new(columns, rows) else { return };
        for (pixel, [red, green, blue]) in pixels.pixels_mut().iter_mut().zip(picture.colours()) {
            *pixel = tiny_skia::ColorU8::from_rgba(*red, *green, *blue, 255).premultiply();
        }
        let sharp = PixmapPaint { quality: FilterQuality::Nearest, ..PixmapPaint::default() };
        let share = |side: f64, count: u32| (side / f64::from(count)) as f32;
        let place = self
            .scale
            .pre_translate(area.left as f32, area.top as f32)
            .pre_scale(share(area.width, columns), share(area.height, rows));
        self.pixels.draw_pixmap(0, 0, pixels.as_ref(), &sharp, place, None);
    }
}

fn rectangle(area: Rect) -> Option<Path> {
    let [left, top, width, height] =
        [area.left, area.top, area.width, area.height].map(|side| side as f32);
    tiny_skia::Rect::from_xywh(left, top, width, height).map(PathBuilder::from_rect)
}

fn through(lines: &[Vec<Place>]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for line in lines {
        for (index, (x, y)) in line.iter().enumerate() {
            match index {
                0 => path.move_to(*x as f32, *y as f32),
                _ => path.line_to(*x as f32, *y as f32),
            }
        }
    }
    path.finish()
}

fn circles(dots: &[Place], diameter: f64) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (x, y) in dots {
        path.push_circle(*x as f32, *y as f32, 0.5 * diameter as f32);
    }
    path.finish()
}

fn pen(stroke: Stroke, join: Join) -> Pen {
    let dashes = stroke.dash.split(' ').filter_map(|length| length.parse().ok()).collect();
    Pen {
        width: stroke.width as f32,
        line_cap: LineCap::Butt,
        line_join: match join {
            Join::Miter => LineJoin::Miter,
            Join::Round => LineJoin::Round,
        },
        dash: StrokeDash::new(dashes, 0.0),
        ..Pen::default()
    }
}

fn paint(name: &str) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(colour(name));
    paint
}

/// The colour of a name like `#1b204f`; black of any other.
fn colour(name: &str) -> Color {
    let number = name.strip_prefix('#').and_then(|digits| u32::from_str_radix(digits, 16).ok());
    let [_, red, green, blue] = number.unwrap_or_default().to_be_bytes();
    Color::from_rgba8(red, green, blue, 255)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_read_by_its_name() {
        assert_eq!(colour("#1b204f"), Color::from_rgba8(0x1b, 0x20, 0x4f, 255));
        assert_eq!(colour(PAPER), Color::WHITE);
    }
}
