//! Fields of a line, and the number in a field.

use super::lines::find;
use super::notation::is_number;

/// Delimiter that stands for any number of blanks.
pub(super) const BLANK: u8 = b' ';

/// The raw fields of a line.
///
/// A field that begins with a quotation mark may hold the delimiter; it ends at the next quotation mark before
/// a delimiter or the end of the line.
#[derive(Clone, Debug)]
pub(super) struct Fields<'a> {
    rest: Option<&'a [u8]>,
    delimiter: u8,
}

impl<'a> Fields<'a> {
    pub(super) fn new(line: &'a [u8], delimiter: u8) -> Self {
        let line = if delimiter == BLANK { line.trim_ascii() } else { line };
        Self { rest: Some(line), delimiter }
    }

    fn end(&self, rest: &[u8]) -> Option<usize> {
        if rest.first() == Some(&b'"') {
            let mut from = 1;
            while let Some(at) = find(b'"', rest.get(from..).unwrap_or_default()) {
                from += at + 1;
                match rest.get(from) {
                    None => return None,
                    Some(next) if *next == self.delimiter => return Some(from),
                    Some(_) => {}
                }
            }
        }
        find(self.delimiter, rest)
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest?;
        let end = self.end(rest);
        let next = end.map(|end| &rest[end + 1..]);
        self.rest = if self.delimiter == BLANK { next.map(<[u8]>::trim_ascii_start) } else { next };
        Some(&rest[..end.unwrap_or(rest.len())])
    }
}

/// The field without surrounding blanks and quotation marks.
pub(super) fn bare(field: &[u8]) -> &[u8] {
    let field = field.trim_ascii();
    match field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\"")) {
        Some(inner) => inner.trim_ascii(),
        None => field,
    }
}

/// The number in a field, NaN and infinities included; none if the field is no number.
pub(super) fn number(field: &[u8]) -> Option<f64> {
    let plain = |field: &[u8]| str::from_utf8(field).ok()?.parse().ok();
    // Nearly every field is a bare number and needs no search for blanks.
    plain(field).or_else(|| plain(bare(field)))
}

/// The delimiter of a line: the most frequent among comma, semicolon and tab, or one of the latter two that parts numbers
/// with decimal commas; blanks where there is none of them.
pub(super) fn delimiter(line: &[u8]) -> u8 {
    let parts = |delimiter: &u8| {
        let fields = Fields::new(line, *delimiter).filter(|field| !field.trim_ascii().is_empty());
        let (numbers, words): (Vec<_>, Vec<_>) =
            fields.partition(|field| is_number(field, *delimiter));
        numbers.len() > 1 && words.is_empty()
    };
    if let Some(delimiter) = [b';', b'\t'].into_iter().find(parts) {
        return delimiter;
    }
    let count = |delimiter| line.iter().filter(|byte| **byte == delimiter).count();
    let [comma, semicolon, tab] = [b',', b';', b'\t'].map(count);
    match () {
        () if semicolon > comma && semicolon >= tab => b';',
        () if tab > comma => b'\t',
        () if comma == 0 && line.trim_ascii().contains(&BLANK) => BLANK,
        () => b',',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split(line: &str) -> Vec<&[u8]> {
        Fields::new(line.as_bytes(), b',').collect()
    }

    #[test]
    fn delimiters_separate_fields() {
        assert_eq!(split("a,b,,c"), [&b"a"[..], b"b", b"", b"c"]);
        assert_eq!(split(""), [b""]);
        assert_eq!(split(","), [b"", b""]);
    }

    #[test]
    fn blanks_separate_fields_however_many() {
        let split = |line: &'static str| Fields::new(line.as_bytes(), b' ').collect::<Vec<_>>();
        assert_eq!(split("  1  2.5   -3 "), [&b"1"[..], b"2.5", b"-3"]);
        assert_eq!(split(r#""a b" c"#), [&br#""a b""#[..], b"c"]);
    }

    #[test]
    fn a_quoted_field_may_hold_the_delimiter() {
        assert_eq!(split(r#""a,b",c"#), [&br#""a,b""#[..], b"c"]);
        assert_eq!(split(r#"c,"a,b""#), [&b"c"[..], br#""a,b""#]);
        assert_eq!(split(r#""a""b,c",d"#).len(), 2);
        // An unclosed quotation mark is an ordinary character.
        assert_eq!(split(r#""a,b"#), [&br#""a"#[..], b"b"]);
        assert_eq!(split("\"").len(), 1);
    }

    #[test]
    fn blanks_and_quotation_marks_may_surround_numbers() {
        for field in ["1.5", " 1.5 ", "\"1.5\"", " \" 1.5\" ", "15e-1", "+1.5"] {
            assert_eq!(number(field.as_bytes()), Some(1.5), "{field}");
        }
        for field in ["", " ", "\"", "1,5", "1.5 N", "0x10", "one", "1 .5", "\u{2212}1"] {
            assert_eq!(number(field.as_bytes()), None, "{field}");
        }
        assert!(number(b"NaN").is_some_and(f64::is_nan));
        assert_eq!(number(&[0xff, b'1']), None);
    }

    #[test]
    fn the_delimiter_is_the_most_frequent() {
        for (line, expected) in [
            ("t,x,f", b','),
            ("t;x;f", b';'),
            ("t\tx\tf", b'\t'),
            ("t", b','),
            ("a;b;c,d", b';'),
            ("0,1;0,2;0,3", b';'),
            ("0,1\t0,2\t-3,5e-1", b'\t'),
            ("0;1;2", b';'),
            ("0,1,2", b','),
            ("0, 1, 2", b','),
            ("t x f", b' '),
            ("  0.0e+00  1.0e-03 2 ", b' '),
        ] {
            assert_eq!(delimiter(line.as_bytes()), expected, "{line}");
        }
    }
}
