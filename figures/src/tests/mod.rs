//! Tests of the figures from outside, and pictures to look at.

mod gallery;
mod layout;

use std::sync::Arc;

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Source};
use resvg::usvg::{Options, Tree};

use self::gallery::{four_panels, gallery, two_swings};
use super::*;

/// The drawing that another reader finds in an SVG document, with the whole typeface: it asks for its name.
fn read(svg: &str) -> Tree {
    let mut fonts = Database::new();
    for weight in [dejavu::sans::regular(), dejavu::sans::bold()] {
        fonts.load_font_source(Source::Binary(Arc::new(weight)));
    }
    Tree::from_str(svg, &Options { fontdb: Arc::new(fonts), ..Options::default() }).unwrap()
}

#[test]
#[ignore = "writes pictures to look at into the directory for temporary files"]
fn pictures_to_look_at() {
    let directory = std::env::temp_dir().join("figures");
    std::fs::create_dir_all(&directory).unwrap();
    for (name, figure) in layout::figures() {
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
