//! Horizon: the time up to which a trace can be believed.

use lyapunov::{Correction, OnePort, PortSample, Scalar, accumulators::DoubleDouble};

use super::AccuracyError;
use super::reference::{References, Second, exact, off};
use super::trace::{Progress, trace_until};
use crate::files::Scene;
use crate::simulate::{Assembly, Port};

/// The growth factor from which a deviation belongs to the scene and no longer to the method.
pub(super) const GROWN: f64 = 1e5;

/// The factor by which a deviation must outgrow the motion over the scene for the scene to be chaotic.
const CHAOTIC: f64 = 1e6;

/// Share of a scene from the middle of its first quarter to that of its last.
const WIDENED: f64 = 0.75;

/// The most times that a deviation is brought back to its first size.
const SEGMENTS: usize = 8;

/// The largest error of a trace that is still believed, as a share of the motion's reach.
pub(super) const BELIEVED: f64 = 0.01;

/// Growth of deviations on a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Growth {
    /// The largest Lyapunov exponent, 1/s; none where the motion is too short or too still to tell.
    pub(super) exponent: Option<f64>,
    /// Whether the scene is chaotic.
    pub(super) chaotic: bool,
    /// The first tick at which a deviation of the start has grown so much that errors no longer say anything about the
    /// method.
    pub(super) grown_at: usize,
}

/// The motion's size over time: its reach at the end, and before that less by as much as it widens until then.
struct Extent {
    reach: f64,
    ticks: usize,
    /// The logarithm of the factor by which the motion widens in a tick, at least 0.
    widening: f64,
}

impl Extent {
    fn of(references: &References) -> Self {
        let (reach, ticks) = (references.reach(), references.first.len());
        let widened = widening(&references.first).max(1.0).ln().min(f64::MAX.ln());
        Self { reach, ticks, widening: widened / (WIDENED * ticks as f64) }
    }

    /// The size at a tick, m. A run that grows is as large as its reach at its end only.
    fn at(&self, tick: usize) -> f64 {
        self.reach * (-self.widening * (self.ticks - tick) as f64).exp()
    }
}

/// Sizes of a deviation, as shares of the motion's size: when it is made, when rounding hides it, and when it is no
/// longer small.
struct Sizes {
    made: f64,
    lost: f64,
    large: f64,
}

impl Sizes {
    /// Whether a deviation from a motion of this `size` tells of its growth.
    fn are_usable(&self, apart: f64, size: f64) -> bool {
        apart > self.lost * size && apart < self.large * size
    }
}

/// Small push on the plant at a tick.
struct Push<'a> {
    scene: &'a Scene,
    references: &'a References,
    extent: &'a Extent,
    sizes: &'a Sizes,
    from: usize,
}

impl Push<'_> {
    /// The pushed motion, up to where its deviation tells nothing any more; where `grown` is asked for, also up to where
    /// that has grown so much that errors say nothing about the method.
    fn followed(
        &self,
        grown: bool,
        progress: Progress<'_>,
    ) -> Result<Vec<[DoubleDouble; 2]>, AccuracyError> {
        let Self { scene, references, extent, sizes, from } = *self;
        let force = sizes.made * extent.at(from) * scene.port_mass() / scene.period().powi(2);
        let (mut first, mut has_grown, mut is_over) = (0.0, !grown, false);
        let enough = |tick: usize, state| {
            if tick <= from {
                return false;
            }
            let apart = self.apart(tick, state);
            if tick == from + 1 {
                first = apart;
            }
            has_grown |= apart > GROWN * first;
            is_over |= tick > from + 1 && !sizes.are_usable(apart, extent.at(tick));
            has_grown && is_over
        };
        trace_until(pushed(scene, from, force)?, references.first.len(), progress, enough)
    }

    /// The distance of `state` from the reference, with that of the velocities over a period, m.
    fn apart(&self, tick: usize, state: [DoubleDouble; 2]) -> f64 {
        let reference = self.references.first[tick];
        off(reference[0], state[0]) + self.scene.period() * off(reference[1], state[1])
    }
}

impl Growth {
    /// Follows a reference and the same motion with a small push, renewed wherever the deviation has grown large or
    /// died away.
    pub(super) fn of(
        scene: &Scene,
        references: &References,
        progress: Progress<'_>,
    ) -> Result<Self, AccuracyError> {
        let (extent, ticks) = (Extent::of(references), references.first.len());
        let sizes = match references.second {
            Second::Extrapolation => Sizes { made: 1e-20, lost: 1e-29, large: 1e-10 },
            Second::Adaptive | Second::Double => Sizes { made: 1e-9, lost: 1e-14, large: 1e-5 },
        };
        let (mut from, mut grown_at, mut logarithm, mut time) = (0, ticks, 0.0, 0.0);
        for segment in 0..SEGMENTS {
            if extent.reach <= 0.0 || from + 2 >= ticks {
                break;
            }
            let part = progress
                .part(segment as f64 / SEGMENTS as f64, (segment + 1) as f64 / SEGMENTS as f64);
            let push = Push { scene, references, extent: &extent, sizes: &sizes, from };
            let pushed = push.followed(segment == 0, part)?;
            let apart = |tick: usize| push.apart(tick, pushed[tick]);
            let (end, first) = (pushed.len(), apart(from + 1));
            if segment == 0 {
                grown_at = (1..end).find(|&tick| apart(tick) > GROWN * first).unwrap_or(end);
            }
            let is_over = |tick: &usize| !sizes.are_usable(apart(*tick), extent.at(*tick));
            let last = (from + 2..end).find(is_over).unwrap_or(end - 1);
            let grown = apart(last) / first;
            if grown > 0.0 && grown.is_finite() {
                logarithm += grown.ln();
                time += (last - from - 1) as f64 * scene.period();
            }
            from = last;
        }
        let exponent = (time > 0.0).then(|| logarithm / time);
        let seconds = ticks as f64 * scene.period();
        let beyond = exponent.unwrap_or(0.0) - extent.widening / scene.period();
        let chaotic = beyond * seconds > CHAOTIC.ln();
        Ok(Self { exponent, chaotic, grown_at })
    }
}

/// The width of the motion in the last quarter, as a multiple of that in the first.
fn widening(states: &[[DoubleDouble; 2]]) -> f64 {
    let width = |states: &[[DoubleDouble; 2]]| {
        let places = states.iter().map(|state| state[0].high());
        let ends = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
            (place.min(low), place.max(high))
        });
        ends.1 - ends.0
    };
    let quarter = states.len() / 4;
    let (first, last) = (width(&states[..quarter]), width(&states[states.len() - quarter..]));
    if first > 0.0 { last / first } else { 1.0 }
}

/// The loop of `scene`, exact, with a push of `force` N from tick `at` to the next.
fn pushed(scene: &Scene, at: usize, force: f64) -> Result<Assembly<DoubleDouble>, AccuracyError> {
    let Assembly { plant, port } = Assembly::of(&exact(scene)?)?;
    let port = Port::new(Pushed { port, at, force: DoubleDouble::of(force) });
    Ok(Assembly { plant, port })
}

/// Port with one small push.
struct Pushed {
    port: Port<DoubleDouble>,
    at: usize,
    force: DoubleDouble,
}

impl OnePort<DoubleDouble> for Pushed {
    fn respond(&mut self, sample: &PortSample<DoubleDouble>) -> DoubleDouble {
        let effort = self.port.respond(sample);
        let now = self.at == 0;
        // After the push the count stays at its largest and never reaches zero again.
        self.at = self.at.checked_sub(1).unwrap_or(usize::MAX);
        if now { effort + self.force } else { effort }
    }

    fn correction(&self) -> Correction<DoubleDouble> {
        self.port.correction()
    }
}
