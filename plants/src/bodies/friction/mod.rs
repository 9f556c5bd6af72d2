//! Dry friction on the device, with true sticking.

mod exponential;
mod isotropic;
mod passage;
mod root;
mod series;
mod stribeck;
mod trajectory;
mod transition;
mod turning;

use lyapunov_core::{
    Accumulator, Compensated, HeldTick, Mask, ParameterError, Plant, PortSample, Scalar,
};

use crate::{Linear, OperatedBody};
pub use isotropic::IsotropicFriction;
use passage::Passage;
use series::System;
pub use stribeck::Stribeck;
use transition::set;
pub use transition::{Transition, Transitions};

/// A linear body with [`Stribeck`] friction on its device: `m v̇ = f − F(|v|) sgn v` while it slides, with `f` all
/// other forces on the device, and `v = 0` exactly while it sticks.
///
/// The device sticks where it comes to rest with `|f| ≤ static`, and slips at the first instant at which `|f|` exceeds
/// it. Within a period each piece of sliding or sticking is a polynomial (Taylor's method, order 24, to rounding), and
/// the instant at which it ends is a root of that polynomial, isolated with certainty and polished to the last digit.
/// No band of velocities counts as rest (Karnopp 1985), and the position of a device that sticks does not change by a
/// bit.
///
/// Friction acts on one axis; on several it is [`IsotropicFriction`]. It is computed in `f64` and rounded at the end of
/// the period; lanes share the work between events, and each has its own. A step does not take constant time. With
/// `static` 0 the body moves as it does without friction, bit for bit.
///
/// A period may have 1024 pieces, about one for every radian that the fastest mode turns and one for each event.
/// A period that needs more, or leaves the range of `f64` on the way, is moved over roughly: with the friction that
/// applied at its start, held, if that takes energy from the device; if not, everything stands still for the period and
/// the device is at rest after it. [`Transition::Cut`] reports it. Friction never adds energy, but for rounding: the
/// stretch of a link comes back as a difference of positions, of which `f32` far from 0 leaves few digits.
///
/// ```
/// use approx::abs_diff_eq;
/// use lyapunov_core::{ParameterError, Plant};
/// use lyapunov_plants::{Body, Friction, Impedance, Stribeck, Transition};
/// let parts = Impedance { mass: 0.5, damping: 0.0, stiffness: 0.0 };
/// let law = Stribeck { coulomb: 1.0, breakaway: 1.0, stribeck_velocity: 0.01 };
/// let body = Body::new(parts, 0.1)?.starting(0.0_f64, 0.1);
/// let mut plant = Friction::new(body, parts, law)?;
/// let sample = plant.advance(0.0);
/// // It stops after m v / F = 50 ms and m v² / (2 F) = 2.5 mm.
/// assert!(abs_diff_eq!(sample.position, 2.5e-3, epsilon = 1e-16) && sample.velocity == 0.0);
/// let (instant, transition) = plant.transitions().last(0).next().expect("one");
/// assert!(abs_diff_eq!(instant, 0.05, epsilon = 1e-15) && transition == Transition::Stick);
/// # Ok::<(), ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Friction<B: OperatedBody<T>, T: Scalar, const S: usize> {
    body: B,
    parts: B::Parts,
    law: Stribeck<T>,
    heat: Compensated<T>,
    transitions: Transitions<T>,
}

impl<T: Scalar, B: Linear<T, S>, const S: usize> Friction<B, T, S> {
    /// Friction of `law` on the device of `body`, which is made of `parts` from now on.
    ///
    /// # Errors
    /// `coulomb` or `static` below 0, infinite or NaN; `coulomb` above `static`; `stribeck_velocity` not above 0 and
    /// finite; `parts` that the body does not take.
    pub fn new(mut body: B, parts: B::Parts, law: Stribeck<T>) -> Result<Self, ParameterError> {
        let law = law.checked()?;
        body.reshape(parts, body.start().period)?;
        let (heat, transitions) = (Compensated::zero(), Transitions::none());
        Ok(Self { body, parts, law, heat, transitions })
    }

    /// The body as it stands now.
    pub fn body(&self) -> &B {
        &self.body
    }

    /// The energy that friction has dissipated so far, J.
    pub fn heat(&self) -> T {
        self.heat.value()
    }

    /// The transitions of the last period.
    pub fn transitions(&self) -> &Transitions<T> {
        &self.transitions
    }

    /// The motion of the lanes `of`.
    #[inline(always)]
    fn passage(&self, effort: T, interval: T, of: T::Mask) -> Passage<T, S> {
        if T::epsilon().real(0).lane(0) == f64::EPSILON {
            let (system, state) = (self.system(effort, |it| it), self.deflected(|it| it));
            return Passage::of(&system, state, interval, of);
        }
        let mut all = Passage::none();
        for lane in (0..T::LANES).filter(|&lane| of.lane(lane)) {
            let number = |number: T| number.lane(lane);
            let (system, state) = (self.system(effort, number), self.deflected(number));
            all.set(lane, &Passage::of(&system, state, number(interval), true));
        }
        all
    }

    #[inline(always)]
    fn system<R: Scalar>(&self, effort: T, number: impl Fn(T) -> R + Copy) -> System<R, S> {
        let rate = B::rate(&self.parts, number);
        System {
            rate: rate.transpose().data.0,
            mass: number(B::device_mass(&self.parts)),
            effort: number(effort),
            law: self.law.map(number),
        }
    }

    /// Deflections and velocities.
    #[inline(always)]
    fn deflected<R: Scalar>(&self, number: impl Fn(T) -> R) -> [R; S] {
        let (state, rest) = (self.body.state(), number(self.body.rest()));
        let mut deflected = [rest; S];
        for (index, value) in deflected.iter_mut().enumerate() {
            let at = number(state[index]);
            *value = if index % 2 == 0 { at - rest } else { at };
        }
        deflected
    }

    /// Moves one lane roughly, for a period with too many pieces: writes its end to `after` and returns the energy that
    /// friction dissipates.
    fn roughly(&self, lane: usize, effort: T, after: &mut [T; S]) -> f64 {
        let number = |number: T| number.lane(lane);
        let (system, state) = (self.system(effort, number), self.deflected(number));
        let (before, velocity) = (self.body.state(), state[S - 1]);
        let towards = if velocity == 0.0 { system.force(&state) } else { velocity };
        let friction = system.law.at(velocity.abs()).copysign(towards);
        let mut total = effort;
        set(&mut total, lane, effort.lane(lane) + friction);
        let mut held = self.body;
        held.advance(total);
        let held = held.state();
        let heat = friction * (held[S - 2].lane(lane) - before[S - 2].lane(lane));
        for (index, after) in after.iter_mut().enumerate() {
            let kept = if index == S - 1 { 0.0 } else { before[index].lane(lane) };
            set(after, lane, if heat < 0.0 { kept } else { held[index].lane(lane) });
        }
        if heat < 0.0 { 0.5 * system.mass * velocity * velocity } else { heat }
    }
}

impl<T: Scalar, B: Linear<T, S>, const S: usize> Plant<T> for Friction<B, T, S> {
    fn start(&self) -> PortSample<T> {
        self.body.start()
    }

    #[inline(always)]
    fn advance(&mut self, effort: T) -> PortSample<T> {
        let before = self.body.state();
        let mut moved = self.body;
        let sample = moved.advance(effort);
        let mut after = moved.state();
        let around = effort.finite() & self.body.rest().finite();
        let finite = before.iter().fold(around, |all, part| all & part.finite());
        let rubbed = finite & self.law.breakaway.above(T::zero());
        let passage = self.passage(effort, sample.period, rubbed);
        let through = rubbed & passage.is_complete();
        for (index, after) in after.iter_mut().enumerate() {
            let gone = before[index] + passage.gain[index];
            let passed = if index % 2 == 0 { gone } else { passage.velocity[index] };
            *after = T::choose(through, passed, *after);
        }
        let mut heat = T::choose(through, passage.heat, T::zero());
        let cut = rubbed & !through;
        if cut.any() {
            for lane in (0..T::LANES).filter(|&lane| cut.lane(lane)) {
                let burnt = self.roughly(lane, effort, &mut after);
                set(&mut heat, lane, burnt);
            }
        }
        self.transitions = passage.log;
        self.heat.add(heat);
        // A body may store its state in other numbers than it reports: a lane without friction is left alone.
        moved.place(rubbed, after);
        self.body = moved;
        let displacement = T::choose(rubbed, after[S - 2] - before[S - 2], sample.displacement);
        HeldTick {
            period: sample.period,
            position: after[S - 2],
            velocity: after[S - 1],
            displacement,
            applied: effort,
        }
        .sample()
    }
}

impl<T: Scalar, B: Linear<T, S>, const S: usize> OperatedBody<T> for Friction<B, T, S> {
    type Parts = B::Parts;

    #[inline(always)]
    fn rest_at(&mut self, rest: T) {
        self.body.rest_at(rest);
    }

    #[inline(always)]
    fn reshape(&mut self, parts: B::Parts, interval: T) -> Result<(), ParameterError> {
        self.body.reshape(parts, interval)?;
        self.parts = parts;
        Ok(())
    }
}
