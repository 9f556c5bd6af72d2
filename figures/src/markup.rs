//! SVG text of a drawing.

use std::fmt::Write;

use super::geometry::{Place, Rect};
use super::palette::{PAPER, Stroke};
use super::text::{FAMILIES, Weight};

/// Part of a text that its place refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Size, colour and position of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lettering {
    pub(super) size: f64,
    pub(super) weight: Weight,
    pub(super) colour: &'static str,
    pub(super) anchor: Anchor,
    /// A white outline keeps the letters readable on top of lines.
    pub(super) halo: bool,
    /// The text reads from bottom to top.
    pub(super) upright: bool,
}

impl Lettering {
    pub(super) const fn new(size: f64, colour: &'static str, anchor: Anchor) -> Self {
        Self { size, weight: Weight::Regular, colour, anchor, halo: false, upright: false }
    }
}

/// Drawing in the making. Numbers are rounded to a hundredth of a unit.
#[derive(Debug, Clone, Default)]
pub(super) struct Markup {
    body: String,
}

impl Markup {
    pub(super) fn finish(self, width: f64, height: f64, title: &str) -> String {
        let (width, height) = (number(width), number(height));
        let name = if title.trim().is_empty() {
            String::new()
        } else {
            format!("<title>{}</title>\n", escaped(title))
        };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILIES}\">\n\
             {name}<rect width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>\n{}</svg>\n",
            self.body
        )
    }

    pub(super) fn area(&mut self, area: Rect, fill: &str) {
        self.push(format_args!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{fill}\"/>\n",
            number(area.left),
            number(area.top),
            number(area.width),
            number(area.height),
        ));
    }

    /// Draws a bitmap over an area, with sharp edges between its pixels; `link` is a `data:` link.
    pub(super) fn picture(&mut self, area: Rect, link: &str) {
        self.bitmap(area, link, "");
    }

    /// Draws the bitmap of a heat map, which a page finds by its class.
    pub(super) fn cells(&mut self, area: Rect, link: &str) {
        self.bitmap(area, link, " class=\"cells\"");
    }

    fn bitmap(&mut self, area: Rect, link: &str, class: &str) {
        self.push(format_args!(
            "<image{class} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
             style=\"image-rendering:pixelated\" href=\"{link}\"/>\n",
            number(area.left),
            number(area.top),
            number(area.width),
            number(area.height),
        ));
    }

    pub(super) fn outline(&mut self, area: Rect, stroke: Stroke) {
        self.push(format_args!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\"{}/>\n",
            number(area.left),
            number(area.top),
            number(area.width),
            number(area.height),
            attributes(stroke),
        ));
    }

    /// Draws separate straight lines of one stroke.
    pub(super) fn lines(&mut self, lines: &[(Place, Place)], stroke: Stroke) {
        let data: String = lines
            .iter()
            .map(|(from, to)| {
                let mut pen = Pen::default();
                pen.start(*from);
                pen.draw(*to);
                pen.data
            })
            .collect();
        self.stroked(&data, stroke, "");
    }

    /// Draws lines through many points.
    pub(super) fn curves(&mut self, curves: &[Vec<Place>], stroke: Stroke) {
        let data: String = curves
            .iter()
            .map(|curve| {
                let mut pen = Pen::default();
                for (index, place) in curve.iter().enumerate() {
                    if index == 0 {
                        pen.start(*place);
                    } else {
                        pen.draw(*place);
                    }
                }
                pen.data
            })
            .collect();
        self.stroked(&data, stroke, " stroke-linejoin=\"round\"");
    }

    /// Draws dots of one colour, as lines of no length with round ends: the shortest way to write them.
    pub(super) fn dots(&mut self, dots: &[Place], colour: &'static str, diameter: f64) {
        let data: String =
            dots.iter().map(|(x, y)| format!("M{} {}h0", number(*x), number(*y))).collect();
        let stroke = Stroke::solid(colour, diameter);
        self.stroked(&data, stroke, " stroke-linecap=\"round\"");
    }

    pub(super) fn text(&mut self, (x, y): Place, lettering: Lettering, text: &str) {
        if text.trim().is_empty() {
            return;
        }
        let (x, y) = (number(x), number(y));
        let place = if lettering.upright {
            format!("transform=\"translate({x} {y}) rotate(-90)\"")
        } else {
            format!("x=\"{x}\" y=\"{y}\"")
        };
        let anchor = match lettering.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let weight = match lettering.weight {
            Weight::Regular => "",
            Weight::Bold => " font-weight=\"bold\"",
        };
        let halo = if lettering.halo {
            format!(
                " stroke=\"{PAPER}\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\""
            )
        } else {
            String::new()
        };
        self.push(format_args!(
            "<text {place} font-size=\"{}\" fill=\"{}\"{anchor}{weight}{halo}>{}</text>\n",
            number(lettering.size),
            lettering.colour,
            escaped(text),
        ));
    }

    fn stroked(&mut self, data: &str, stroke: Stroke, ends: &str) {
        if !data.is_empty() {
            self.push(format_args!(
                "<path d=\"{data}\" fill=\"none\"{}{ends}/>\n",
                attributes(stroke)
            ));
        }
    }

    fn push(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.body.write_fmt(element);
    }
}

/// Writer of the points of a path, each in its shortest form.
#[derive(Debug, Default)]
struct Pen {
    data: String,
    x: String,
    y: String,
}

impl Pen {
    fn start(&mut self, (x, y): Place) {
        (self.x, self.y) = (number(x), number(y));
        self.data.push_str(&format!("M{} {}", self.x, self.y));
    }

    fn draw(&mut self, (x, y): Place) {
        let (x, y) = (number(x), number(y));
        match (x == self.x, y == self.y) {
            (true, true) => {}
            (true, false) => self.data.push_str(&format!("V{y}")),
            (false, true) => self.data.push_str(&format!("H{x}")),
            (false, false) => self.data.push_str(&format!("L{x} {y}")),
        }
        (self.x, self.y) = (x, y);
    }
}

fn attributes(stroke: Stroke) -> String {
    let dash = if stroke.dash.is_empty() {
        String::new()
    } else {
        format!(" stroke-dasharray=\"{}\"", stroke.dash)
    };
    format!(" stroke=\"{}\" stroke-width=\"{}\"{dash}", stroke.colour, number(stroke.width))
}

fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

/// The text, with every character replaced that XML reads as markup or does not allow.
fn escaped(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => result.push_str("&amp;"),
            '<' => result.push_str("&lt;"),
            '>' => result.push_str("&gt;"),
            '"' => result.push_str("&quot;"),
            '\t' | '\n' | '\r' => result.push(' '),
            '\u{fffe}' | '\u{ffff}' => result.push('\u{fffd}'),
            other if other.is_control() => result.push('\u{fffd}'),
            other => result.push(other),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in
            [(1.0, "1"), (-0.001, "0"), (12.345, "12.35"), (100.0, "100"), (0.5, "0.5")]
        {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn text_cannot_become_markup() {
        assert_eq!(escaped("a<b & \"c\"\u{0}\n>"), "a&lt;b &amp; &quot;c&quot;\u{fffd} &gt;");
    }

    #[test]
    fn steps_are_written_as_horizontal_and_vertical_lines() {
        let mut markup = Markup::default();
        let steps = vec![(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 5.0), (2.0, 6.0)];
        markup.curves(&[steps], Stroke::solid("red", 1.0));
        assert!(markup.body.contains("d=\"M0 0H1V5L2 6\""), "{}", markup.body);
    }
}
