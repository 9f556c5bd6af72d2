//! Figure of a log over a run.

use lyapunov_figures::{Figure, Panel, Series};

use super::{Laid, Pair};
use crate::show::envelope::Envelope;
use crate::text::{file_name, prefix};

/// Curves of a log and of the run at its rows, in a bounded number of points.
#[derive(Clone, Debug)]
pub(super) struct Overlay {
    /// Position, velocity and force: of the run, then of the log.
    curves: [[Envelope; 2]; 3],
}

impl Overlay {
    pub(super) fn new() -> Self {
        let both = || [Envelope::new(), Envelope::new()];
        Self { curves: [both(), both(), both()] }
    }

    /// Adds a row, of which these curves are `known`.
    pub(super) fn add(&mut self, pair: &Pair, known: [bool; 3]) {
        let Pair { time, log, scene } = pair;
        let values = [
            [scene.position, log.position],
            [scene.velocity, log.velocity],
            [scene.force, log.force],
        ];
        for (index, (curves, values)) in self.curves.iter_mut().zip(values).enumerate() {
            if known[index] {
                curves.iter_mut().zip(values).for_each(|(curve, value)| curve.add(*time, value));
            }
        }
    }
}

impl Laid {
    /// Figure of position, velocity and force of log and run.
    pub fn figure(&self) -> Figure {
        let labels = [("position", "m"), ("velocity", "m/s"), ("force", "N")];
        let panels = labels.into_iter().zip(&self.overlay.curves).map(|((name, unit), curves)| {
            let values = curves.iter().flat_map(|curve| curve.points().map(|point| point.1.abs()));
            let (factor, small) = match unit {
                "N" => (1.0, ""),
                _ => prefix(values.fold(0.0, f64::max)),
            };
            let [run, log] = curves.each_ref().map(|curve| {
                curve.points().map(|(time, value)| (time, factor * value)).collect::<Vec<_>>()
            });
            let made = |label, colour, points| match unit {
                "N" => Series::steps(label, colour, points),
                _ => Series::line(label, colour, points),
            };
            Panel::new(name, "time, s", format!("{name}, {small}{unit}"))
                .with_series(made("run", 0, run))
                .with_series(made("log", 1, log).dashed())
        });
        panels
            .fold(Figure::new(format!("{} over the run", file_name(&self.log))), Figure::with_panel)
            .with_width(960.0)
            .with_panel_height(190.0)
    }
}
