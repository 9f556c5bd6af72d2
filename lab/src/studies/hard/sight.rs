//! One tick of one lane, as a judge sees it.

use lyapunov::{Correction, Mask, PortSample, Scalar, Signal};

use super::tally::larger;

/// The most axes that a port may have here.
pub(super) const AXES: usize = 4;

/// The axes of a signal in one lane, and 0 in place of axes that it does not have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes {
    pub(super) values: [f64; AXES],
    pub(super) count: usize,
}

impl Axes {
    pub(super) fn of<V: Signal>(signal: V, lane: usize) -> Self {
        let (mut values, mut count) = ([0.0; AXES], 0);
        signal.map(|axis| {
            values[count] = axis.lane(lane);
            count += 1;
            axis
        });
        Self { values, count }
    }

    pub(super) fn finite(&self) -> bool {
        self.all().iter().all(|axis| axis.is_finite())
    }

    fn all(&self) -> &[f64] {
        &self.values[..self.count]
    }

    pub(super) fn inner(&self, other: &Self) -> f64 {
        (0..AXES).map(|axis| self.values[axis] * other.values[axis]).sum()
    }

    /// The component in the direction of `other`; 0 where that has none.
    ///
    /// The direction is taken first: the product of two vectors of a loop that grows leaves the range before they do.
    pub(super) fn along(&self, other: &Self) -> f64 {
        let length = other.length();
        if length == 0.0 {
            return 0.0;
        }
        (0..AXES).map(|axis| self.values[axis] * (other.values[axis] / length)).sum()
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        let mut values = self.values;
        for (axis, value) in values.iter_mut().enumerate() {
            *value -= other.values[axis];
        }
        Self { values, ..*self }
    }

    pub(super) fn length(&self) -> f64 {
        self.all().iter().copied().fold(0.0, f64::hypot)
    }

    pub(super) fn largest(&self) -> f64 {
        self.farthest(0.0)
    }

    /// The largest distance of an axis from `rest`.
    pub(super) fn farthest(&self, rest: f64) -> f64 {
        self.all().iter().fold(0.0, |most, axis| larger(most, (axis - rest).abs()))
    }
}

/// One tick of one lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    pub(super) period: f64,
    pub(super) position: Axes,
    pub(super) velocity: Axes,
    pub(super) displacement: Axes,
    pub(super) applied: Axes,
    pub(super) work: Axes,
    pub(super) others: Axes,
    pub(super) effort: Axes,
    pub(super) out: Axes,
    pub(super) sum: f64,
    pub(super) alpha: f64,
    pub(super) shortfall: f64,
    pub(super) accepted: bool,
}

impl Sight {
    pub(super) fn of<V: Signal>(
        lane: usize,
        sample: &PortSample<V>,
        others: V,
        effort: V,
        correction: &Correction<V>,
    ) -> Self {
        Self {
            period: sample.period.lane(lane),
            position: Axes::of(sample.position, lane),
            velocity: Axes::of(sample.velocity, lane),
            displacement: Axes::of(sample.displacement, lane),
            applied: Axes::of(sample.applied, lane),
            work: Axes::of(sample.work, lane),
            others: Axes::of(others, lane),
            effort: Axes::of(effort, lane),
            out: Axes::of(correction.effort, lane),
            sum: correction.observed_energy.lane(lane),
            alpha: correction.alpha.lane(lane),
            shortfall: correction.shortfall.lane(lane),
            accepted: correction.accepted.lane(lane),
        }
    }

    pub(super) fn sound(&self) -> bool {
        let sample =
            [&self.position, &self.velocity, &self.displacement, &self.applied, &self.work];
        self.period.is_finite() && self.effort.finite() && sample.iter().all(|axes| axes.finite())
    }

    /// Whether it spans a time.
    pub(super) fn timed(&self) -> bool {
        self.period > 0.0 && self.period.is_finite()
    }

    /// `v² T`, J per N·s/m.
    pub(super) fn square(&self) -> f64 {
        self.velocity.inner(&self.velocity) * self.period
    }

    /// The largest energy, power or square that a stabilizer may make of it, in J, W, m²/s², m² or N²: what the range of
    /// its scalar has to hold.
    pub(super) fn energy(&self) -> f64 {
        let power = self.effort.inner(&self.velocity).abs();
        let square = |axes: &Axes| axes.inner(axes);
        let over_time = self.square().max(power).max(power * self.period).max(0.0);
        let [v, moved, force] = [&self.velocity, &self.displacement, &self.effort];
        over_time.max(square(v)).max(square(moved)).max(square(force))
    }

    /// Energy that the correction is to dissipate, J: nothing without damping, whatever the velocity.
    pub(super) fn burnt(&self) -> f64 {
        if self.alpha == 0.0 { 0.0 } else { self.alpha * self.square() }
    }
}
