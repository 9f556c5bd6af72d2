//! Data of a figure, for a page that draws it once more.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec_zlib;

use super::figure::Figure;
use super::guide::Direction;
use super::heat::{Colouring, HeatMap};
use super::page;
use super::palette::Stroke;
use super::panel::{Numbering, Panel};
use super::picture::LEVEL;
use super::series::{Series, Trace};
use super::span::Span;
use super::thinning::{thinned, thinned_dots};

/// The most points of all curves of a figure; beyond it long ones are thinned by the same share. With a few bytes for a point a
/// page of several figures stays below a megabyte.
const MOST_POINTS: usize = 40_000;

/// A curve of at most so many points is kept whole: one that ends early would else lose its shape because others are long.
const FEWEST: f64 = 200.0;

/// Digits of an abscissa: a time stays apart from the next one over a million ticks.
const X_DIGITS: usize = 9;

const Y_DIGITS: usize = 6;

/// The data of `figure` as JSON, deflated (RFC 1950), in base64.
pub(super) fn packed(figure: &Figure) -> String {
    STANDARD.encode(compress_to_vec_zlib(json(figure).as_bytes(), LEVEL))
}

fn json(figure: &Figure) -> String {
    let series = || figure.panels.iter().flat_map(|panel| &panel.series);
    let points: usize = series().map(|series| series.points.len()).sum();
    let share = MOST_POINTS as f64 / points.max(MOST_POINTS) as f64;
    let is_thinned = series().any(|series| is_long(series, share));
    let cells = figure.panels.iter().filter_map(|panel| panel.heat.as_ref());
    let digits = digits(cells.map(|heat| heat.values.len()).sum());
    let mut columns = Vec::new();
    let panels =
        list(figure.panels.iter().map(|panel| of_panel(panel, share, digits, &mut columns)));
    let (across, height) = page::layout(figure);
    let [title, height] = [text(&figure.title), short(height, 4)];
    format!(
        "{{\"title\":{title},\"columns\":{across},\"height\":{height},\"thinned\":{is_thinned},\"panels\":{panels},\
         \"x\":[{}]}}",
        columns.join(",")
    )
}

/// Digits of the elements of heat maps that have `values` together: a page holds a dozen such figures. 0 leaves them out.
fn digits(values: usize) -> usize {
    match values {
        0..=5_000 => 4,
        5_001..=20_000 => 3,
        20_001..=50_000 => 2,
        _ => 0,
    }
}

/// The data of a panel; abscissae that curves share are in `columns` once.
fn of_panel(panel: &Panel, share: f64, digits: usize, columns: &mut Vec<String>) -> String {
    let x = panel.x_span();
    let y = panel.y_span(x);
    let guides = panel.guides.iter().map(|guide| {
        let way = if guide.direction == Direction::Horizontal { "h" } else { "v" };
        format!("[\"{way}\",{},{}]", short(guide.at, X_DIGITS), text(&guide.label))
    });
    let curves = panel.series.iter().map(|series| {
        let points = kept(series, x, y, share);
        let abscissae = list(points.iter().map(|point| short(point.0, X_DIGITS)));
        let column = columns.iter().position(|known| *known == abscissae).unwrap_or_else(|| {
            columns.push(abscissae);
            columns.len() - 1
        });
        of_series(series, column, &points)
    });
    let [guides, curves] = [list(guides), list(curves)];
    let mut data = format!(
        "{{\"title\":{},\"x\":{},\"y\":{},\"xRange\":{},\"yRange\":{},\"xLog\":{},\"yLog\":{},\"guides\":{guides},\
         \"curves\":{curves}",
        text(&panel.title),
        text(&panel.x_label),
        text(&panel.y_label),
        range(x),
        range(y),
        panel.x_numbers == Numbering::PowersOfTen,
        panel.y_numbers == Numbering::PowersOfTen,
    );
    // Writing to a string cannot fail.
    if !panel.rows.is_empty() {
        let _ = write!(data, ",\"rows\":{}", list(panel.rows.iter().map(|row| text(row))));
    }
    if let Some(part) = panel.inset.and_then(|inset| Span::given(Some(inset.x_range))) {
        let _ = write!(data, ",\"magnified\":{}", range(part));
    }
    if let Some(heat) = &panel.heat {
        let _ = write!(data, ",\"heat\":{}", of_heat(heat, digits));
    }
    data + "}"
}

fn of_series(series: &Series, column: usize, points: &[(f64, f64)]) -> String {
    let stroke = Stroke::of(series);
    let trace = match series.trace {
        Trace::Line => "line",
        Trace::Steps => "steps",
        Trace::Dots => "dots",
        Trace::Bars => "bars",
    };
    format!(
        "{{\"label\":{},\"colour\":\"{}\",\"width\":{},\"dash\":[{}],\"trace\":\"{trace}\",\"x\":{column},\"y\":{}}}",
        text(&series.label),
        stroke.colour,
        short(stroke.width, 3),
        stroke.dash.replace(' ', ","),
        list(points.iter().map(|point| short(point.1, Y_DIGITS))),
    )
}

fn of_heat(heat: &HeatMap, digits: usize) -> String {
    let (classes, digits) = match &heat.colouring {
        Colouring::Classes(names) => (list(names.iter().map(|name| text(name))), 1),
        Colouring::Ramp(_) => ("null".to_owned(), digits),
    };
    let values = if digits == 0 { &[][..] } else { &heat.values[..] };
    format!(
        "{{\"columns\":{},\"rows\":{},\"digits\":{digits},\"classes\":{classes},\"values\":{}}}",
        heat.columns,
        heat.values.len() / heat.columns.max(1),
        list(values.iter().map(|value| short(*value, digits))),
    )
}

/// The most points that are kept of a curve of as many `points`.
fn most(points: usize, share: f64) -> f64 {
    (share * points as f64).max(FEWEST)
}

/// Whether a curve is thinned.
fn is_long(series: &Series, share: f64) -> bool {
    series.trace != Trace::Bars && series.points.len() as f64 > most(series.points.len(), share)
}

/// The points of a curve, or of a long one those that show its extremes: a `share` of them, or [`FEWEST`].
fn kept(series: &Series, x: Span, y: Span, share: f64) -> Vec<(f64, f64)> {
    let points = &series.points;
    if !is_long(series, share) {
        return points.clone();
    }
    // At most four points of a column are kept, and the columns are those of the curve's own part of the frame.
    let width = most(points.len(), share) / 4.0;
    let own = Span::of(points.iter().map(|point| point.0));
    let x = own.map_or(x, Span::readable);
    let place = |&(a, b): &(f64, f64)| (width * x.fraction(a), width * y.fraction(b));
    let back = |span: Span, part: f64| span.low + part / width * (span.high - span.low);
    let runs = points.split(|(a, b)| !(a.is_finite() && b.is_finite()));
    let mut all = Vec::new();
    for run in runs.filter(|run| !run.is_empty()) {
        let places = run.iter().map(place).collect();
        let places = match series.trace {
            Trace::Dots => thinned_dots(places),
            _ => thinned(places, width * run.len() as f64 / points.len() as f64),
        };
        all.extend(places.into_iter().map(|(a, b)| (back(x, a), back(y, b))));
        all.push((f64::NAN, f64::NAN));
    }
    all
}

fn list(items: impl Iterator<Item = String>) -> String {
    format!("[{}]", items.collect::<Vec<_>>().join(","))
}

fn range(span: Span) -> String {
    format!("[{},{}]", short(span.low, X_DIGITS), short(span.high, X_DIGITS))
}

/// The number to `digits` in its shortest form; `null` if it is not finite.
fn short(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "null".to_owned();
    }
    let rounded = format!("{value:.*e}", digits.max(1) - 1).parse().unwrap_or(value);
    let rounded = if rounded == 0.0 { 0.0 } else { rounded };
    let (plain, power) = (format!("{rounded}"), format!("{rounded:e}"));
    if plain.len() <= power.len() { plain } else { power }
}

/// The text as a string of JSON that cannot end the element of a page it stands in.
fn text(text: &str) -> String {
    let mut result = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => result.extend(['\\', character]),
            other if other.is_control() || "<>&".contains(other) => {
                let _ = write!(result, "\\u{:04x}", u32::from(other));
            }
            other => result.push(other),
        }
    }
    result + "\""
}

#[cfg(test)]
mod tests {
    use super::super::guide::Guide;
    use super::*;

    #[test]
    fn numbers_are_short_and_keep_their_digits() {
        for (value, digits, written) in [
            (0.1 + 0.2, 9, "0.3"),
            (1234.56789, 6, "1234.57"),
            (-1.234_567e-12, 6, "-1.23457e-12"),
            (1e300, 6, "1e300"),
            (-0.0, 6, "0"),
            (0.000_123_4, 2, "1.2e-4"),
            (f64::NAN, 6, "null"),
            (f64::NEG_INFINITY, 6, "null"),
            (f64::MAX, 9, "1.79769313e308"),
        ] {
            assert_eq!(short(value, digits), written);
        }
    }

    #[test]
    fn no_name_can_end_the_element_it_stands_in() {
        let hostile = "</script><img src=x onerror=\"alert(1)\">\\\u{0}\n";
        let panel = Panel::new(hostile, hostile, hostile)
            .with_series(Series::line(hostile, 0, vec![(0.0, 1.0)]))
            .with_guide(Guide::vertical(0.0, hostile))
            .with_rows(vec![hostile.to_owned()]);
        let data = json(&Figure::new(hostile).with_panel(panel));
        assert!(!data.contains(['<', '>', '\n', '\0']), "{data}");
        assert!(
            data.contains("\\u003c/script\\u003e") && data.contains("\\\\\\u0000\\u000a"),
            "{data}"
        );
    }

    #[test]
    fn curves_over_the_same_times_name_them_once() {
        let curve = |y: f64| Series::line("", 0, vec![(0.0, y), (0.25, f64::NAN), (0.5, y)]);
        let panel = || Panel::new("", "", "").with_series(curve(1.0)).with_series(curve(2.0));
        let data = json(&Figure::new("").with_panel(panel()).with_panel(panel()));
        assert!(data.ends_with("\"x\":[[0,0.25,0.5]]}"), "{data}");
        assert_eq!(data.matches("\"y\":[1,null,1]").count(), 2, "{data}");
    }

    #[test]
    fn long_curves_are_thinned_to_points_of_their_own_with_their_extremes() {
        let wave = |tick: u32| (f64::from(tick) * 1e-3, (f64::from(tick) * 0.37).sin());
        let mut points: Vec<(f64, f64)> = (0..200_000).map(wave).collect();
        points[123_456].1 = 7.0;
        let series = Series::line("", 0, points);
        let (x, y) = (Span { low: 0.0, high: 200.0 }, Span { low: -1.0, high: 7.0 });
        let found = kept(&series, x, y, 0.1);
        assert!(found.len() <= 20_006, "{}", found.len());
        let near = |at: (f64, f64), of: &(f64, f64)| {
            (at.0 - of.0).abs() < 1e-9 && (at.1 - of.1).abs() < 1e-9
        };
        assert!(found.iter().any(|point| near((123.456, 7.0), point)));
        for point in found.iter().filter(|point| point.0.is_finite()).step_by(97) {
            let own = series.points[(point.0 * 1e3).round() as usize];
            assert!(near(own, point), "{point:?} {own:?}");
        }
    }

    /// A curve between 0 and 2 needs no point at 1; of a cloud each level is seen.
    #[test]
    fn dots_between_others_are_kept() {
        let points =
            (0..30_000).map(|tick| (f64::from(tick) * 1e-3, f64::from(tick % 3))).collect();
        let (x, y) = (Span { low: 0.0, high: 30.0 }, Span { low: 0.0, high: 2.0 });
        let found = kept(&Series::dots("", 0, points), x, y, 0.1);
        let at = |level: f64| found.iter().filter(|it| (it.1 - level).abs() < 1e-9).count();
        let [low, middle, high] = [0.0, 1.0, 2.0].map(at);
        assert!(low > 100 && middle * 10 > low * 9 && high * 10 > low * 9, "{low} {middle} {high}");
    }

    #[test]
    fn cells_are_told_as_long_as_they_fit() {
        let map = |side: usize| {
            let heat = HeatMap::new(side, vec![1.23456; side * side]);
            json(&Figure::new("").with_panel(Panel::new("", "", "").with_heat(heat)))
        };
        assert!(map(16).contains("\"values\":[1.235,"));
        assert!(map(128).contains("\"values\":[1.23,"));
        assert!(map(200).contains("\"values\":[1.2,"));
        assert!(map(256).contains("\"values\":[]"));
    }
}
