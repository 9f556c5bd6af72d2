//! The typeface, and the widths of texts in it.

use ttf_parser::Face;

/// Font families of the drawing: the one wanted first, then substitutes of about its width and look.
pub(super) const FAMILIES: &str = "'DejaVu Sans', Verdana, Helvetica, Arial, sans-serif";

/// Weight of the typeface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Weight {
    Regular,
    Bold,
}

impl Weight {
    pub(super) fn bytes(self) -> &'static [u8] {
        match self {
            Self::Regular => include_bytes!(concat!(env!("OUT_DIR"), "/regular.ttf")),
            Self::Bold => include_bytes!(concat!(env!("OUT_DIR"), "/bold.ttf")),
        }
    }
}

/// The character itself, or the mark of replacement for one that cannot be seen or that XML does not allow.
pub(super) fn shown(character: char) -> char {
    match character {
        '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
        other if other.is_control() => '\u{fffd}',
        other => other,
    }
}

/// End of each character within a text, in bytes, and its width at a size, in units of the drawing.
pub(super) fn advances(text: &str, size: f64, weight: Weight) -> Vec<(usize, f64)> {
    let face = Face::parse(weight.bytes(), 0).ok();
    let share = |character: char| {
        let face = face.as_ref()?;
        let advance = face.glyph_hor_advance(face.glyph_index(character)?)?;
        Some(f64::from(advance) / f64::from(face.units_per_em()))
    };
    text.char_indices()
        .map(|(index, character)| {
            (index + character.len_utf8(), size * share(character).unwrap_or(0.6))
        })
        .collect()
}

/// Width of a text at a size, in units of the drawing.
pub(super) fn width(text: &str, size: f64, weight: Weight) -> f64 {
    advances(text, size, weight).iter().map(|(_, advance)| advance).sum()
}

/// The text itself if it fits into `room`, otherwise its beginning and an ellipsis.
pub(super) fn fitted(text: &str, size: f64, weight: Weight, room: f64) -> String {
    const ELLIPSIS: &str = "…";
    let advances = advances(text, size, weight);
    if advances.iter().map(|(_, advance)| advance).sum::<f64>() <= room {
        return text.to_owned();
    }
    let mut left = room - width(ELLIPSIS, size, weight);
    let mut end = 0;
    for (index, advance) in advances {
        left -= advance;
        if left < 0.0 {
            break;
        }
        end = index;
    }
    format!("{}{ELLIPSIS}", text[..end].trim_end())
}

/// The text in as many lines as it needs, no more than three.
pub(super) fn wrapped(text: &str, size: f64, weight: Weight, room: f64) -> Vec<String> {
    const MOST_LINES: usize = 3;
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let last_line = lines.len() == MOST_LINES;
        match lines.last_mut() {
            Some(line) if last_line || width(&format!("{line} {word}"), size, weight) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| fitted(line, size, weight, room)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Outline of a letter, as the reader tells it.
    #[derive(Debug, Default, PartialEq)]
    struct Outline(Vec<(char, [f32; 4])>);

    impl ttf_parser::OutlineBuilder for Outline {
        fn move_to(&mut self, x: f32, y: f32) {
            self.0.push(('m', [x, y, 0.0, 0.0]));
        }

        fn line_to(&mut self, x: f32, y: f32) {
            self.0.push(('l', [x, y, 0.0, 0.0]));
        }

        fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
            self.0.push(('q', [x1, y1, x, y]));
        }

        fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {
            unreachable!("the typeface has quadratic curves only");
        }

        fn close(&mut self) {
            self.0.push(('z', [0.0; 4]));
        }
    }

    #[test]
    fn every_letter_has_the_outline_and_the_width_of_the_whole_typeface() {
        for (weight, whole) in
            [(Weight::Regular, dejavu::sans::regular()), (Weight::Bold, dejavu::sans::bold())]
        {
            let faces = [weight.bytes(), whole].map(|bytes| Face::parse(bytes, 0).unwrap());
            let units = faces.each_ref().map(Face::units_per_em);
            assert_eq!(units[0], units[1]);
            let characters = ttf_parser::Tag::from_bytes(b"cmap");
            let [lean, all] = faces.each_ref().map(|face| face.raw_face().table(characters));
            assert_eq!(lean, all);
            assert!(faces[1].number_of_glyphs() > 6000);
            for glyph in (0..faces[1].number_of_glyphs()).map(ttf_parser::GlyphId) {
                let [lean, whole] = faces.each_ref().map(|face| {
                    let mut outline = Outline::default();
                    let bounds = face.outline_glyph(glyph, &mut outline);
                    (outline, bounds, face.glyph_hor_advance(glyph))
                });
                assert_eq!(lean, whole, "{glyph:?}");
            }
        }
    }

    #[test]
    fn the_shipped_typeface_is_read() {
        let narrow = width("iii", 12.0, Weight::Regular);
        let wide = width("mmm", 12.0, Weight::Regular);
        assert!(narrow > 5.0 && narrow < wide && wide < 40.0);
        assert!(width("mmm", 12.0, Weight::Bold) > wide);
    }

    #[test]
    fn a_text_too_long_is_cut_to_the_room() {
        assert_eq!(fitted("force", 12.0, Weight::Regular, 100.0), "force");
        let cut = fitted(&"force ".repeat(1000), 12.0, Weight::Regular, 100.0);
        assert!(cut.ends_with('…') && width(&cut, 12.0, Weight::Regular) <= 100.0);
        assert_eq!(fitted("äöü", 12.0, Weight::Regular, 0.0), "…");
    }

    #[test]
    fn a_long_title_takes_several_lines() {
        let lines = wrapped(&"contact ".repeat(100), 15.0, Weight::Bold, 300.0);
        assert_eq!(lines.len(), 3);
        for line in lines {
            assert!(width(&line, 15.0, Weight::Bold) <= 300.0);
        }
        assert!(wrapped("  ", 15.0, Weight::Bold, 300.0).is_empty());
    }
}
