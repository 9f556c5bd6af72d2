//! Operator and device as two masses.

use lyapunov_core::{Drive, Mask, ParameterError, Plant, Requirement, Scalar, Signal};
use nalgebra::SMatrix;

use super::propagation::increments;
use crate::{Tethered, TwoMass};

/// An operator and a device joined by a link, moved exactly over each period; the drive tells the device's motion:
///
/// ```text
/// m_o ẍ_o + b_o ẋ_o + k_h (x_o − rest) + k_l (x_o − x_d) + b_l (ẋ_o − ẋ_d) = 0
/// m_d ẍ_d + b_d ẋ_d + k_l (x_d − x_o) + b_l (ẋ_d − ẋ_o) = −effort
/// ```
///
/// The effort is held over the period, so the motion is linear and known ([`held_input`](crate::held_input)). What
/// is kept and propagated is the centre of mass `X` and the stretch `s = x_o − x_d`, with their velocities: the
/// link's force comes of a small number that is known by itself, not of a difference of two large ones, and a stiff
/// link's fast motion stays out of the slow one's digits. `x_o = X + m_d s / M` and `x_d = X − m_o s / M` with
/// `M = m_o + m_d`.
#[derive(Clone, Copy, Debug)]
pub struct Linked<V: Signal> {
    period: V::Scalar,
    maps: Maps<V::Scalar>,
    /// The device's share in the stretch, `m_o / M`; the operator's is `m_d / M`.
    device_share: V::Scalar,
    operator_share: V::Scalar,
    rest: V,
    centre: V,
    stretch: V,
    velocity: V,
    stretching: V,
}

/// What the state gains over a period: centre, stretch and their velocities by row, the columns per unit of the
/// centre's deflection from the rest, of stretch, of their velocities and of effort.
type Maps<T> = [[T; 5]; 4];

impl<V: Signal> Linked<V> {
    /// Two masses with the operator's spring at rest at the origin, both standing there, moved by `period` s at a
    /// time.
    ///
    /// # Errors
    /// A mass, the link's stiffness or `period` not above 0 and finite; a damping or the operator's stiffness below
    /// 0, infinite or NaN; a mass so small against the rest that the motion is out of the scalar's range.
    pub fn new(parts: TwoMass<V::Scalar>, period: V::Scalar) -> Result<Self, ParameterError> {
        let period = Requirement::Positive.check("period", period)?;
        let maps = maps(parts, period)?;
        let (device_share, operator_share) = shares(parts);
        let zero = V::zero();
        Ok(Self {
            period,
            maps,
            device_share,
            operator_share,
            rest: zero,
            centre: zero,
            stretch: zero,
            velocity: zero,
            stretching: zero,
        })
    }

    /// The same masses with the operator's spring at rest at `rest`, m.
    pub fn resting_at(self, rest: V) -> Self {
        Self { rest, ..self }
    }

    /// The same masses, both at `position` m and moving at `velocity` m/s.
    pub fn starting(self, position: V, velocity: V) -> Self {
        let (centre, stretch, stretching) = (position, V::zero(), V::zero());
        Self { centre, stretch, velocity, stretching, ..self }
    }

    /// The operator's position, m, and velocity, m/s.
    #[inline]
    pub fn operator(&self) -> (V, V) {
        let share = self.operator_share;
        (self.centre + self.stretch.scale(share), self.velocity + self.stretching.scale(share))
    }

    #[inline]
    fn device(&self) -> (V, V) {
        let share = self.device_share;
        (self.centre - self.stretch.scale(share), self.velocity - self.stretching.scale(share))
    }
}

/// `m_o / M` and `m_d / M`.
fn shares<T: Scalar>(parts: TwoMass<T>) -> (T, T) {
    let of = |ratio: fn([f64; 2]) -> f64| {
        T::from_lanes(|lane| ratio([parts.operator.mass, parts.device.mass].map(|m| m.lane(lane))))
    };
    (
        of(|[operator, device]| operator / (operator + device)),
        of(|[operator, device]| device / (operator + device)),
    )
}

fn maps<T: Scalar>(parts: TwoMass<T>, interval: T) -> Result<Maps<T>, ParameterError> {
    let parts = parts.checked()?;
    let [centre, stretch, velocity, stretching, _]: [[T; 5]; 5] =
        increments(|lane| equations(parts, lane) * interval.lane(lane));
    let maps = [centre, stretch, velocity, stretching];
    let finite = maps.iter().flatten().fold(T::Mask::of(true), |all, entry| all & entry.finite());
    match (0..T::LANES).find(|&lane| !finite.lane(lane)) {
        None => Ok(maps),
        Some(lane) => Err(ParameterError {
            parameter: "device.mass",
            value: parts.device.mass.lane(lane),
            requirement: Requirement::InRange,
        }),
    }
}

/// The time derivatives of centre, stretch, their velocities and the held effort, by the same.
fn equations<T: Scalar>(parts: TwoMass<T>, lane: usize) -> SMatrix<f64, 5, 5> {
    let of = |value: T| value.lane(lane);
    let (operator, device, link) = (parts.operator, parts.device, parts.link);
    let (mo, bo, k) = (of(operator.mass), of(operator.damping), of(operator.stiffness));
    let (md, bd) = (of(device.mass), of(device.damping));
    let (kl, bl) = (of(link.stiffness), of(link.damping));
    let both = mo + md;
    let (to_operator, to_device) = (md / both, mo / both);
    let pulled = k * to_operator;
    let spring = pulled / mo + kl / mo + kl / md;
    let damper = bo * to_operator / mo + bd * to_device / md + bl / mo + bl / md;
    let skew = bd * to_device - bo * to_operator;
    let rows = [
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0],
        [-k / both, -pulled / both, -(bo + bd) / both, skew / both, -1.0 / both],
        [-k / mo, -spring, bd / md - bo / mo, -damper, 1.0 / md],
        [0.0; 5],
    ];
    SMatrix::from_row_slice(rows.as_flattened())
}

impl<V: Signal> Plant<V> for Linked<V> {
    #[inline]
    fn start(&self) -> Drive<V> {
        let (position, velocity) = self.device();
        Drive::starting(self.period, position, velocity)
    }

    #[inline]
    fn advance(&mut self, effort: V) -> Drive<V> {
        let (before, _) = self.device();
        let deflection = self.centre - self.rest;
        let (stretch, velocity, stretching) = (self.stretch, self.velocity, self.stretching);
        let gain = |row: [V::Scalar; 5]| {
            deflection.scale(row[0])
                + stretch.scale(row[1])
                + velocity.scale(row[2])
                + stretching.scale(row[3])
                + effort.scale(row[4])
        };
        self.centre = self.centre + gain(self.maps[0]);
        self.stretch = stretch + gain(self.maps[1]);
        self.velocity = velocity + gain(self.maps[2]);
        self.stretching = stretching + gain(self.maps[3]);
        let (position, velocity) = self.device();
        Drive::new(self.period, position, velocity, position - before, effort)
    }
}

impl<V: Signal> Tethered<V> for Linked<V> {
    type Parts = TwoMass<V::Scalar>;

    #[inline]
    fn rest_at(&mut self, rest: V) {
        self.rest = rest;
    }

    fn reshape(&mut self, parts: Self::Parts, interval: V::Scalar) -> Result<(), ParameterError> {
        let interval = Requirement::NonNegative.check("period", interval)?;
        self.maps = maps(parts, interval)?;
        self.period = interval;
        let (device_share, operator_share) = shares(parts);
        // Other masses have their centre elsewhere between where the two are.
        let shift = device_share - self.device_share;
        self.centre = self.centre + self.stretch.scale(shift);
        self.velocity = self.velocity + self.stretching.scale(shift);
        (self.device_share, self.operator_share) = (device_share, operator_share);
        Ok(())
    }
}
