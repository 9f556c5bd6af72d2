//! Energy tanks.

mod energy_tank;
mod valve;

pub use energy_tank::EnergyTank;
pub use valve::{BoundedValve, OpenValve, Valve};

use lyapunov_core::{
    Accumulator, Correction, Held, LyapunovCandidate, Observer, ParameterError, Plain, PortSample,
    Requirement, Scalar, Signal, Snapshot, Stabilizer,
};

use crate::StabilizerExt;
use crate::account::account;
use crate::credit::limits_credit;
use crate::limiting::{limiting, payable};

/// Limits on the energy that a [`Tank`] or an [`EnergyTank`] may hold and hand out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TankLimits<T> {
    /// Energy in it at the start, J.
    pub start: T,
    /// Energy that is never handed out, J.
    pub floor: T,
    /// Largest energy that it holds, J; infinity: no limit.
    pub ceiling: T,
    /// Largest power that it hands out, W; infinity: no limit.
    pub power: T,
}

impl<T: Scalar> TankLimits<T> {
    /// The same limits, checked; `held` is the name of the energy that `start` stands for.
    fn checked(self, held: &'static str) -> Result<Self, ParameterError> {
        let Self { start, floor, ceiling, power } = self;
        Requirement::NonNegative.check("tank floor", floor)?;
        Requirement::Limit.check("tank ceiling", ceiling)?;
        for lane in 0..T::LANES {
            let energy = start.lane(lane);
            Requirement::AtLeast(floor.lane(lane)).check(held, energy)?;
            Requirement::AtMost(ceiling.lane(lane)).check(held, energy)?;
        }
        Requirement::Limit.check("tank power", power)?;
        Ok(self)
    }
}

/// A stabilizer with an energy tank: the port absorbs into it, and gives only what is in it.
///
/// ```text
/// E(n) = min(E(n−1) − ΔV(n), ceiling),   P = −f · v,   F = f min(1, min(power, (E(n) − floor) / T) / P) where P > 0
/// ```
///
/// `E` in J and not its square root: the published state `√(2 E)` has no derivative at 0, and in explicit steps it
/// creates energy ([`EnergyTank`]). Efforts that absorb pass unchanged. The observed energy is `E − floor`, and the
/// reported damping is 0.
///
/// **Guarantee**: the port gives at most what it took and was credited and what was in the tank at the start,
/// `start − floor`, on one axis in computed numbers too, as what is there is rounded down by 4 ε; the tank holds no more
/// than its ceiling. **Assumed** is that the effort acts as given and that the
/// next displacement is between 0 and `v T`, on several axes a part of `v T`. Where the device moves farther or turns
/// round, the account may fall below the floor: at `v` = 0.1 m/s an effort of 1 kN absorbs and passes unchanged, and a
/// next displacement of −0.05 mm takes out 0.05 J, however little is in the tank. That much is reported as shortfall,
/// and nothing is given until it is made up; the tank does not brake. A ceiling keeps a long dissipation from paying
/// for anything; a power limit keeps what is stored from coming at once.
///
/// Tanks are as in Ferraguti and others (IEEE Transactions on Robotics 31(5), 2015), where the port's dissipation fills
/// them; here it is the port's whole work, and the bounded valve is derived. Califano, Rashad, Secchi and Stramigioli
/// (arXiv 2211.17033, 2022) discuss what tanks guarantee and what not.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{TankLimits, Tank};
/// let store = TankLimits { start: 2e-4, floor: 1e-4, ceiling: 1e-3, power: f64::INFINITY };
/// let mut tank = Tank::new(PortEnergy, store)?;
/// let outwards = HeldTick { period: 1e-3, position: 0.0, velocity: -0.1, displacement: 0.0, applied: 0.0 }.sample();
/// let effort: f64 = tank.stabilize(&outwards, 4.0).effort; // 0.4 W asked, 0.1 mJ over 1 ms to give
/// assert_abs_diff_eq!(effort, 1.0, epsilon = 1e-12);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Tank<T, C, A = Plain<T>> {
    observer: Observer<C, Held, A>,
    room: T,
    power: T,
}

impl<T: Scalar, C> Tank<T, C> {
    /// A tank that fills by what `candidate` loses.
    ///
    /// # Errors
    /// `floor` below 0 or not finite; `start` below `floor` or not finite; `ceiling` below `start`; `power` below 0.
    pub fn new(candidate: C, store: TankLimits<T>) -> Result<Self, ParameterError> {
        let TankLimits { start, floor, ceiling, power } = store.checked("tank start")?;
        let held = start - floor;
        let mut observer: Observer<C, Held, Plain<T>> = Observer::of(candidate);
        observer.ledger.credit(held);
        Ok(Self { observer, room: ceiling - floor, power })
    }
}

impl<T: Scalar, C, A: Accumulator<T>> Tank<T, C, A> {
    /// The same tank with its energies summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> Tank<T, C, B> {
        let Self { observer, room, power } = self;
        Tank { observer: observer.summed_in(), room, power }
    }
}

impl<T, C, A> StabilizerExt for Tank<T, C, A> {}

limits_credit!(impl[T: Scalar, C, A: Accumulator<T>] Tank<T, C, A>, in T, of observer.ledger);

impl<V, C, A> Stabilizer<V> for Tank<V::Scalar, C, A>
where
    V: Signal,
    C: LyapunovCandidate<V>,
    A: Accumulator<V::Scalar>,
{
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        let decrease = self.observer.decrease(sample, effort);
        let booked = self.observer.ledger.credit(decrease);
        let sum = self.observer.ledger.energy().smaller(self.room);
        self.observer.ledger.limit_credit(self.room);
        let most = (payable(sum) / sample.period).smaller(self.power);
        let given = -effort.inner(sample.velocity);
        let factor = V::Scalar::choose(given.above(most), most / given, one);
        let timed = sample.period.above(zero);
        let sound = (given + sample.period + sample.work.sum()).finite() & effort.finite();
        let accepted = booked & sound & timed;
        limiting(effort.scale(factor), sum, accepted)
    }
}

account!(impl[T: Scalar, C, A: Accumulator<T>] Tank<T, C, A>, in T, is observer.ledger);

impl<T: Scalar, C, A> Tank<T, C, A> {
    /// The most that it holds above its floor, J: `ceiling − floor`.
    pub fn room(&self) -> T {
        self.room
    }

    /// Changes the most that it holds above its floor, J; what is above it is forfeited on the next tick.
    ///
    /// The account is counted from the floor: a floor that rises by `E` is [`owe(E)`](crate::Account::owe) and less room.
    ///
    /// ```
    /// use lyapunov_core::PortEnergy;
    /// use lyapunov_stabilizers::{Tank, TankLimits};
    /// let store = TankLimits { start: 2e-4, floor: 1e-4, ceiling: 1e-3, power: f64::INFINITY };
    /// let mut tank = Tank::new(PortEnergy, store)?;
    /// tank.set_room(5e-4)?;
    /// tank.set_power(2.0)?; // W
    /// assert!(tank.set_power(-1.0).is_err() && tank.power() == 2.0);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// `room` below 0 or NaN; the old one stays.
    pub fn set_room(&mut self, room: T) -> Result<(), ParameterError> {
        self.room = Requirement::Limit.check("tank ceiling above its floor", room)?;
        Ok(())
    }

    /// Largest power that it hands out, W.
    pub fn power(&self) -> T {
        self.power
    }

    /// Changes the largest power, W; the account stays.
    ///
    /// # Errors
    /// `power` below 0 or NaN; the old one stays.
    pub fn set_power(&mut self, power: T) -> Result<(), ParameterError> {
        self.power = Requirement::Limit.check("tank power", power)?;
        Ok(())
    }

    /// The candidate.
    pub fn candidate(&self) -> &C {
        &self.observer.candidate
    }

    /// The candidate, to be changed between ticks, as [`Lolc::candidate_mut`](crate::Lolc::candidate_mut).
    pub fn candidate_mut(&mut self) -> &mut C {
        &mut self.observer.candidate
    }
}

lyapunov_core::snapshot! {
    impl[T: Scalar, C: Snapshot, A: Snapshot] Tank<T, C, A>, is observer, of (C::State, A::State)
}
