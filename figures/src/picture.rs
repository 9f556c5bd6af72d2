//! Bitmap as a PNG within a link, a hundredth of the size of the same elements as rectangles.

use std::collections::BTreeSet;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::png::png;

/// Level of the compression; above 6 it takes longer and gains next to nothing.
pub(super) const LEVEL: u8 = 6;

/// Bitmap of colours, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Picture {
    size: [u32; 2],
    colours: Vec<[u8; 3]>,
}

impl Picture {
    /// The bitmap of `colour`s (red, green, blue) by column and row from the top left; none if it has no pixels, or more
    /// columns or rows than a PNG can count.
    pub(super) fn of(
        columns: usize,
        rows: usize,
        colour: impl Fn(usize, usize) -> [u8; 3],
    ) -> Option<Self> {
        let size = [u32::try_from(columns).ok()?, u32::try_from(rows).ok()?];
        if size.contains(&0) {
            return None;
        }
        let colours = (0..rows * columns).map(|index| colour(index % columns, index / columns));
        Some(Self { size, colours: colours.collect() })
    }

    /// Columns and rows.
    #[cfg(feature = "png")]
    pub(super) fn size(&self) -> [u32; 2] {
        self.size
    }

    #[cfg(feature = "png")]
    pub(super) fn colours(&self) -> &[[u8; 3]] {
        &self.colours
    }

    /// Link to it, with `data:`.
    pub(super) fn link(&self) -> String {
        let palette: Vec<[u8; 3]> =
            self.colours.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        let is_small = palette.len() <= 256;
        let columns = self.size[0] as usize;
        let mut lines = Vec::with_capacity(self.colours.len() / columns + 3 * self.colours.len());
        for line in self.colours.chunks(columns) {
            // The filter of the line is none.
            lines.push(0);
            for colour in line {
                match palette.binary_search(colour) {
                    Ok(index) if is_small => lines.push(index as u8),
                    _ => lines.extend(colour),
                }
            }
        }
        let palette = is_small.then(|| palette.concat());
        let bytes = png(self.size, palette.as_deref(), &lines, LEVEL);
        format!("data:image/png;base64,{}", STANDARD.encode(bytes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_bitmap_is_without_pixels() {
        assert_eq!(Picture::of(0, 3, |_, _| [0; 3]), None);
        assert_eq!(Picture::of(3, 0, |_, _| [0; 3]), None);
    }

    #[cfg(feature = "png")]
    #[test]
    fn another_reader_finds_every_pixel() {
        let few = |column: usize, row: usize| [7 * column as u8, 11 * row as u8, 200];
        // More colours than a palette holds.
        let many =
            |column: usize, row: usize| [7 * column as u8, 11 * row as u8, (column * row) as u8];
        read_back(9, 20, few);
        read_back(30, 20, many);
    }

    #[cfg(feature = "png")]
    fn read_back(columns: usize, rows: usize, colour: impl Fn(usize, usize) -> [u8; 3]) {
        use tiny_skia::Pixmap;

        let link = Picture::of(columns, rows, &colour).unwrap().link();
        let text = link.strip_prefix("data:image/png;base64,").unwrap();
        let picture = Pixmap::decode_png(&STANDARD.decode(text).unwrap()).unwrap();
        assert_eq!((picture.width(), picture.height()), (columns as u32, rows as u32));
        for (index, pixel) in picture.pixels().iter().enumerate() {
            let found = [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()];
            let [red, green, blue] = colour(index % columns, index / columns);
            assert_eq!(found, [red, green, blue, 255], "{index}");
        }
    }
}
