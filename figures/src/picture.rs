//! Bitmap as a PNG within a link, a hundredth of the size of the same elements as rectangles.

use std::collections::BTreeSet;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec_zlib;

/// Level of the compression; above 6 it takes longer and gains next to nothing.
const LEVEL: u8 = 6;

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
        format!("data:image/png;base64,{}", STANDARD.encode(png(self.size, palette, &lines)))
    }
}

/// PNG (ISO/IEC 15948) of `lines`, every line after its filter byte: of 8-bit indices into the `palette`, or else of red,
/// green and blue, 8 bits each.
fn png([columns, rows]: [u32; 2], palette: Option<Vec<u8>>, lines: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    // 8 bits, the colour type, and 0 for compression, filter and interlace methods.
    let form = [8, if palette.is_some() { 3 } else { 2 }, 0, 0, 0];
    chunk(&mut bytes, b"IHDR", &[&columns.to_be_bytes()[..], &rows.to_be_bytes(), &form].concat());
    if let Some(palette) = palette {
        chunk(&mut bytes, b"PLTE", &palette);
    }
    chunk(&mut bytes, b"IDAT", &compress_to_vec_zlib(lines, LEVEL));
    chunk(&mut bytes, b"IEND", &[]);
    bytes
}

fn chunk(bytes: &mut Vec<u8>, name: &[u8; 4], content: &[u8]) {
    bytes.extend((content.len() as u32).to_be_bytes());
    let start = bytes.len();
    bytes.extend_from_slice(name);
    bytes.extend_from_slice(content);
    let check = crc32(&bytes[start..]);
    bytes.extend(check.to_be_bytes());
}

/// Cyclic redundancy check of PNG, bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |check, byte| {
        (0..8).fold(check ^ u32::from(*byte), |check, _| {
            (check >> 1) ^ (0xedb8_8320 & (check & 1).wrapping_neg())
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The check value of the catalogue of CRC algorithms (CRC-32/ISO-HDLC).
    #[test]
    fn the_check_is_the_published_one() {
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
    }

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
