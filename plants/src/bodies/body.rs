//! One mass on the operator's spring.

use lyapunov_core::{HeldTick, ParameterError, Plant, PortSample, Requirement, Scalar, Signal};
use nalgebra::{Matrix3, SMatrix};

use super::propagation::{self, by_rows, has_all_digits, rows};
use crate::{Impedance, Linear, OperatedBody};

/// A mass with damping and a spring to a rest position, moved exactly over each period:
/// `m ẍ + b ẋ + k (x − rest) = −effort`.
///
/// The effort is held over the period, so the motion is linear and has a closed form: `x += E₁₁ p + E₁₂ v + G₁ f` and
/// `v += E₂₁ p + E₂₂ v + G₂ f` with `p = x − rest` and the increments of the matrix exponential, computed once
/// ([`held_input`](crate::held_input)). Every axis moves like that. With the operator's `stiffness` and `rest`, and the mass and damping
/// of operator and device together, it is the left side of the paper's figure 2; that the two move as one is our
/// reading, the paper does not say so.
///
/// ```
/// use lyapunov_core::Plant;
/// use lyapunov_plants::{Body, Impedance};
/// let mass = Impedance { mass: 0.5, damping: 0.0, stiffness: 0.0 };
/// let mut body = Body::new(mass, 1e-3)?.starting(0.0, 0.0);
/// let sample = body.advance(-2.0); // an effort acts against the motion: −2 N push forward
/// assert!((sample.velocity - 4e-3_f64).abs() < 1e-15 && (sample.displacement - 2e-6).abs() < 1e-18);
/// assert_eq!(sample.applied, -2.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Body<V: Signal> {
    period: V::Scalar,
    position_map: Row<V::Scalar>,
    velocity_map: Row<V::Scalar>,
    rest: V,
    position: V,
    velocity: V,
}

/// The gain of one part of the state over a period, per unit of deflection, velocity and effort.
#[derive(Clone, Copy, Debug)]
struct Row<T> {
    deflection: T,
    velocity: T,
    effort: T,
}

impl<T: Scalar> Row<T> {
    #[inline(always)]
    fn of([deflection, velocity, effort]: [T; 3]) -> Self {
        Self { deflection, velocity, effort }
    }

    #[inline(always)]
    fn finite(&self) -> T::Mask {
        self.deflection.finite() & self.velocity.finite() & self.effort.finite()
    }

    #[inline(always)]
    fn gain<V: Signal<Scalar = T>>(&self, deflection: V, velocity: V, effort: V) -> V {
        deflection.scale(self.deflection)
            + velocity.scale(self.velocity)
            + effort.scale(self.effort)
    }
}

impl<V: Signal> Body<V> {
    /// A body at standstill at the origin, where its spring rests too, moved by `period` s at a time.
    ///
    /// # Errors
    /// `mass` or `period` not above 0 and finite; `damping` or `stiffness` below 0, infinite or NaN; a mass so small
    /// beside the other values that the motion is out of the scalar's range.
    pub fn new(impedance: Impedance<V::Scalar>, period: V::Scalar) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        let [position_map, velocity_map] = maps_lane_by_lane(impedance, period)?;
        let (rest, position, velocity) = (V::zero(), V::zero(), V::zero());
        Ok(Self { period, position_map, velocity_map, rest, position, velocity })
    }

    /// The same body with the rest of its spring at `rest`, m.
    #[must_use]
    pub fn resting_at(self, rest: V) -> Self {
        Self { rest, ..self }
    }

    /// The rest of the spring, m.
    pub(super) fn rest(&self) -> V {
        self.rest
    }

    /// The position, m.
    pub(super) fn position(&self) -> V {
        self.position
    }

    /// The velocity, m/s.
    pub(super) fn velocity(&self) -> V {
        self.velocity
    }

    /// The same body at `position` m, moving at `velocity` m/s.
    #[must_use]
    pub fn starting(self, position: V, velocity: V) -> Self {
        Self { position, velocity, ..self }
    }
}

/// The gains by row, of a motion in the scalar's range.
#[inline(always)]
fn in_range<T: Scalar>(
    mass: T,
    [position, velocity]: [[T; 3]; 2],
) -> Result<[Row<T>; 2], ParameterError> {
    let rows = [Row::of(position), Row::of(velocity)];
    let finite = rows[0].finite() & rows[1].finite();
    Requirement::InRange.require("mass", mass, finite).map(|()| rows)
}

/// The gains over `interval`, by one function for every signal of a scalar.
#[inline(never)]
fn maps_lane_by_lane<T: Scalar>(
    parts: Impedance<T>,
    interval: T,
) -> Result<[Row<T>; 2], ParameterError> {
    let parts = parts.checked()?;
    in_range(parts.mass, lane_by_lane(parts, interval))
}

/// The gains of position and velocity over `interval` per unit of deflection, velocity and effort; nothing is checked.
#[inline(always)]
pub(crate) fn impedance_increments<T: Scalar>(parts: Impedance<T>, interval: T) -> [[T; 3]; 2] {
    if T::LANES == 1 || !has_all_digits::<T>() {
        return lane_by_lane(parts, interval);
    }
    rows(&increments(parts, interval))
}

/// The same gains, bit for bit, by one function for the lanes of all scalars. It is small, and outside of a loop on lanes faster:
/// lanes are slow without the instructions of such a loop.
fn lane_by_lane<T: Scalar>(parts: Impedance<T>, interval: T) -> [[T; 3]; 2] {
    by_rows(|lane| {
        let parts = parts.map(|number| number.real(lane));
        let increments = out_of_line(parts, interval.real(lane));
        if has_all_digits::<T>() { increments } else { keeping_area::<T>(increments) }
    })
}

#[inline(never)]
fn out_of_line<R: Scalar>(parts: Impedance<R>, interval: R) -> Matrix3<R> {
    increments(parts, interval)
}

#[inline(always)]
fn increments<R: Scalar>(parts: Impedance<R>, interval: R) -> Matrix3<R> {
    let Impedance { mass: m, damping: b, stiffness: k } = parts;
    let (none, one) = (R::zero(), R::one());
    let rate = [[none, one, none], [-k / m, -b / m, -one / m], [none; 3]];
    propagation::increments::<R, 3, 2>(propagation::scaled(&rate, interval))
}

/// `increments` with the first entry corrected by the last digits of the scalar, so that the rounding of the others
/// does not change the determinant of the map.
///
/// The determinant is the factor by which the map scales an area of positions and velocities. Without damping it is 1,
/// and each unit that rounding adds or takes makes the amplitude grow or fall by half of it on every step.
fn keeping_area<T: Scalar>(mut increments: Matrix3<T::Real>) -> Matrix3<T::Real> {
    let one = T::Real::of(1.0);
    let rounded = increments.map(|entry| T::from_reals(|_| entry).real(0));
    let area = |e: &Matrix3<T::Real>| {
        e[(0, 0)] + e[(1, 1)] + (e[(0, 0)] * e[(1, 1)] - e[(0, 1)] * e[(1, 0)])
    };
    let lost = (area(&increments) - area(&rounded)) / (one + rounded[(1, 1)]);
    // Without damping no more than this is lost; with much of it the last digits of the entry matter more than the
    // area.
    let most = rounded[(0, 0)].magnitude() * T::epsilon().real(0) * T::Real::of(3.0);
    if lost.magnitude().below(most) {
        increments[(0, 0)] = rounded[(0, 0)] + lost;
    }
    increments
}

impl<V: Signal> Plant<V> for Body<V> {
    #[inline(always)]
    fn start(&self) -> PortSample<V> {
        PortSample::starting(self.period, self.position, self.velocity)
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let deflection = self.position - self.rest;
        let before = self.position;
        self.position = before + self.position_map.gain(deflection, self.velocity, effort);
        self.velocity = self.velocity + self.velocity_map.gain(deflection, self.velocity, effort);
        let displacement = self.position - before;
        HeldTick {
            period: self.period,
            position: self.position,
            velocity: self.velocity,
            displacement,
            applied: effort,
        }
        .sample()
    }
}

impl<V: Signal> OperatedBody<V> for Body<V> {
    type Parts = Impedance<V::Scalar>;

    #[inline(always)]
    fn rest_at(&mut self, rest: V) {
        self.rest = rest;
    }

    #[inline(always)]
    fn reshape(&mut self, parts: Self::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        let interval = Requirement::NonNegative.check("period", interval)?;
        let parts = parts.checked()?;
        let gains = impedance_increments(parts, interval);
        [self.position_map, self.velocity_map] = in_range(parts.mass, gains)?;
        self.period = interval;
        Ok(())
    }
}

impl<T: Scalar> Linear<T, 2> for Body<T> {
    #[inline(always)]
    fn rate<R: Scalar>(parts: &Impedance<T>, number: impl Fn(T) -> R) -> SMatrix<R, 2, 2> {
        let Impedance { mass, damping, stiffness } = parts.map(number);
        let rate = [[R::zero(), R::one()], [-stiffness / mass, -damping / mass]];
        SMatrix::from_fn(|row, column| rate[row][column])
    }

    #[inline(always)]
    fn device_mass(parts: &Impedance<T>) -> T {
        parts.mass
    }

    #[inline(always)]
    fn rest(&self) -> T {
        self.rest
    }

    #[inline(always)]
    fn state(&self) -> [T; 2] {
        [self.position, self.velocity]
    }

    #[inline(always)]
    fn place(&mut self, of: T::Mask, [position, velocity]: [T; 2]) {
        self.position = T::choose(of, position, self.position);
        self.velocity = T::choose(of, velocity, self.velocity);
    }
}
