//! An energy tank with a port.

use lyapunov_core::{Accumulator, ParameterError, Plain, Scalar, Signal, Snapshot};

use super::{BoundedValve, OpenValve, TankLimits, Valve};

/// The tank of Ferraguti and others (IEEE Transactions on Robotics 31(5), 2015), with its state in joules: it is filled
/// by what is dissipated elsewhere, and what a wished input `w` extracts at the flow `y` is drawn from it.
///
/// ```text
/// published, in continuous time   E = x² / 2,   ẋ = σ D / x + u_t,   u = w,   u_t = −w · y / x,   σ = 1 where E ≤ ceiling
/// here, each period               E += T (σ D − u · y),   u = what the valve lets through of w
/// ```
///
/// `x u_t = −u · y` is the power of the tank's port, whatever `x` is, so that the root is not needed: explicit steps of
/// `x` create `(T P / x)² / 2` a tick, and at 0 it has no derivative.
///
/// **Guarantee**: what is stored elsewhere and `E` together are passive. With the [`BoundedValve`]
/// `floor ≤ E ≤ ceiling` always, if `y` is the mean flow of the period; the [`OpenValve`] is the published one, which
/// may overdraw and overfill by a tick. **Assumed** is that `D ≥ 0` was really dissipated. What is smaller than the rounding of a
/// full tank is not drawn from it: long runs in `f32` need a sum that keeps it ([`summed_in`](Self::summed_in)).
///
/// Published sizes: `ceiling = 10 J, floor = 0.1 J`.
///
/// ```
/// use lyapunov_stabilizers::{EnergyTank, TankLimits};
/// let store = TankLimits { start: 2e-4, floor: 1e-4, ceiling: 1e-3, power: f64::INFINITY };
/// let mut tank = EnergyTank::new(store)?;
/// let given: f64 = tank.pass(1e-3, 0.0, 4.0, 0.1); // 0.4 W wished, 0.1 mJ over 1 ms to give
/// assert!((given - 1.0).abs() < 1e-12 && tank.energy() >= 1e-4);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct EnergyTank<T, L = BoundedValve, A = Plain<T>> {
    store: TankLimits<T>,
    valve: L,
    energy: A,
}

impl<T: Scalar> EnergyTank<T> {
    /// A tank with a bounded valve.
    ///
    /// # Errors
    /// As [`Tank::new`](super::Tank::new).
    pub fn new(store: TankLimits<T>) -> Result<Self, ParameterError> {
        let store = store.checked("tank start")?;
        Ok(Self { energy: Plain::holding(store.start), store, valve: BoundedValve })
    }
}

impl<T: Scalar, A> EnergyTank<T, BoundedValve, A> {
    /// The same tank with the published valve; it has no limit of power.
    #[must_use]
    pub fn opening(self) -> EnergyTank<T, OpenValve, A> {
        EnergyTank { store: self.store, valve: OpenValve, energy: self.energy }
    }
}

impl<T: Scalar, L: Valve<T>, A: Accumulator<T>> EnergyTank<T, L, A> {
    /// The same tank with its energy summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> EnergyTank<T, L, B> {
        let Self { store, valve, energy } = self;
        EnergyTank { store, valve, energy: B::holding(energy.value()) }
    }

    /// Energy in it, J.
    #[inline]
    pub fn energy(&self) -> T {
        self.energy.value()
    }

    /// Part of the `wished` input that passes over `period` s at the `flow` it acts on (`wished · flow > 0` extracts),
    /// while `dissipated` W flow in; less than 0 counts as 0, for a tank is not drained by it. What is not finite
    /// passes nothing and leaves the tank as it is, and so does a period that is not above 0.
    #[inline]
    pub fn pass<V: Signal<Scalar = T>>(
        &mut self,
        period: T,
        dissipated: T,
        wished: V,
        flow: V,
    ) -> V {
        let (asked, held) = (wished.inner(flow), self.energy.value());
        let share = self.valve.share(&self.store, held, asked, period);
        let gained = dissipated.larger(T::of(0.0)) * period;
        let mut energy = self.energy;
        // What is drawn goes first: what comes in on this tick does not pay for it.
        energy.add(-(share * asked * period));
        let left = energy.value();
        energy.add(self.valve.gain(&self.store, held, gained));
        energy.lower(self.valve.most(&self.store));
        let sound = (left + energy.value() + share + dissipated + period).finite()
            & wished.finite()
            & period.above(T::of(0.0));
        self.energy = A::choose(sound, energy, self.energy);
        V::choose(sound, wished.scale(share), V::zero())
    }
}

impl<T: Scalar, L, A: Accumulator<T>> EnergyTank<T, L, A> {
    /// The limits; `start` is the energy that it held when they were set.
    pub fn limits(&self) -> TankLimits<T> {
        self.store
    }

    /// Changes floor, ceiling and power between ticks, around the energy in it, which stays; `start` is not read.
    ///
    /// ```
    /// use lyapunov_stabilizers::{EnergyTank, TankLimits};
    /// let store = TankLimits { start: 2.0, floor: 1.0, ceiling: 10.0, power: f64::INFINITY };
    /// let mut tank = EnergyTank::new(store)?;
    /// tank.set_limits(TankLimits { ceiling: 5.0, ..store })?;
    /// assert!(tank.set_limits(TankLimits { floor: 3.0, ..store }).is_err()); // there are 2 J in it
    /// assert_eq!((tank.limits().ceiling, tank.energy()), (5.0, 2.0));
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// A floor above the energy in it or below 0, a ceiling below that energy, a power below 0; the old ones stay.
    pub fn set_limits(&mut self, limits: TankLimits<T>) -> Result<(), ParameterError> {
        let start = self.energy.value();
        self.store = TankLimits { start, ..limits }.checked("energy in the tank")?;
        Ok(())
    }
}

impl<T: Scalar, L: Valve<T>, A: Accumulator<T> + Snapshot> Snapshot for EnergyTank<T, L, A> {
    /// The energy in it, J. With the bounded valve what is stored above the ceiling is forfeited, as what would overflow is.
    type State = A::State;

    fn state(&self) -> A::State {
        self.energy.state()
    }

    fn restored(self, state: A::State) -> Result<Self, ParameterError> {
        let mut energy = self.energy.restored(state)?;
        energy.lower(self.valve.most(&self.store));
        Ok(Self { energy, ..self })
    }
}
