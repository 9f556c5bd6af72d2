//! PNG of a figure, painted mark by mark.

mod error;
mod letters;

use tiny_skia::{
    Color, ColorU8, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke as Pen,
    StrokeDash, Transform,
};

use super::drawing::{HALO, Join, Lettering, Mark};
use super::figure::Figure;
use super::geometry::{Place, Rect};
use super::page;
use super::palette::{PAPER, Stroke, rgb};
use super::picture::Picture;
use super::png::png;

pub use error::ChartError;

/// Largest number of pixels of a picture.
pub const MOST_PIXELS: f64 = 1e8;

/// Level of the compression; above 1 a picture takes up to five times as long and is at most a third smaller.
const LEVEL: u8 = 1;

/// The filter of PNG that subtracts the line above.
const UP: u8 = 2;

impl Figure {
    /// The figure as a PNG, in the included typeface: what [`Figure::to_svg`] writes, painted.
    ///
    /// `scale` is the number of pixels per CSS pixel: 2 suits a screen, 4 suits print. Characters stand one after the
    /// other, from left to right and without ligatures.
    ///
    /// # Errors
    ///
    /// [`ChartError::Scale`] if the scale is not positive and finite, [`ChartError::TooLarge`] if
    /// the picture would have more than [`MOST_PIXELS`].
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
        Ok(pressed(&painter.pixels))
    }
}

/// PNG of opaque pixels, every line as its difference from the one above. The paper between marks makes most lines alike.
fn pressed(pixels: &Pixmap) -> Vec<u8> {
    let size = [pixels.width(), pixels.height()];
    let [width, height] = size.map(|side| side as usize);
    let mut above = vec![[0; 3]; width];
    let mut lines = vec![UP; height * (1 + 3 * width)];
    let rows = pixels.pixels().chunks_exact(width);
    for (line, row) in lines.chunks_exact_mut(1 + 3 * width).zip(rows) {
        let (differences, _) = line[1..].as_chunks_mut::<3>();
        for ((difference, pixel), above) in differences.iter_mut().zip(row).zip(&mut above) {
            let colour = [pixel.red(), pixel.green(), pixel.blue()];
            for part in 0..3 {
                difference[part] = colour[part].wrapping_sub(above[part]);
            }
            *above = colour;
        }
    }
    png(size, None, &lines, LEVEL)
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

    /// Paints the pixels whose middle lies in `area`, each in the colour there.
    fn bitmap(&mut self, area: Rect, picture: &Picture) {
        let [columns, rows] = picture.size().map(|side| side as usize);
        let [width, height] = [self.pixels.width(), self.pixels.height()];
        let across = cells(width, self.scale.sx, area.left, area.width, columns);
        let down = cells(height, self.scale.sy, area.top, area.height, rows);
        let pixels = self.pixels.pixels_mut();
        for (y, row) in down {
            let (line, colours) =
                (&mut pixels[y * width as usize..], &picture.colours()[row * columns..]);
            for &(x, column) in &across {
                let [red, green, blue] = colours[column];
                line[x] = ColorU8::from_rgba(red, green, blue, 255).premultiply();
            }
        }
    }
}

/// The pixels of a line of `size` whose middle lies in an area from `start` on, `length` long, and the cell of each, one of `count`.
fn cells(size: u32, scale: f32, start: f64, length: f64, count: usize) -> Vec<(usize, usize)> {
    let at = |pixel: u32| ((f64::from(pixel) + 0.5) / f64::from(scale) - start) / length;
    let inside = (0..size).map(|pixel| (pixel as usize, at(pixel)));
    let inside = inside.filter(|(_, at)| (0.0..1.0).contains(at));
    inside.map(|(pixel, at)| (pixel, (at * count as f64) as usize)).collect()
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

fn colour(name: &str) -> Color {
    let [red, green, blue] = rgb(name);
    Color::from_rgba8(red, green, blue, 255)
}
