//! SVG text of a drawing. Numbers are rounded to a hundredth of a unit.

use super::drawing::{Anchor, Drawing, HALO, Join, Lettering, Mark};
use super::geometry::{Place, Rect};
use super::palette::{PAPER, Stroke};
use super::text::{FAMILIES, Weight, shown};

/// The SVG document of a drawing, on white.
pub(super) fn document(drawing: &Drawing, [width, height]: [f64; 2], title: &str) -> String {
    let (width, height) = (number(width), number(height));
    let name = if title.trim().is_empty() {
        String::new()
    } else {
        format!("<title>{}</title>\n", escaped(title))
    };
    let body: String = drawing.marks.iter().map(element).collect();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FAMILIES}\">\n\
         {name}<rect width=\"{width}\" height=\"{height}\" fill=\"{PAPER}\"/>\n{body}</svg>\n"
    )
}

fn element(mark: &Mark) -> String {
    match mark {
        Mark::Area { area, fill } => format!("<rect {} fill=\"{fill}\"/>\n", sides(*area)),
        Mark::Outline { area, stroke } => {
            format!("<rect {} fill=\"none\"{}/>\n", sides(*area), attributes(*stroke))
        }
        Mark::Lines { lines, stroke, join } => {
            let join = match join {
                Join::Miter => "",
                Join::Round => " stroke-linejoin=\"round\"",
            };
            stroked(&lines.iter().map(|line| data(line)).collect::<String>(), *stroke, join)
        }
        // As lines of no length with round ends: the shortest way to write them.
        Mark::Dots { dots, colour, diameter } => {
            let data: String =
                dots.iter().map(|(x, y)| format!("M{} {}h0", number(*x), number(*y))).collect();
            stroked(&data, Stroke::solid(colour, *diameter), " stroke-linecap=\"round\"")
        }
        Mark::Text { place, lettering, text } => lettered(*place, *lettering, text),
        Mark::Bitmap { area, picture, is_heat_map } => format!(
            "<image{} {} preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" \
             href=\"{}\"/>\n",
            if *is_heat_map { " class=\"cells\"" } else { "" },
            sides(*area),
            picture.link(),
        ),
    }
}

fn sides(area: Rect) -> String {
    let [x, y, width, height] = [area.left, area.top, area.width, area.height].map(number);
    format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"")
}

fn lettered((x, y): Place, lettering: Lettering, text: &str) -> String {
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
            " stroke=\"{PAPER}\" stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
            number(HALO)
        )
    } else {
        String::new()
    };
    format!(
        "<text {place} font-size=\"{}\" fill=\"{}\"{anchor}{weight}{halo}>{}</text>\n",
        number(lettering.size),
        lettering.colour,
        escaped(text),
    )
}

fn stroked(data: &str, stroke: Stroke, ends: &str) -> String {
    if data.is_empty() {
        return String::new();
    }
    format!("<path d=\"{data}\" fill=\"none\"{}{ends}/>\n", attributes(stroke))
}

fn data(line: &[Place]) -> String {
    let mut pen = Pen::default();
    for (index, place) in line.iter().enumerate() {
        if index == 0 {
            pen.start(*place);
        } else {
            pen.draw(*place);
        }
    }
    pen.data
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
            other => result.push(shown(other)),
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
        let steps = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 5.0), (2.0, 6.0)];
        assert_eq!(data(&steps), "M0 0H1V5L2 6");
    }
}
