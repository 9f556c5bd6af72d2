//! Operator and device as two masses with a link.

use lyapunov_core::lanes::apart;
use lyapunov_core::{
    HeldTick, Mask, ParameterError, Plant, PortSample, Requirement, Scalar, Signal,
};
use nalgebra::SMatrix;

use super::propagation::{self, by_rows, has_all_digits, rows};
use crate::{Linear, OperatedBody, TwoMassParts};

/// An operator and a device joined by a link, moved exactly over each period; the sample reports the device's motion:
///
/// ```text
/// m_o ẍ_o + b_o ẋ_o + k_h (x_o − rest) + k_l (x_o − x_d) + b_l (ẋ_o − ẋ_d) = 0
/// m_d ẍ_d + b_d ẋ_d + k_l (x_d − x_o) + b_l (ẋ_d − ẋ_o) = −effort
/// ```
///
/// The effort is held over the period, so the motion is linear and has a closed form
/// ([`held_input`](crate::held_input)). It is computed for the centre of mass `X` and the stretch `s = x_o − x_d`,
/// where the fast motion of a stiff link costs the slow motion no digits: `x_o = X + m_d s / M` and
/// `x_d = X − m_o s / M` with `M = m_o + m_d`. The state is `x_d` and `s`, with their velocities: the link's force
/// comes from a small number that is stored by itself, not from the difference of two large ones, and a device at
/// standstill stays there to the bit.
///
/// ```
/// use lyapunov_core::Plant;
/// use lyapunov_plants::{DampedMass, ElasticJoint, Impedance, TwoMassBody, TwoMassParts};
/// let parts = TwoMassParts {
///     operator: Impedance { mass: 0.1, damping: 0.2, stiffness: 0.0 },
///     device: DampedMass { mass: 0.2, damping: 0.0 },
///     link: ElasticJoint { stiffness: 2000.0, damping: 1.0 },
/// };
/// let mut arm = TwoMassBody::new(parts, 1e-3)?.starting(0.0, 0.0);
/// let sample = arm.advance(-1.0); // the port is at the device; the operator follows through the link
/// let (position, _) = arm.operator();
/// assert!(sample.position > position && position > 0.0_f64);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TwoMassBody<V: Signal> {
    period: V::Scalar,
    maps: Maps<V::Scalar>,
    rest: V,
    position: V,
    stretch: V,
    velocity: V,
    stretching: V,
}

/// The gains of the state over a period: device, stretch and their velocities by row, the columns per unit of the
/// device's deflection from the rest, of stretch, of their velocities and of effort.
type Maps<T> = [[T; 5]; 4];

impl<V: Signal> TwoMassBody<V> {
    /// Two masses at standstill at the origin, where the operator's spring rests, moved by `period` s at a time.
    ///
    /// # Errors
    /// A mass, the link's stiffness or `period` not above 0 and finite; a damping or the operator's stiffness below 0,
    /// infinite or NaN; a mass so small beside the other values that the motion is out of the scalar's range.
    pub fn new(parts: TwoMassParts<V::Scalar>, period: V::Scalar) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        let maps = maps_lane_by_lane(parts, period)?;
        let (rest, position, stretch) = (V::zero(), V::zero(), V::zero());
        let (velocity, stretching) = (V::zero(), V::zero());
        Ok(Self { period, maps, rest, position, stretch, velocity, stretching })
    }

    /// The same masses with the rest of the operator's spring at `rest`, m.
    #[must_use]
    pub fn resting_at(self, rest: V) -> Self {
        Self { rest, ..self }
    }

    /// The same masses, both at `position` m and moving at `velocity` m/s.
    #[must_use]
    pub fn starting(self, position: V, velocity: V) -> Self {
        Self { position, velocity, stretch: V::zero(), stretching: V::zero(), ..self }
    }

    /// The operator's position, m, and velocity, m/s.
    #[inline(always)]
    pub fn operator(&self) -> (V, V) {
        (self.position + self.stretch, self.velocity + self.stretching)
    }
}

/// Check of gains: those of a motion in the scalar's range.
#[inline(always)]
fn in_range<T: Scalar>(device: T, maps: &Maps<T>) -> Result<(), ParameterError> {
    let mut finite = T::Mask::of(true);
    for row in maps {
        for entry in row {
            finite = finite & entry.finite();
        }
    }
    Requirement::InRange.require("device mass", device, finite)
}

/// The gains over `interval`, by one function for every signal of a scalar.
#[inline(never)]
fn maps_lane_by_lane<T: Scalar>(
    parts: TwoMassParts<T>,
    interval: T,
) -> Result<Maps<T>, ParameterError> {
    let parts = parts.checked()?;
    let maps = lane_by_lane(parts, interval);
    in_range(parts.device.mass, &maps)?;
    Ok(maps)
}

/// The gains of device, stretch and their velocities over `interval`; nothing is checked.
#[inline(always)]
pub(crate) fn two_mass_increments<T: Scalar>(parts: TwoMassParts<T>, interval: T) -> Maps<T> {
    if T::LANES == 1 || !has_all_digits::<T>() {
        return lane_by_lane(parts, interval);
    }
    rows(&increments(parts, interval))
}

/// The same gains, bit for bit, by one function for the lanes of all scalars; for the reasons of [`Body`](crate::Body).
fn lane_by_lane<T: Scalar>(parts: TwoMassParts<T>, interval: T) -> Maps<T> {
    by_rows(|lane| out_of_line(parts.map(|number| number.real(lane)), interval.real(lane)))
}

#[inline(never)]
fn out_of_line<R: Scalar>(parts: TwoMassParts<R>, interval: R) -> Map<R> {
    increments(parts, interval)
}

/// A linear map of centre, stretch, their velocities and the held effort.
type Map<R> = SMatrix<R, 5, 5>;

#[inline(always)]
fn increments<R: Scalar>(parts: TwoMassParts<R>, interval: R) -> Map<R> {
    let rates = propagation::scaled(&equations(parts), interval);
    of_device(parts, propagation::increments::<R, 5, 4>(rates))
}

/// The gains of device and stretch from those of centre and stretch: `x_d = X − m_o s / M`, alike for the velocities.
#[inline(always)]
fn of_device<R: Scalar>(parts: TwoMassParts<R>, mut gains: Map<R>) -> Map<R> {
    let (operator, device) = (parts.operator.mass, parts.device.mass);
    let share = operator / (operator + device);
    for column in &mut gains.data.0 {
        for centre in [0, 2] {
            apart::<R>();
            column[centre] += -share * column[centre + 1];
        }
    }
    for centre in [0, 2] {
        for row in 0..4 {
            apart::<R>();
            gains.data.0[centre + 1][row] += gains.data.0[centre][row] * share;
        }
    }
    gains
}

/// The time derivatives of centre, stretch, their velocities and the held effort by row, as a map of the same.
#[inline(always)]
fn equations<R: Scalar>(parts: TwoMassParts<R>) -> [[R; 5]; 5] {
    let TwoMassParts { operator, device, link } = parts;
    let (mo, bo, k) = (operator.mass, operator.damping, operator.stiffness);
    let (md, bd) = (device.mass, device.damping);
    let (kl, bl) = (link.stiffness, link.damping);
    let both = mo + md;
    let (to_operator, to_device) = (md / both, mo / both);
    let pulled = k * to_operator;
    let spring = pulled / mo + kl / mo + kl / md;
    let damper = bo * to_operator / mo + bd * to_device / md + bl / mo + bl / md;
    let skew = bd * to_device - bo * to_operator;
    let (none, one) = (R::zero(), R::one());
    [
        [none, none, one, none, none],
        [none, none, none, one, none],
        [-k / both, -pulled / both, -(bo + bd) / both, skew / both, -one / both],
        [-k / mo, -spring, bd / md - bo / mo, -damper, one / md],
        [none; 5],
    ]
}

/// The gain of one part of the state. A closure as long as this is called, and what is called computes lanes on the base set of
/// instructions.
#[inline(always)]
fn gain<V: Signal>(row: &[V::Scalar; 5], state: &[V; 5]) -> V {
    state[0].scale(row[0])
        + state[1].scale(row[1])
        + state[2].scale(row[2])
        + state[3].scale(row[3])
        + state[4].scale(row[4])
}

impl<V: Signal> Plant<V> for TwoMassBody<V> {
    #[inline]
    fn start(&self) -> PortSample<V> {
        PortSample::starting(self.period, self.position, self.velocity)
    }

    #[inline(always)]
    fn advance(&mut self, effort: V) -> PortSample<V> {
        let before = self.position;
        let (stretch, velocity, stretching) = (self.stretch, self.velocity, self.stretching);
        let state = [before - self.rest, stretch, velocity, stretching, effort];
        self.position = before + gain(&self.maps[0], &state);
        self.stretch = stretch + gain(&self.maps[1], &state);
        self.velocity = velocity + gain(&self.maps[2], &state);
        self.stretching = stretching + gain(&self.maps[3], &state);
        HeldTick {
            period: self.period,
            position: self.position,
            velocity: self.velocity,
            displacement: self.position - before,
            applied: effort,
        }
        .sample()
    }
}

impl<V: Signal> OperatedBody<V> for TwoMassBody<V> {
    type Parts = TwoMassParts<V::Scalar>;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.rest = rest;
    }

    #[inline(always)]
    fn reshape(&mut self, parts: Self::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        let interval = Requirement::NonNegative.check("period", interval)?;
        let parts = parts.checked()?;
        let maps = two_mass_increments(parts, interval);
        in_range(parts.device.mass, &maps)?;
        self.maps = maps;
        self.period = interval;
        Ok(())
    }
}

impl<T: Scalar> Linear<T, 4> for TwoMassBody<T> {
    #[inline(always)]
    fn rate<R: Scalar>(parts: &TwoMassParts<T>, number: impl Fn(T) -> R) -> SMatrix<R, 4, 4> {
        let TwoMassParts { operator, device, link } = parts.map(number);
        let (mo, md) = (operator.mass, device.mass);
        let (kl, bl) = (link.stiffness, link.damping);
        let (k, bo, bd) = (operator.stiffness, operator.damping, device.damping);
        let (none, one) = (R::zero(), R::one());
        let rows = [
            [none, one, none, none],
            [-(k + kl) / mo, -(bo + bl) / mo, kl / mo, bl / mo],
            [none, none, none, one],
            [kl / md, bl / md, -kl / md, -(bd + bl) / md],
        ];
        SMatrix::from_fn(|row, column| rows[row][column])
    }

    #[inline(always)]
    fn device_mass(parts: &TwoMassParts<T>) -> T {
        parts.device.mass
    }

    #[inline(always)]
    fn rest(&self) -> T {
        self.rest
    }

    #[inline(always)]
    fn state(&self) -> [T; 4] {
        let (position, velocity) = self.operator();
        [position, velocity, self.position, self.velocity]
    }

    #[inline(always)]
    fn place(&mut self, of: T::Mask, [x, v, position, velocity]: [T; 4]) {
        let choose = |new, kept| T::choose(of, new, kept);
        self.position = choose(position, self.position);
        self.velocity = choose(velocity, self.velocity);
        self.stretch = choose(x - position, self.stretch);
        self.stretching = choose(v - velocity, self.stretching);
    }
}
