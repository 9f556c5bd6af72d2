//! Figure of a run.

use lyapunov_figures::{Figure, Guide, Panel, Series};

use super::Curves;
use crate::measure::summary::MILLI;
use crate::measure::{Summary, Trace, Verdict};
use crate::text::file_name;

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

impl Curves {
    /// Figure of position, force, energy and velocity over time; that of a run that grows ends at ten starting swings.
    pub fn figure(&self, name: &str, summary: &Summary) -> Figure {
        let until = Self::until(summary);
        let panel =
            |title: &str, label: &str| Panel::new(title, "time, s", label).with_x_range(0.0, until);
        let points = |trace: &Trace, scale: f64| -> Vec<(f64, f64)> {
            let points = trace.clone().finish();
            let shown = points.into_iter().take_while(|point| point.0 <= until);
            shown.map(|(t, y)| (t, scale * y)).collect()
        };
        let along = |panel: Panel, scale: f64, of: fn(&super::curves::Axis) -> &Trace| {
            let many = self.axes.len() > 1;
            self.axes.iter().enumerate().fold(panel, |panel, (index, axis)| {
                let label = if many { AXES[index % AXES.len()] } else { "" };
                panel.with_series(Series::line(label, index, points(of(axis), scale)))
            })
        };
        let mut position = along(panel("position", "position, mm"), MILLI, |axis| &axis.position);
        if let Some(wall) = summary.scene.environment.wall() {
            position =
                position.with_guide(Guide::horizontal(MILLI * wall.position.get(), "wall surface"));
        }
        let force = match self.axes.len() {
            1 => panel("force", "force, N")
                .with_series(Series::steps("on the plant", 1, points(&self.axes[0].force, 1.0)))
                .with_series(Series::steps("environment", 0, points(&self.environment, 1.0))),
            _ => along(panel("force on the plant", "force, N"), 1.0, |axis| &axis.force),
        };
        let mut energy = panel("energy", "energy, mJ")
            .with_series(Series::line("into the port", 0, points(&self.port, MILLI)))
            .with_guide(Guide::horizontal(0.0, ""));
        if summary.stabilizing.is_there() && summary.reports_debt() {
            let observed = points(&self.observed, MILLI);
            energy = energy.with_series(Series::line("observed by the stabilizer", 1, observed));
        }
        let velocity = along(panel("velocity", "velocity, mm/s"), MILLI, |axis| &axis.velocity);
        [position, force, energy, velocity]
            .into_iter()
            .fold(Figure::new(file_name(name)), Figure::with_panel)
            .with_width(960.0)
            .with_panel_height(190.0)
    }

    /// The last time that is shown, s: of a run that grows that of its verdict, since what follows would flatten all before.
    fn until(summary: &Summary) -> f64 {
        let last = summary.left_range().unwrap_or(summary.scene.end());
        // In a space it is the distance that leaves its bound, and not any axis.
        let out = summary.out_since.filter(|_| summary.verdict() == Verdict::Grows);
        out.map_or(last, |out| out.min(last))
    }

    /// The sentence under the figure.
    pub(super) fn caption(summary: &Summary) -> String {
        let end = summary.scene.end();
        let energy = "The energy into the port is the work of the applied force on the true motion: below 0, more came \
                      out than went in.";
        if Self::until(summary) < end {
            format!("Up to ten starting swings, beyond which the run grows. {energy}")
        } else {
            energy.to_owned()
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::*;
    use crate::files::Scene;
    use crate::simulate::Rollout;

    /// Slanting to the axes the distance leaves its bound before any of them does.
    #[test]
    fn a_run_in_a_space_is_drawn_up_to_its_verdict() {
        let text = "duration = 2\nservo_rate = 1000\nspace.dimensions = 3\ndevice = { mass = 0.25, damping = 0.8 }\n\
            operator = { mass = 0.2, damping = 3, stiffness = 250, rest = [0.01, 0.02, -0.01] }\n\
            initial.position = [-0.01, 0, 0.005]\neffects.delay.ticks = 2\n\
            environment.plane = { point = [0, 0, 0], normal = [-1, -1, 0.5], stiffness = 20000 }\n";
        let scene = Scene::parse(text, "test").unwrap();
        let run = Rollout::<SVector<f64, 3>>::of(&scene).unwrap();
        let summary = Summary::of(&scene, run);
        let start = summary.fate.criterion(0).start;
        let mut far = Rollout::<SVector<f64, 3>>::of(&scene).unwrap();
        let rest = SVector::<f64, 3>::from_vec(summary.equilibrium.clone().unwrap());
        let out = far.find(|tick| (tick.truth.position - rest).norm() > 10.0 * start);
        assert_eq!(Curves::until(&summary), out.unwrap().time);
    }
}
