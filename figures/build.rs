//! The typeface that drawings are set in, DejaVu Sans, without what they do not use: names, pairs that are moved together,
//! ligatures, and the programs that fit outlines to the pixels of a screen. Every letter keeps its outline and its width.

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

use dejavu::sans;

/// Tables that tell a character's glyph, its width and its outline.
const KEPT: [&[u8; 4]; 5] = [b"cmap", b"head", b"hhea", b"hmtx", b"maxp"];

// Flags of a part of a compound glyph.
const WORDS: u16 = 0x1;
const SCALED: u16 = 0x8;
const MORE: u16 = 0x20;
const SCALED_TWICE: u16 = 0x40;
const TURNED: u16 = 0x80;
const PROGRAM: u16 = 0x100;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let folder = PathBuf::from(env::var_os("OUT_DIR").ok_or("there is no folder to write to")?);
    for (name, whole) in [("regular.ttf", sans::regular()), ("bold.ttf", sans::bold())] {
        let lean = lean(whole).ok_or("the typeface is not laid out as expected")?;
        fs::write(folder.join(name), lean)?;
    }
    Ok(())
}

fn lean(font: &[u8]) -> Option<Vec<u8>> {
    // Places of glyphs as numbers of four bytes.
    if number(table(font, b"head")?, 50)? != 1 {
        return None;
    }
    let (outlines, places) = outlines(table(font, b"glyf")?, table(font, b"loca")?)?;
    let mut tables = vec![(b"glyf", &outlines[..]), (b"loca", &places)];
    for tag in KEPT {
        tables.push((tag, table(font, tag)?));
    }
    tables.sort_unstable();
    Some(written(&tables))
}

/// The file with these tables. Its checksums, and the numbers for a binary search, are left at 0: nothing here reads them.
fn written(tables: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut file = vec![0, 1, 0, 0, 0, tables.len() as u8, 0, 0, 0, 0, 0, 0];
    let mut place = file.len() + 16 * tables.len();
    for (tag, table) in tables {
        file.extend_from_slice(*tag);
        file.extend([0; 4]);
        file.extend((place as u32).to_be_bytes());
        file.extend((table.len() as u32).to_be_bytes());
        place += table.len().next_multiple_of(4);
    }
    for (_, table) in tables {
        file.extend_from_slice(table);
        file.resize(file.len().next_multiple_of(4), 0);
    }
    file
}

/// All glyphs without their programs, and the place of each.
fn outlines(glyphs: &[u8], places: &[u8]) -> Option<(Vec<u8>, Vec<u8>)> {
    let places: Vec<usize> = places.chunks_exact(4).map(|it| long(it, 0)).collect::<Option<_>>()?;
    let (mut lean, mut starts) = (Vec::new(), vec![0; 4]);
    for pair in places.windows(2) {
        let glyph = glyphs.get(pair[0]..pair[1])?;
        if !glyph.is_empty() {
            // The number of contours, or a negative one for a glyph that is made of others.
            let contours = number(glyph, 0)?;
            let is_simple = contours < 0x8000;
            lean.extend(if is_simple { simple(glyph, contours)? } else { compound(glyph)? });
        }
        starts.extend((lean.len() as u32).to_be_bytes());
    }
    Some((lean, starts))
}

fn simple(glyph: &[u8], contours: u16) -> Option<Vec<u8>> {
    let end = 10 + 2 * usize::from(contours);
    let points = end + 2 + usize::from(number(glyph, end)?);
    Some([glyph.get(..end)?, &[0, 0], glyph.get(points..)?].concat())
}

fn compound(glyph: &[u8]) -> Option<Vec<u8>> {
    let mut lean = glyph.get(..10)?.to_vec();
    loop {
        let start = lean.len();
        let flags = number(glyph, start)?;
        let mut length = if flags & WORDS != 0 { 8 } else { 6 };
        for (flag, more) in [(SCALED, 2), (SCALED_TWICE, 4), (TURNED, 8)] {
            length += if flags & flag != 0 { more } else { 0 };
        }
        lean.extend((flags & !PROGRAM).to_be_bytes());
        lean.extend_from_slice(glyph.get(start + 2..start + length)?);
        if flags & MORE == 0 {
            return Some(lean);
        }
    }
}

fn table<'a>(font: &'a [u8], tag: &[u8; 4]) -> Option<&'a [u8]> {
    let count = usize::from(number(font, 4)?);
    let entry = font.get(12..12 + 16 * count)?.chunks_exact(16).find(|it| it.starts_with(tag))?;
    let place = long(entry, 8)?;
    font.get(place..place + long(entry, 12)?)
}

fn number(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..)?.first_chunk().map(|it| u16::from_be_bytes(*it))
}

fn long(bytes: &[u8], at: usize) -> Option<usize> {
    bytes.get(at..)?.first_chunk().map(|it| u32::from_be_bytes(*it) as usize)
}
