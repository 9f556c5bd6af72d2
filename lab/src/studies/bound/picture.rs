//! Spectral radius of the linear loop over the stiffness.

use lyapunov_figures::{Figure, Guide, Numbering, Panel, Series};

use crate::files::Scene;
use crate::measure::{Limits, LinearPart};
use crate::show::csv::{self, Field};
use crate::text::{file_name, near_one};

/// The number of stiffnesses at which the loop is looked at.
const POINTS: u32 = 241;

/// The factor by which the curve goes beyond the least and the largest of the stiffnesses that are marked.
const BEYOND: f64 = 8.0;

/// Spectral radius of the linear loop of a scene over the stiffness of its environment, about its limits.
#[derive(Clone, Debug)]
pub struct RadiusCurve {
    /// Stiffness in N/m and spectral radius.
    points: Vec<(f64, f64)>,
    /// Stiffnesses with their names: the limits, and the scene's own.
    marks: Vec<(f64, String)>,
}

impl RadiusCurve {
    /// The curve of `scene` about its `limits`; none where no formula applies, or no stiffness is known.
    pub fn of(scene: &Scene, limits: &Limits) -> Option<Self> {
        let part = LinearPart::of(scene).ok()?;
        // The curve may be cut off there.
        let radius = limits.spectral_radius.map(|it| format!(", radius {}", near_one(it, 4)));
        let own = format!("this scene{}", radius.unwrap_or_default());
        let own = limits.stiffness.map(|stiffness| (stiffness, own));
        let named =
            limits.named().map(|(_, name, limit)| limit.map(|limit| (limit, name.to_owned())));
        let marks: Vec<_> = named.into_iter().flatten().chain(own).collect();
        let marks: Vec<_> = marks.into_iter().filter(|mark| mark.0 > 0.0).collect();
        let stiffnesses = || marks.iter().map(|mark| mark.0);
        let low = stiffnesses().reduce(f64::min)? / BEYOND;
        let high = stiffnesses().reduce(f64::max)? * BEYOND;
        let at = |index: u32| {
            let share = f64::from(index) / f64::from(POINTS - 1);
            let stiffness = low * libm::pow(high / low, share);
            let mut part = part;
            part.environment.stiffness = stiffness;
            (stiffness, part.spectral_radius())
        };
        let points: Vec<_> = (0..POINTS).map(at).filter(|point| point.1.is_finite()).collect();
        (!points.is_empty()).then_some(Self { points, marks })
    }

    /// The curve with the limits: the linear loop is stable where it is below 1.
    pub fn figure(&self, name: &str) -> Figure {
        let points = self.points.iter().map(|(stiffness, radius)| (stiffness.log10(), *radius));
        let radii = || self.points.iter().map(|point| point.1);
        let low = radii().fold(1.0, f64::min);
        // Far beyond the limit the radius grows without bound and would flatten the rest.
        let high = radii().fold(1.0, f64::max).min(1.0 + 4.0 * (1.0 - low).max(0.01));
        let room = 0.06 * (high - low);
        let panel = Panel::new(
            "spectral radius of the linear loop in contact",
            "stiffness of the environment, N/m",
            "spectral radius per period",
        )
        .with_numbers(Numbering::PowersOfTen, Numbering::Plain)
        .with_y_range(low - room, high + room)
        .with_series(Series::line("", 0, points.collect()))
        .with_guide(Guide::horizontal(1.0, "stable below"));
        let panel = self.marks.iter().fold(panel, |panel, (stiffness, name)| {
            panel.with_guide(Guide::vertical(stiffness.log10(), name.clone()))
        });
        Figure::new(file_name(name)).with_width(960.0).with_panel_height(320.0).with_panel(panel)
    }

    /// The curve as comma-separated values, in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let rows = self.points.iter();
        let rows = rows.map(|(stiffness, radius)| [*stiffness, *radius].map(Field::Number));
        csv::text(["stiffness_n_per_m", "spectral_radius"], rows)
    }
}
