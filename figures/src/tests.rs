//! Tests of the figures from outside, and pictures to look at.

use std::sync::Arc;

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Source};
use resvg::usvg::{Options, Tree};

use super::*;
use crate::text::Weight;

/// The drawing that another reader finds in an SVG document, with the included typeface.
fn read(svg: &str) -> Tree {
    let mut fonts = Database::new();
    for weight in [Weight::Regular, Weight::Bold] {
        fonts.load_font_source(Source::Binary(Arc::new(weight.bytes())));
    }
    Tree::from_str(svg, &Options { fontdb: Arc::new(fonts), ..Options::default() }).unwrap()
}

/// A reproducible number between -1 and 1.
fn noise(index: usize) -> f64 {
    let mixed = (index as u64 ^ 0x9e37_79b9).wrapping_mul(0x2545_f491_4f6c_dd1d);
    let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (mixed >> 40) as f64 / f64::from(1 << 23) - 1.0
}

fn sampled(count: usize, end: f64, value: impl Fn(usize, f64) -> f64) -> Vec<(f64, f64)> {
    (0..=count)
        .map(|index| {
            let time = end * index as f64 / count as f64;
            (time, value(index, time))
        })
        .collect()
}

fn swing(seed: usize, decay: f64, noisy: f64) -> Vec<(f64, f64)> {
    sampled(10_000, 10.0, |index, time| {
        -4.0 * (-decay * time).exp() * (13.0 * time).cos() + noisy * noise(index + seed)
    })
}

fn two_swings() -> Figure {
    let panel = Panel::new("(a) position", "time, s", "position, mm")
        .with_series(Series::line("first", 0, swing(0, 0.9, 0.03)))
        .with_series(Series::line("second", 1, swing(77_777, 0.5, 0.03)))
        .with_guide(Guide::horizontal(0.0, "rest"))
        .with_inset(Inset::over(1.3, 1.6));
    Figure::new("A noisy swing under two methods").with_panel(panel)
}

fn four_panels() -> Figure {
    let labels = ["none", "first", "second"];
    let curves = |scale: f64, phase: f64| -> Vec<Vec<(f64, f64)>> {
        [-0.4_f64, 1.6, 0.8]
            .iter()
            .map(|decay| {
                sampled(200, 2.0, |_, time| {
                    scale * (-decay * time).exp() * (22.0 * time + phase).cos()
                })
            })
            .collect()
    };
    let fill = |mut panel: Panel, curves: Vec<Vec<(f64, f64)>>, trace: Trace| {
        for (index, points) in curves.into_iter().enumerate() {
            panel =
                panel.with_series(Series { trace, ..Series::line(labels[index], index, points) });
        }
        panel
    };
    let energy = curves(0.25, 0.0)
        .into_iter()
        .map(|points| points.iter().map(|(time, value)| (*time, value * value)).collect())
        .collect();
    Figure::new("A grid of four panels")
        .with_columns(2)
        .with_width(900.0)
        .with_panel(
            fill(
                Panel::new("(a) position", "time, s", "position, mm"),
                curves(-4.0, 0.0),
                Trace::Line,
            )
            .with_guide(Guide::horizontal(0.0, "rest")),
        )
        .with_panel(
            fill(
                Panel::new("(b) a longer heading, in steps", "time, s", "force, N"),
                curves(3.0, 0.8),
                Trace::Steps,
            )
            .with_guide(Guide::horizontal(6.5, "an upper limit")),
        )
        .with_panel(
            fill(
                Panel::new("(c) another heading, in steps", "time, s", "force, N"),
                curves(1.0, 2.0),
                Trace::Steps,
            )
            .with_y_range(-1.0, 1.0)
            .with_guide(Guide::vertical(0.31, "an event")),
        )
        .with_panel(fill(Panel::new("(d) energy", "time, s", "energy, mJ"), energy, Trace::Line))
}

fn hostile() -> Figure {
    let panel = |title: &str, points: Vec<(f64, f64)>| {
        Panel::new(title, "time, s", "position, mm").with_series(Series::line("data", 0, points))
    };
    let huge = [(0.0, f64::MIN), (1.0, f64::MAX), (2.0, 1e300), (3.0, f64::NAN)];
    Figure::new("Data <that> \"could\" break & bend a figure \u{0}")
        .with_columns(2)
        .with_width(900.0)
        .with_panel(panel("(a) nothing", Vec::new()))
        .with_panel(panel("(b) a single point", vec![(1.0, 5.0)]))
        .with_panel(panel("(c) all equal", sampled(50, 1.0, |_, _| 0.3)))
        .with_panel(panel("(d) tiny", sampled(50, 1e-12, |_, time| 1e-12 * (time * 1e13).sin())))
        .with_panel(panel("(e) large", sampled(50, 1e12, |_, time| time * 3.0)))
        .with_panel(panel("(f) far from zero", sampled(50, 1.0, |_, time| 1e12 + time)))
        .with_panel(panel("(g) full range", huge.to_vec()))
        .with_panel(panel(
            "(h) gaps",
            sampled(
                400,
                1.0,
                |index, time| {
                    if index % 100 < 20 { f64::NAN } else { (9.0 * time).sin() }
                },
            ),
        ))
        .with_panel(
            panel("(i) outside", sampled(100, 1.0, |index, _| 1e9 * noise(index)))
                .with_y_range(-1.0, 1.0),
        )
        .with_panel(
            panel("(j) equal range", sampled(10, 1.0, |_, time| time)).with_y_range(2.0, 2.0),
        )
        .with_panel(
            panel("(k) a curve across itself", sampled(1_000_000, 6.0, |_, time| time.cos()))
                .with_series(Series::line(
                    "orbit",
                    1,
                    sampled(300_000, 1.0, |index, time| (60.0 * time + noise(index)).sin())
                        .into_iter()
                        .map(|(time, value)| (3.0 + 2.0 * (60.0 * time).cos(), value))
                        .collect(),
                )),
        )
        .with_panel(
            panel("(l) dots", Vec::new()).with_series(Series::dots(
                "cloud",
                2,
                (0..100_000)
                    .map(|index| (noise(index), noise(index + 500_000) * noise(index + 900_000)))
                    .collect(),
            )),
        )
}

fn beside_and_crowded() -> Figure {
    let crowded = |seed: usize| {
        sampled(1_000_000, 2.0, move |index, time| (200.0 * time).sin() + noise(index + seed))
    };
    let mut panel =
        Panel::new("(a) a heading that goes on for rather a long time", "time, s", "force, N")
            .with_guide(Guide::vertical(1.0, "an event"))
            .with_guide(Guide::horizontal(2.5, "limit"))
            .with_guide(Guide::horizontal(-2.5, "limit"))
            .with_inset(Inset::over(1.0, 1.01).with_y_range(-2.0, 2.0));
    for index in 0..4 {
        panel = panel.with_series(Series::line(
            format!("curve number {index}"),
            index,
            crowded(index * 7_777_777),
        ));
    }
    let sweep = Panel::new("(b) margin", "length, mm", "energy, J")
        .with_series(Series::dots(
            "measured",
            0,
            sampled(20, 50_000.0, |_, x| 2e-4 * (x / 2e4).sin()),
        ))
        .with_series(
            Series::line("predicted", 1, sampled(200, 50_000.0, |_, x| 2.1e-4 * (x / 2e4).sin()))
                .dashed(),
        )
        .with_inset(Inset::over(20_000.0, 22_000.0).placed(Placement::Beside));
    Figure::new("").with_panel(panel).with_panel(sweep)
}

fn fields() -> Figure {
    let wave = |row: usize, column: usize| (0.3 * row as f64).sin() * (0.2 * column as f64).cos();
    let ramp = (0..40 * 60).map(|at| wave(at / 60, at % 60)).collect();
    let classes = (0..40 * 60).map(|at| ((at % 60) / 20) as f64).collect();
    let mapped = |title: &str, heat| Panel { heat: Some(heat), ..Panel::new(title, "x", "y") };
    Figure::new("Fields")
        .with_columns(2)
        .with_width(900.0)
        .with_panel(mapped("(a) ramp", HeatMap::new(60, ramp)))
        .with_panel(mapped("(b) classes", HeatMap::of_classes(60, classes, &["a", "b", "c"])))
}

fn gallery() -> [(&'static str, Figure); 5] {
    [
        ("swings", two_swings()),
        ("four", four_panels()),
        ("hostile", hostile()),
        ("crowded", beside_and_crowded()),
        ("fields", fields()),
    ]
}

#[test]
#[ignore = "writes pictures to look at into the directory for temporary files"]
fn pictures_to_look_at() {
    let directory = std::env::temp_dir().join("figures");
    std::fs::create_dir_all(&directory).unwrap();
    for (name, figure) in gallery() {
        std::fs::write(directory.join(format!("{name}.svg")), figure.to_svg()).unwrap();
        std::fs::write(directory.join(format!("{name}.png")), figure.to_png(2.0).unwrap()).unwrap();
    }
}

#[test]
fn every_figure_is_a_well_formed_drawing_of_a_modest_size() {
    for (name, figure) in gallery() {
        let svg = figure.to_svg();
        let tree = read(&svg);
        assert_eq!(f64::from(tree.size().width()), figure.width, "{name}");
        assert!(tree.root().has_children(), "{name}");
        assert!(svg.len() < 300_000, "{name}: {} bytes", svg.len());
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
    }
}

#[test]
fn the_picture_has_the_size_of_the_drawing_times_the_scale() {
    let figure = two_swings();
    let size = read(&figure.to_svg()).size();
    for scale in [0.5, 1.0, 2.0] {
        let picture = Pixmap::decode_png(&figure.to_png(scale).unwrap()).unwrap();
        assert_eq!(picture.width(), (f64::from(size.width()) * scale).ceil() as u32);
        assert_eq!(picture.height(), (f64::from(size.height()) * scale).ceil() as u32);
        assert!(picture.pixels().iter().all(|pixel| pixel.alpha() == 255));
    }
}

/// Means of red, green and blue over the squares of a picture, 8 pixels a side.
fn squares(picture: &Pixmap) -> Vec<[f64; 3]> {
    let (columns, rows) = (picture.width() as usize / 8, picture.height() as usize / 8);
    let mean = |square: usize| {
        let (left, top) = (8 * (square % columns), 8 * (square / columns));
        let mut sum = [0.0; 3];
        for (x, y) in (0..64).map(|at| (left + at % 8, top + at / 8)) {
            let pixel = picture.pixel(x as u32, y as u32).unwrap();
            let parts = [pixel.red(), pixel.green(), pixel.blue()].map(f64::from);
            sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part / 64.0);
        }
        sum
    };
    (0..columns * rows).map(mean).collect()
}

/// Another rasteriser, of the SVG, is the reference; it moves letters together in pairs.
#[test]
fn the_picture_looks_like_the_drawing() {
    for (name, figure) in gallery() {
        let tree = read(&figure.to_svg());
        let picture = Pixmap::decode_png(&figure.to_png(2.0).unwrap()).unwrap();
        let mut expected = Pixmap::new(picture.width(), picture.height()).unwrap();
        expected.fill(Color::WHITE);
        resvg::render(&tree, Transform::from_scale(2.0, 2.0), &mut expected.as_mut());
        let (ours, theirs) = (squares(&picture), squares(&expected));
        let off: Vec<f64> = (ours.iter().flatten())
            .zip(theirs.iter().flatten())
            .map(|(a, b)| (a - b).abs())
            .collect();
        let (mean, most) =
            (off.iter().sum::<f64>() / off.len() as f64, off.iter().copied().fold(0.0, f64::max));
        assert!(mean < 0.1 && most < 64.0, "{name}: squares differ by {mean}, at most by {most}");
    }
}

#[test]
fn text_reaches_the_picture_without_any_font_of_the_machine() {
    let titled = |title: &str| {
        let figure = Figure::new("").with_panel(Panel::new(title, "time, s", "position, mm"));
        figure.to_png(1.0).unwrap()
    };
    assert_ne!(titled("(a) position"), titled("(a) velocity"));
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    for (name, figure) in gallery() {
        assert_eq!(figure.to_svg(), figure.clone().to_svg(), "{name}");
    }
    assert_eq!(two_swings().to_png(1.0), two_swings().to_png(1.0));
}

#[test]
fn strange_sizes_are_limited_and_strange_scales_refused() {
    for width in [f64::NAN, f64::INFINITY, -1.0, 0.0, 1e9] {
        for columns in [0, 1, 2, usize::MAX] {
            let figure =
                four_panels().with_width(width).with_columns(columns).with_panel_height(width);
            read(&figure.to_svg());
        }
    }
    read(&Figure::default().to_svg());
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(two_swings().to_png(scale), Err(ChartError::Scale { .. })));
    }
    assert!(matches!(two_swings().to_png(1e4), Err(ChartError::TooLarge { .. })));
}

#[test]
fn every_pair_of_hostile_ranges_gives_a_drawing() {
    let bounds =
        [f64::NAN, f64::NEG_INFINITY, f64::MIN, -1e12, -1e-300, 0.0, 5e-324, 1e-12, 1.0, f64::MAX];
    for low in bounds {
        for high in bounds {
            let panel = Panel::new("", "", "")
                .with_series(Series::steps("", 0, vec![(low, high), (high, low), (0.5, 0.5)]))
                .with_series(Series::dots("", usize::MAX, vec![(high, low); 3]))
                .with_guide(Guide::horizontal(low, "low"))
                .with_guide(Guide::vertical(high, "high"))
                .with_x_range(low, high)
                .with_y_range(high, low)
                .with_inset(Inset::over(low, high).with_y_range(low, high));
            let free = Panel { x_range: None, y_range: None, ..panel.clone() };
            let figure = Figure::new("").with_columns(2).with_panel(panel).with_panel(free);
            read(&figure.to_svg());
        }
    }
}

#[test]
fn one_legend_serves_panels_that_show_the_same_series() {
    assert_eq!(four_panels().to_svg().matches(">first<").count(), 1);
    let mut figure = four_panels();
    figure.panels[0].series.pop();
    assert_eq!(figure.to_svg().matches(">first<").count(), 4);
}
