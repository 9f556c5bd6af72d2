//! One mass in front of an elastic wall.

use lyapunov_core::{Mechanics, ParameterError, Requirement, Scalar, State};

use crate::{Impedance, ImplicitMechanics, LinearDynamics, Oscillator, Switching};

/// An [`Oscillator`] and a one-sided elastic wall: `m ẍ = −k x − b ẋ − f − max(0, k_w (x − surface))`.
///
/// The force is continuous and has a kink at the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalledOscillator<T> {
    free: Oscillator<T>,
    touching: Oscillator<T>,
    stiffness: T,
    surface: T,
}

/// An oscillator away from its wall, or in contact with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallPhase<T> {
    oscillator: Oscillator<T>,
    /// The force of the wall's spring at the origin, N.
    preload: T,
    /// 1 in contact, −1 away from it.
    side: T,
}

impl<T: Scalar> WalledOscillator<T> {
    /// The oscillator made of `parts` in front of a wall of `stiffness` N/m with its surface at `surface` m.
    ///
    /// # Errors
    /// Those of [`Oscillator::new`]; `stiffness` below 0, infinite or NaN; `surface` not finite.
    pub fn new(parts: Impedance<T>, stiffness: T, surface: T) -> Result<Self, ParameterError> {
        let stiffness = Requirement::NonNegative.check("wall stiffness", stiffness)?;
        let surface = Requirement::Finite.check("surface", surface)?;
        let free = Oscillator::new(parts)?;
        let joined = Impedance { stiffness: parts.stiffness + stiffness, ..parts };
        Requirement::InRange.require("wall stiffness", stiffness, joined.stiffness.finite())?;
        let touching = Oscillator::new(joined)?;
        Ok(Self { free, touching, stiffness, surface })
    }

    fn on_side(&self, contact: T::Mask) -> WallPhase<T> {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        WallPhase {
            oscillator: Oscillator::chosen(contact, self.touching, self.free),
            preload: T::choose(contact, -self.stiffness * self.surface, zero),
            side: T::choose(contact, one, -one),
        }
    }
}

impl<T: Scalar> Mechanics<T> for WalledOscillator<T> {
    type Coordinates = T;

    #[inline]
    fn acceleration(&self, position: T, velocity: T, effort: T) -> T {
        self.phase(State { position, velocity }, effort).acceleration(position, velocity, effort)
    }
}

impl<T: Scalar> Mechanics<T> for WallPhase<T> {
    type Coordinates = T;

    #[inline]
    fn acceleration(&self, position: T, velocity: T, effort: T) -> T {
        self.oscillator.acceleration(position, velocity, effort + self.preload)
    }
}

impl<T: Scalar> ImplicitMechanics<T> for WallPhase<T> {
    #[inline]
    fn implicit_acceleration(&self, position: T, velocity: T, effort: T, alpha: T, beta: T) -> T {
        let effort = effort + self.preload;
        self.oscillator.implicit_acceleration(position, velocity, effort, alpha, beta)
    }
}

impl<T: Scalar> LinearDynamics<T> for WallPhase<T> {
    /// The oscillator's increments, and the force of the wall's spring at the origin.
    type Increments = (<Oscillator<T> as LinearDynamics<T>>::Increments, T);

    fn increments(&self, interval: T) -> Self::Increments {
        (LinearDynamics::<T>::increments(&self.oscillator, interval), self.preload)
    }

    #[inline]
    fn gain((rows, preload): &Self::Increments, from: State<T>, effort: T) -> State<T> {
        <Oscillator<T> as LinearDynamics<T>>::gain(rows, from, effort + *preload)
    }
}

impl<T: Scalar> Switching<T> for WalledOscillator<T> {
    type Phase = WallPhase<T>;

    fn phase(&self, state: State<T>, _effort: T) -> WallPhase<T> {
        self.on_side(state.position.above(self.surface))
    }

    fn reserve(&self, phase: &WallPhase<T>, state: State<T>) -> T {
        (state.position - self.surface) * phase.side
    }

    fn switched(&self, phase: &WallPhase<T>, _: State<T>, _: T) -> (WallPhase<T>, State<T>) {
        let nothing = State { position: T::of(0.0), velocity: T::of(0.0) };
        (self.on_side(phase.side.below(T::of(0.0))), nothing)
    }

    fn chosen(mask: T::Mask, yes: WallPhase<T>, no: WallPhase<T>) -> WallPhase<T> {
        WallPhase {
            oscillator: Oscillator::chosen(mask, yes.oscillator, no.oscillator),
            preload: T::choose(mask, yes.preload, no.preload),
            side: T::choose(mask, yes.side, no.side),
        }
    }
}
