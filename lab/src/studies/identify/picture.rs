//! Figure of a fit.

use lyapunov_figures::{Figure, Guide, Panel, Series};

use super::Identified;
use super::wall::Seen;
use crate::measure::summary::MILLI;
use crate::text::file_name;

/// Factor from m to µm.
const MICRO: f64 = 1e6;

impl Identified {
    /// Figure of log and run, of what the fit leaves, and of the force over the position.
    pub fn figure(&self) -> Figure {
        let panels = [self.motion(), self.residual(), self.force()];
        let figure =
            Figure::new(file_name(&self.report.log)).with_width(960.0).with_panel_height(220.0);
        panels.into_iter().fold(figure, Figure::with_panel)
    }

    /// A position of the recording, mm.
    fn place(&self, x: f64) -> f64 {
        MILLI * (self.recording.origin + x)
    }

    fn start(&self) -> f64 {
        self.recording.times().map_or(0.0, |it| it.0)
    }

    fn motion(&self) -> Panel {
        let start = self.start();
        let of_log = self.recording.stretches.iter().flat_map(|it| {
            let points =
                it.times.iter().zip(&it.positions).map(|(t, x)| (t - start, self.place(*x)));
            points.chain([(f64::NAN, f64::NAN)])
        });
        let log: Vec<_> = of_log.collect();
        let panel = Panel::new("(a) position", "time, s", "position, mm")
            .with_series(Series::line("log", 0, log));
        let panel = match &self.replay {
            Some(replay) => {
                let points = replay.points.iter().map(|(t, x)| (*t, MILLI * x)).collect();
                panel.with_series(Series::line("run of the fitted scene", 1, points).dashed())
            }
            None => panel,
        };
        match &self.report.wall {
            Some(wall) => {
                panel.with_guide(Guide::horizontal(MILLI * wall.position.value, "wall surface"))
            }
            None => panel,
        }
    }

    fn residual(&self) -> Panel {
        let start = self.start();
        let late = self.device.lag();
        let mut fitted = self.device.fitted().iter();
        let mut points = Vec::new();
        for stretch in &self.recording.stretches {
            let rows = stretch.times.iter().zip(&stretch.positions).skip(late);
            let left = |((t, x), fit): ((&f64, &f64), &f64)| (t - start, MICRO * (x - fit));
            points.extend(rows.zip(fitted.by_ref()).map(left));
            points.push((f64::NAN, f64::NAN));
        }
        // The fit whose numbers are told.
        let title = match self.device.is_pushed {
            false => "(b) what the model leaves under the log's force",
            true => {
                "(b) what the model leaves over 32 rows, under the log's force and a constant one"
            }
        };
        Panel::new(title, "time, s", "x − model, µm")
            .with_series(Series::line("", 0, points))
            .with_guide(Guide::horizontal(0.0, ""))
    }

    fn force(&self) -> Panel {
        let late = self.wall.as_ref().map_or(0, |wall| wall.lag);
        let rows = self.recording.stretches.iter().flat_map(|it| {
            it.positions.iter().zip(it.forces.iter().skip(late)).map(|(x, f)| (self.place(*x), *f))
        });
        let panel = Panel::new("(c) force over position", "position, mm", "force, N")
            .with_series(Series::dots("log", 0, rows.collect()));
        let Some(wall) = &self.wall else { return panel };
        let [low, high] = self.recording.ends();
        let place = wall.position();
        let places = [low, place, place, high.max(place)];
        let line = places.map(|x| (self.place(x), wall.force_at(x, 0.0)));
        let label = if wall.seen == Seen::Fitted {
            "wall at rest, over the fitted position"
        } else {
            "wall at rest"
        };
        panel.with_series(Series::line(label, 1, line.to_vec()))
    }
}
