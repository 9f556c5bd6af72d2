//! PNG files (ISO/IEC 15948).

use miniz_oxide::deflate::compress_to_vec_zlib;

/// PNG of `lines`, every line after its filter byte: of 8-bit indices into the `palette`, or else of red, green and blue, 8 bits
/// each. The `level` of the compression is from 0 to 10.
pub(super) fn png(
    [columns, rows]: [u32; 2],
    palette: Option<&[u8]>,
    lines: &[u8],
    level: u8,
) -> Vec<u8> {
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    // 8 bits, the colour type, and 0 for compression, filter and interlace methods.
    let form = [8, if palette.is_some() { 3 } else { 2 }, 0, 0, 0];
    chunk(&mut bytes, b"IHDR", &[&columns.to_be_bytes()[..], &rows.to_be_bytes(), &form].concat());
    if let Some(palette) = palette {
        chunk(&mut bytes, b"PLTE", palette);
    }
    chunk(&mut bytes, b"IDAT", &compress_to_vec_zlib(lines, level));
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
}
