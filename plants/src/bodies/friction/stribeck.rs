//! Stribeck friction law.

use lyapunov_core::{ParameterError, Requirement, Scalar};

/// Stribeck friction: `(coulomb + (static − coulomb) exp(−(v / stribeck_velocity)²)) sgn v` against the motion, and at
/// rest the force that holds the device, up to `static`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stribeck<T> {
    /// Friction at high speed, N: Coulomb friction.
    pub coulomb: T,
    /// Largest friction at rest, N: static friction, or break-away force. Named `static` in errors and scenes.
    pub breakaway: T,
    /// Speed over which friction falls from static to Coulomb friction, m/s.
    pub stribeck_velocity: T,
}

impl<T: Scalar> Stribeck<T> {
    pub(crate) fn checked(self) -> Result<Self, ParameterError> {
        let coulomb = Requirement::NonNegative.check("coulomb", self.coulomb)?;
        let breakaway = Requirement::NonNegative.check("static", self.breakaway)?;
        Requirement::Positive.check("stribeck velocity", self.stribeck_velocity)?;
        match (0..T::LANES).find(|&lane| coulomb.lane(lane) > breakaway.lane(lane)) {
            None => Ok(self),
            Some(lane) => Err(ParameterError {
                parameter: "coulomb",
                value: coulomb.lane(lane),
                requirement: Requirement::AtMost(breakaway.lane(lane)),
            }),
        }
    }

    /// The magnitude of the friction at `velocity`, N, lane by lane.
    pub(crate) fn force(self, velocity: T) -> T {
        T::from_lanes(|lane| self.lane(lane).at(velocity.lane(lane)))
    }

    /// The slope of the friction over the velocity, N·s/m.
    pub(crate) fn slope(self, velocity: T) -> T {
        let fallen = (self.force(velocity) - self.coulomb) / self.stribeck_velocity;
        fallen * T::of(-2.0) * (velocity / self.stribeck_velocity)
    }

    /// `number` of each part.
    #[inline(always)]
    pub(super) fn map<R>(self, number: impl Fn(T) -> R) -> Stribeck<R> {
        Stribeck {
            coulomb: number(self.coulomb),
            breakaway: number(self.breakaway),
            stribeck_velocity: number(self.stribeck_velocity),
        }
    }

    pub(super) fn lane(self, lane: usize) -> Stribeck<f64> {
        self.map(|part| part.lane(lane))
    }

    /// The lanes where friction at `speed` is as good as constant, and the speed, m/s, down to which it is so there.
    #[inline(always)]
    pub(super) fn constant_above(&self, speed: T) -> (T::Mask, T) {
        let falls = self.coulomb.below(self.breakaway);
        // Entering takes a little more speed than staying, so that a motion that has just left does not come back at
        // once.
        let fast = speed.above(T::of(FAST + 1.0) * self.stribeck_velocity) & falls;
        let floor = T::choose(fast, T::of(FAST) * self.stribeck_velocity, T::zero());
        (fast | !falls, floor)
    }
}

/// From this many Stribeck velocities on, friction counts as Coulomb's: the remaining difference is `exp(−64)` of the
/// full one.
const FAST: f64 = 8.0;

impl Stribeck<f64> {
    /// The magnitude of the friction at `speed`, N.
    pub(super) fn at(&self, speed: f64) -> f64 {
        let ratio = speed / self.stribeck_velocity;
        self.coulomb + (self.breakaway - self.coulomb) * libm::exp(-ratio * ratio)
    }
}
