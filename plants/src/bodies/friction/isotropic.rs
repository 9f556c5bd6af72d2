//! Dry friction in a plane or in space, with true sticking.

use lyapunov_core::{
    Accumulator, Compensated, HeldTick, ParameterError, Plant, PortSample, Scalar,
};
use nalgebra::SVector;

use super::Stribeck;
use super::series::System;
use super::trajectory::{PIECES, Trajectory};
use super::transition::set;
use super::turning::Planar;
use crate::{Body, Impedance, OperatedBody};

/// One mass with [`Stribeck`] friction on several axes, the same in every direction: `m v̇ = f − F(|v|) v / |v|` while it
/// slides, with `f` all other forces, and `v = 0` exactly while it sticks, `|f| ≤ static`.
///
/// Friction opposes the velocity as a vector, so what slides along one direction is held in no other. On a line it is
/// [`Friction`](super::Friction), bit for bit where that is an axis: a device that starts from rest under a held effort
/// moves along a line for the whole period, and so does one whose velocity points along the other forces. Everywhere
/// else the direction turns; that is a power series of order 24 (Taylor's method, to rounding) in steps that shrink as
/// the device slows down, for the direction is singular where it stops. A device that would stop within `2⁻⁴⁴` of a period
/// has stopped; the speed that it has left, less than `10⁻¹³` of what it may lose in a period, becomes heat.
///
/// Lanes are computed one by one, in `f64`; with `static` 0 the body moves as without friction, bit for bit. A period of
/// more than 1024 pieces is moved over roughly, as [`Friction`](super::Friction) does. Friction never adds energy.
///
/// ```
/// use lyapunov_core::{ParameterError, Plant};
/// use lyapunov_plants::{Body, Impedance, IsotropicFriction, Stribeck};
/// use nalgebra::Vector2;
/// let parts = Impedance { mass: 0.5, damping: 0.0, stiffness: 0.0 };
/// let law = Stribeck { coulomb: 1.0, breakaway: 1.0, stribeck_velocity: 0.01 };
/// let body = Body::new(parts, 0.1)?.starting(Vector2::zeros(), Vector2::new(0.06, 0.08));
/// let mut puck = IsotropicFriction::new(body, parts, law)?;
/// let sample = puck.advance(Vector2::zeros());
/// // It stops after m v / F = 50 ms and m v² / (2 F) = 2.5 mm, in the direction of its velocity.
/// assert!((sample.position - Vector2::new(1.5e-3, 2e-3)).norm() < 1e-15);
/// assert_eq!(sample.velocity, Vector2::zeros());
/// assert!((puck.heat() - 2.5e-3_f64).abs() < 1e-15);
/// # Ok::<(), ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct IsotropicFriction<T: Scalar, const N: usize> {
    body: Body<SVector<T, N>>,
    parts: Impedance<T>,
    law: Stribeck<T>,
    heat: Compensated<T>,
}

/// The share of a period within which a device that would stop has stopped: 2⁻⁴⁴.
const STOPPED: f64 = 5.684_341_886_080_802e-14;

/// The rounding of a force, as a share of its parts.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl<T: Scalar, const N: usize> IsotropicFriction<T, N> {
    /// Friction of `law` on `body`, which is made of `parts` from now on.
    ///
    /// # Errors
    /// `coulomb` or `static` below 0, infinite or NaN; `coulomb` above `static`; `stribeck_velocity` not above 0 and
    /// finite; `parts` that the body does not take.
    pub fn new(
        mut body: Body<SVector<T, N>>,
        parts: Impedance<T>,
        law: Stribeck<T>,
    ) -> Result<Self, ParameterError> {
        let law = law.checked()?;
        body.reshape(parts, body.start().period)?;
        Ok(Self { body, parts, law, heat: Compensated::zero() })
    }

    /// The body as it stands now.
    pub fn body(&self) -> &Body<SVector<T, N>> {
        &self.body
    }

    /// The energy that friction has dissipated so far, J.
    pub fn heat(&self) -> T {
        self.heat.value()
    }

    /// The motion of one lane over `interval` s.
    fn glide(&self, lane: usize, effort: SVector<T, N>, interval: f64) -> Glide<N> {
        let [rest, position, velocity] =
            [self.body.rest(), self.body.position(), self.body.velocity()];
        let of = |signal: SVector<T, N>| signal.map(|axis| axis.lane(lane));
        let Impedance { mass, damping, stiffness } = self.parts;
        let [mass, damping, stiffness] = [mass, damping, stiffness].map(|part| part.lane(lane));
        let system = Planar {
            parts: Impedance { mass, damping, stiffness },
            effort: of(effort),
            law: self.law.lane(lane),
        };
        let glide = Glide {
            deflection: of(position) - of(rest),
            velocity: of(velocity),
            gain: SVector::zeros(),
            heat: 0.0,
            remaining: interval,
        };
        glide.run(&system, interval).unwrap_or_else(|| self.roughly(lane, effort, &system, glide))
    }

    /// The same, roughly: with the friction of the start, held, if that takes energy, else standing still.
    fn roughly(
        &self,
        lane: usize,
        effort: SVector<T, N>,
        system: &Planar<N>,
        start: Glide<N>,
    ) -> Glide<N> {
        let speed = start.velocity.norm();
        let force = system.force(&start.deflection);
        let towards = if speed > 0.0 { start.velocity } else { force };
        let friction = towards.normalize() * system.law.at(speed);
        let mut total = effort;
        for axis in 0..N {
            set(&mut total[axis], lane, effort[axis].lane(lane) + friction[axis]);
        }
        let mut held = self.body;
        let sample = held.advance(total);
        let gain = sample.displacement.map(|axis| axis.lane(lane));
        let heat = friction.dot(&gain);
        if heat >= 0.0 {
            let velocity = sample.velocity.map(|axis| axis.lane(lane));
            return Glide { velocity, gain, heat, ..start };
        }
        let heat = 0.5 * system.parts.mass * speed * speed;
        Glide { velocity: SVector::zeros(), heat, ..start }
    }
}

/// Motion through one period, in one lane.
#[derive(Clone, Copy)]
struct Glide<const N: usize> {
    deflection: SVector<f64, N>,
    velocity: SVector<f64, N>,
    /// The total gain, without the rounding of adding it to a deflection.
    gain: SVector<f64, N>,
    /// The energy that friction dissipated, J.
    heat: f64,
    remaining: f64,
}

impl<const N: usize> Glide<N> {
    /// The motion through the remaining time of an `interval`; none if that has too many pieces.
    fn run(mut self, system: &Planar<N>, interval: f64) -> Option<Self> {
        for _ in 0..PIECES {
            if self.remaining <= 0.0 {
                return Some(self);
            }
            let force = system.force(&self.deflection);
            let speed = self.velocity.norm();
            if speed == 0.0 {
                if force.norm() <= system.law.breakaway {
                    return Some(self);
                }
                return self.straight(system, force.normalize());
            }
            let along = self.velocity / speed;
            let across = force - along * force.dot(&along);
            let parts = system.parts.stiffness * self.deflection.norm() + system.effort.norm();
            if across.norm() <= ROUNDING * parts {
                return self.straight(system, along);
            }
            let slowing = -system.acceleration(&self.deflection, &self.velocity).dot(&along);
            if slowing > 0.0 && speed / slowing <= STOPPED * interval {
                self.stop(system, speed, speed / slowing);
            } else {
                self.turn(system)?;
            }
        }
        None
    }

    /// Comes to rest after `time` s.
    fn stop(&mut self, system: &Planar<N>, speed: f64, time: f64) {
        let gain = self.velocity * (0.5 * time);
        self.deflection += gain;
        self.gain += gain;
        self.heat += 0.5 * system.parts.mass * speed * speed;
        self.velocity = SVector::zeros();
        self.remaining -= time.min(self.remaining);
    }

    /// Moves on by a step in which the direction turns.
    fn turn(&mut self, system: &Planar<N>) -> Option<()> {
        let turning = system.turn(&self.deflection, &self.velocity, self.remaining)?;
        let gain = turning.gain();
        self.deflection += gain;
        self.gain += gain;
        self.heat += turning.heat();
        self.velocity = turning.velocity(turning.share);
        self.remaining = match turning.share * turning.step {
            whole if whole >= self.remaining => 0.0,
            part => self.remaining - part,
        };
        Some(())
    }

    /// Moves to the end along a line, on which friction has a sign.
    fn straight(mut self, system: &Planar<N>, along: SVector<f64, N>) -> Option<Self> {
        let Impedance { mass, damping, stiffness } = system.parts;
        let line = System {
            rate: [[0.0, 1.0], [-stiffness / mass, -damping / mass]],
            mass,
            effort: system.effort.dot(&along),
            law: system.law,
        };
        let state = [self.deflection.dot(&along), self.velocity.dot(&along)];
        let trajectory = Trajectory::run(&line, state, self.remaining, true);
        if !trajectory.complete() {
            return None;
        }
        self.gain += along * trajectory.gain[0];
        self.velocity = along * trajectory.velocity(1);
        self.heat += trajectory.heat;
        self.remaining = 0.0;
        Some(self)
    }
}

impl<T: Scalar, const N: usize> Plant<SVector<T, N>> for IsotropicFriction<T, N> {
    fn start(&self) -> PortSample<SVector<T, N>> {
        self.body.start()
    }

    fn advance(&mut self, effort: SVector<T, N>) -> PortSample<SVector<T, N>> {
        let before = self.body.position();
        let mut moved = self.body;
        let sample = moved.advance(effort);
        let (mut position, mut velocity) = (sample.position, sample.velocity);
        let (mut displacement, mut heat) = (sample.displacement, T::zero());
        let parts = [before, self.body.velocity(), self.body.rest(), effort];
        for lane in 0..T::LANES {
            let finite = parts.iter().flatten().all(|axis| axis.lane(lane).is_finite());
            if !(finite && self.law.breakaway.lane(lane) > 0.0) {
                continue;
            }
            let glide = self.glide(lane, effort, sample.period.lane(lane));
            for axis in 0..N {
                let mut gain = T::zero();
                set(&mut gain, lane, glide.gain[axis]);
                let after = (before[axis] + gain).lane(lane);
                set(&mut position[axis], lane, after);
                set(&mut velocity[axis], lane, glide.velocity[axis]);
                set(&mut displacement[axis], lane, (position[axis] - before[axis]).lane(lane));
            }
            set(&mut heat, lane, glide.heat);
        }
        self.heat.add(heat);
        self.body = moved.starting(position, velocity);
        let period = sample.period;
        HeldTick { period, position, velocity, displacement, applied: effort }.sample()
    }
}

impl<T: Scalar, const N: usize> OperatedBody<SVector<T, N>> for IsotropicFriction<T, N> {
    type Parts = Impedance<T>;

    fn rest_at(&mut self, rest: SVector<T, N>) {
        self.body.rest_at(rest);
    }

    fn reshape(&mut self, parts: Impedance<T>, interval: T) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)?;
        self.parts = parts;
        Ok(())
    }
}
