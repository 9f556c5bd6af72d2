//! Rigid body in space.

use lyapunov_core::{
    Angle, Axes, BodyAxes, HeldTick, ParameterError, Plant, PortSample, Pose, PoseTrack,
    Requirement, Screw, Signal, WithPose, WorldAxes,
};
use nalgebra::Vector3;

/// Mass, inertia and dampers of a [`RigidBody`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidParts<T> {
    /// Mass, kg.
    pub mass: T,
    /// Principal moments of inertia about the body's axes through its centre of mass, kg·m².
    pub moments: Vector3<T>,
    /// Viscous damping of translation, N·s/m.
    pub damping: T,
    /// Viscous damping of rotation, N·m·s/rad.
    pub rotational_damping: T,
}

/// A rigid body that moves freely under a wrench: the handle of a six-axis device, a tool.
///
/// ```text
/// m v̇ + b v = −f        I ω̇ + ω × I ω + c ω = −τ        ṗ = v,  Ṙ = R [ω]
/// ```
///
/// The reference point is the centre of mass, and the body's axes are its principal ones. The wrench is held along the
/// axes `F`. Each step is the implicit midpoint rule, with `ωₘ` and `vₘ` the means of both ends and the rotation
/// `exp(h ωₘ)`:
///
/// ```text
/// m (v₁ − v₀) / h = −f − b vₘ                          p₁ = p₀ + h vₘ
/// I (ω₁ − ω₀) / h = I ωₘ × ωₘ − τ − c ωₘ               R₁ = R₀ exp(h ωₘ)
/// ```
///
/// Energy and momentum of rotation are quadratic, and this rule keeps what is quadratic (Hairer, Lubich and Wanner,
/// Geometric Numerical Integration, 2006, IV.2): a free body keeps its energy to rounding, however it tumbles, as long
/// as a step turns it by less than three radians; in `f32` rounding makes some per cent in a million slow ticks. A held
/// torque does the work `τ · h ωₘ`, the displacement of the step, so the books of the port balance too. The motion
/// itself is of order 2. Six iterations of Newton's method solve for `ωₘ`; they suffice while a step turns the body by
/// less than about half a radian.
///
/// ```
/// use approx::assert_relative_eq;
/// use lyapunov_core::{Plant, Pose, Screw, WithPose, WorldAxes};
/// use lyapunov_plants::{RigidBody, RigidParts};
/// use nalgebra::Vector3;
/// let moments = Vector3::new(1e-3, 2e-3, 3e-3);
/// let parts = RigidParts { mass: 0.5, moments, damping: 0.0, rotational_damping: 0.0 };
/// let spin = Screw::new(Vector3::zeros(), Vector3::new(0.01, 20.0, 0.0)); // about the middle axis: it tumbles
/// let mut body = RigidBody::<f64, WorldAxes>::new(parts, 1e-3, 1)?.starting(Pose::at(Vector3::zeros()), spin);
/// let energy = body.kinetic();
/// for _ in 0..10_000 {
///     body.advance(WithPose::default());
/// }
/// assert_relative_eq!(body.kinetic(), energy, max_relative = 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RigidBody<T, F = WorldAxes> {
    parts: RigidParts<T>,
    period: T,
    interval: T,
    steps: u32,
    pose: Pose<T>,
    /// Along the world's axes, m/s.
    velocity: Vector3<T>,
    /// Along the body's axes, rad/s.
    rate: Vector3<T>,
    track: PoseTrack<T, F>,
}

impl<T: Angle, F: Axes> RigidBody<T, F> {
    /// A body at rest at the origin, moved by `period` s at a time in `steps` steps.
    ///
    /// # Errors
    /// A mass or moment not above 0 and finite; moments whose product leaves the range of the scalar within a step; a damping
    /// below 0, infinite or NaN; `period` not above 0 and finite; `steps` 0.
    pub fn new(parts: RigidParts<T>, period: T, steps: u32) -> Result<Self, ParameterError> {
        Requirement::Positive.check("mass", parts.mass)?;
        for moment in parts.moments.data.0[0] {
            Requirement::Positive.check("moment of inertia", moment)?;
        }
        Requirement::NonNegative.check("damping", parts.damping)?;
        Requirement::NonNegative.check("rotational damping", parts.rotational_damping)?;
        let period = Requirement::Positive.check("period", period)?;
        Requirement::AtLeast(1.0).check("steps", f64::from(steps))?;
        let interval = period / T::of(f64::from(steps));
        // Newton's step divides by such a product.
        let twice = parts.moments * (T::of(2.0) / interval);
        let volume = twice.x * twice.y * twice.z;
        let kept = volume.finite() & !volume.below(T::smallest_normal());
        let [x, y, z] = parts.moments.data.0[0];
        let (least, largest) = (x.smaller(y).smaller(z), x.larger(y).larger(z));
        let worst = T::choose(volume.finite(), least, largest);
        Requirement::InRange.require("moment of inertia", worst, kept)?;
        let (pose, still) = (Pose::at(Vector3::zeros()), Vector3::zeros());
        let track = PoseTrack::from(pose);
        Ok(Self { parts, period, interval, steps, pose, velocity: still, rate: still, track })
    }

    /// The same body in `pose`, moving with `twist`.
    #[must_use]
    pub fn starting(self, pose: Pose<T>, twist: Screw<T, F>) -> Self {
        let velocity = F::to_world(&pose, twist.translation);
        let rate = pose.to_body(F::to_world(&pose, twist.rotation));
        Self { pose, velocity, rate, track: PoseTrack::from(pose), ..self }
    }

    /// The pose.
    #[inline]
    pub fn pose(&self) -> &Pose<T> {
        &self.pose
    }

    /// The twist.
    #[inline]
    pub fn twist(&self) -> Screw<T, F> {
        let turned = |vector| F::from_world(&self.pose, vector);
        Screw::new(turned(self.velocity), turned(self.pose.to_world(self.rate)))
    }

    /// The kinetic energy, `½ m v² + ½ ω·I ω`, J.
    pub fn kinetic(&self) -> T {
        let moved = self.velocity.inner(self.velocity) * self.parts.mass;
        let turning = self.rate.inner(self.momentum(self.rate));
        T::of(0.5) * (moved + turning)
    }

    #[inline]
    fn momentum(&self, rate: Vector3<T>) -> Vector3<T> {
        self.parts.moments.times(rate)
    }

    /// Moves the body a step on; its way, m, and its turn along its own axes, rad.
    fn step(&mut self, wrench: Screw<T, F>) -> (Vector3<T>, Vector3<T>) {
        let (one, two) = (T::of(1.0), T::of(2.0));
        let half = self.interval / two;
        let RigidParts { mass, damping, .. } = self.parts;
        let (mut mean, mut middle) = (self.rate, self.pose);
        for _ in 0..6 {
            middle = self.turned(mean * half);
            let torque = middle.to_body(F::to_world(&middle, wrench.rotation));
            mean -= self.correction(mean, torque);
        }
        let force = F::to_world(&middle, wrench.translation);
        let slowing = one / (one + half * damping / mass);
        let slowed = (self.velocity - force * (half / mass)) * slowing;
        let (way, turn) = (slowed * self.interval, mean * self.interval);
        self.pose = self.turned(turn);
        self.pose.position += way;
        self.velocity = slowed * two - self.velocity;
        self.rate = mean * two - self.rate;
        (way, turn)
    }

    /// The present pose, turned by `rotation` along the body's axes.
    fn turned(&self, rotation: Vector3<T>) -> Pose<T> {
        Screw::<T, BodyAxes>::new(Vector3::zeros(), rotation).moving(&self.pose)
    }

    /// Newton's step for the mean angular velocity under a `torque` along the body's axes.
    fn correction(&self, mean: Vector3<T>, torque: Vector3<T>) -> Vector3<T> {
        let RigidParts { moments, rotational_damping, .. } = self.parts;
        let twice = T::of(2.0) / self.interval;
        let momentum = self.momentum(mean);
        let lacking = self.momentum(mean - self.rate) * twice
            + mean.cross(&momentum)
            + torque
            + mean * rotational_damping;
        let columns: [Vector3<T>; 3] = core::array::from_fn(|axis| {
            let unit = Vector3::from_fn(|row, _| T::of(if row == axis { 1.0 } else { 0.0 }));
            mean.cross(&unit) * moments[axis]
                + unit.cross(&momentum)
                + unit * (moments[axis] * twice + rotational_damping)
        });
        let [a, b, c] = columns;
        let (bc, ca, ab) = (b.cross(&c), c.cross(&a), a.cross(&b));
        let volume = a.dot(&bc);
        Vector3::new(lacking.dot(&bc), lacking.dot(&ca), lacking.dot(&ab)).map(|part| part / volume)
    }
}

impl<T: Angle, F: Axes> Plant<WithPose<T, F>> for RigidBody<T, F> {
    fn start(&self) -> PortSample<WithPose<T, F>> {
        let position = { self.track }.tell(&self.pose);
        PortSample::starting(self.period, position, WithPose::of(self.twist()))
    }

    fn advance(&mut self, effort: WithPose<T, F>) -> PortSample<WithPose<T, F>> {
        let (before, from) = (self.track.tell(&self.pose), self.pose);
        // Apart: each of many short steps would be rounded to the size of the pose.
        let (mut way, mut turn) = (Vector3::zeros(), Pose::at(Vector3::zeros()));
        for _ in 0..self.steps {
            let (moved, turned) = self.step(effort.screw);
            way += moved;
            turn = Screw::<T, BodyAxes>::new(Vector3::zeros(), turned).moving(&turn);
        }
        self.pose = from.then(&turn);
        self.pose.position += way;
        let position = self.track.tell(&self.pose);
        let screw = Screw::between(&from, &self.pose);
        let displacement = WithPose { screw, pose: position.pose - before.pose };
        let velocity = WithPose::of(self.twist());
        HeldTick { period: self.period, position, velocity, displacement, applied: effort }.sample()
    }
}
