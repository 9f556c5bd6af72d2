//! Figures for tests, of every kind of part.

use libm::{cos, exp, sin};

use crate::*;

/// A reproducible number between -1 and 1.
pub(super) fn noise(index: usize) -> f64 {
    let mixed = (index as u64 ^ 0x9e37_79b9).wrapping_mul(0x2545_f491_4f6c_dd1d);
    let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (mixed >> 40) as f64 / f64::from(1 << 23) - 1.0
}

pub(super) fn sampled(
    count: usize,
    end: f64,
    value: impl Fn(usize, f64) -> f64,
) -> Vec<(f64, f64)> {
    (0..=count)
        .map(|index| {
            let time = end * index as f64 / count as f64;
            (time, value(index, time))
        })
        .collect()
}

fn swing(seed: usize, decay: f64, noisy: f64) -> Vec<(f64, f64)> {
    sampled(10_000, 10.0, |index, time| {
        -4.0 * exp(-decay * time) * cos(13.0 * time) + noisy * noise(index + seed)
    })
}

pub(super) fn two_swings() -> Figure {
    let panel = Panel::new("(a) position", "time, s", "position, mm")
        .with_series(Series::line("first", 0, swing(0, 0.9, 0.03)))
        .with_series(Series::line("second", 1, swing(77_777, 0.5, 0.03)))
        .with_guide(Guide::horizontal(0.0, "rest"))
        .with_inset(Inset::over(1.3, 1.6));
    Figure::new("A noisy swing under two methods").with_panel(panel)
}

pub(super) fn four_panels() -> Figure {
    let labels = ["none", "first", "second"];
    let curves = |scale: f64, phase: f64| -> Vec<Vec<(f64, f64)>> {
        [-0.4_f64, 1.6, 0.8]
            .iter()
            .map(|decay| {
                sampled(200, 2.0, |_, time| scale * exp(-decay * time) * cos(22.0 * time + phase))
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
        .with_panel(panel("(d) tiny", sampled(50, 1e-12, |_, time| 1e-12 * sin(time * 1e13))))
        .with_panel(panel("(e) large", sampled(50, 1e12, |_, time| time * 3.0)))
        .with_panel(panel("(f) far from zero", sampled(50, 1.0, |_, time| 1e12 + time)))
        .with_panel(panel("(g) full range", huge.to_vec()))
        .with_panel(panel(
            "(h) gaps",
            sampled(
                400,
                1.0,
                |index, time| {
                    if index % 100 < 20 { f64::NAN } else { sin(9.0 * time) }
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
            panel("(k) a curve across itself", sampled(1_000_000, 6.0, |_, time| cos(time)))
                .with_series(Series::line(
                    "orbit",
                    1,
                    sampled(300_000, 1.0, |index, time| sin(60.0 * time + noise(index)))
                        .into_iter()
                        .map(|(time, value)| (3.0 + 2.0 * cos(60.0 * time), value))
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
        sampled(1_000_000, 2.0, move |index, time| sin(200.0 * time) + noise(index + seed))
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
        .with_series(Series::dots("measured", 0, sampled(20, 50_000.0, |_, x| 2e-4 * sin(x / 2e4))))
        .with_series(
            Series::line("predicted", 1, sampled(200, 50_000.0, |_, x| 2.1e-4 * sin(x / 2e4)))
                .dashed(),
        )
        .with_inset(Inset::over(20_000.0, 22_000.0).placed(Placement::Beside));
    Figure::new("").with_panel(panel).with_panel(sweep)
}

fn fields() -> Figure {
    let wave = |row: usize, column: usize| sin(0.3 * row as f64) * cos(0.2 * column as f64);
    let ramp = (0..40 * 60).map(|at| wave(at / 60, at % 60)).collect();
    let classes = (0..40 * 60).map(|at| ((at % 60) / 20) as f64).collect();
    let mapped = |title: &str, heat| Panel { heat: Some(heat), ..Panel::new(title, "x", "y") };
    Figure::new("Fields")
        .with_columns(2)
        .with_width(900.0)
        .with_panel(mapped("(a) ramp", HeatMap::new(60, ramp)))
        .with_panel(mapped("(b) classes", HeatMap::of_classes(60, classes, &["a", "b", "c"])))
}

/// Long names, and numbers that leave an offset to a note at the end of the axis.
pub(super) fn wordy() -> Figure {
    let words = |count: usize| ["many words"; 40][..count].join(", ");
    let curve = sampled(100, 1.0, |_, time| time * time);
    let shifted = curve.iter().map(|(x, y)| (1e9 + x, 1e9 + y)).collect();
    Figure::new(words(25)).with_width(640.0).with_panel(
        Panel::new(words(9), words(12), words(8)).with_series(Series::line(words(3), 0, shifted)),
    )
}

pub(super) fn gallery() -> [(&'static str, Figure); 5] {
    [
        ("swings", two_swings()),
        ("four", four_panels()),
        ("hostile", hostile()),
        ("crowded", beside_and_crowded()),
        ("fields", fields()),
    ]
}
