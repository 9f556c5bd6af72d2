//! An energy tank.

use lyapunov_core::{
    Accumulator, Correction, Held, LyapunovCandidate, Observer, ParameterError, Plain, PortSample,
    Requirement, Scalar, Signal, Stabilizer,
};

use crate::{LimitCredit, StabilizerExt};

/// Limits of a [`Tank`]: the energies that it may hold and hand out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TankLimits<T> {
    /// Energy at the start, J.
    pub start: T,
    /// Energy that is never handed out, J.
    pub floor: T,
    /// Largest energy held, J; infinity: no limit.
    pub ceiling: T,
    /// Largest power handed out, W; infinity: no limit.
    pub power: T,
}

/// An energy tank: the port absorbs into it, and gives only what is in it.
///
/// `E(n) = min(E(n−1), ceiling) − ΔV(n)`, and the effort is made smaller by one factor so that the power it is about to
/// give, `P = −f · v`, is at most `min(power, (E(n) − floor) / T)`. Efforts that absorb pass unchanged. The account is in
/// joules and not in the square root of the energy, which has no derivative at 0.
///
/// The tank is as empty as its knowledge of the next period is wrong: it takes the velocity as it is now, and where the
/// motion is faster the account may fall below the floor. That much is told as shortfall, and nothing is given until it is
/// made up; the tank does not brake. A ceiling keeps a long dissipation from paying for anything; a power limit keeps
/// what is stored from coming at once. Califano, Rashad, Secchi and Stramigioli (arXiv 2211.17033, 2022) discuss what
/// tanks guarantee and what not. `sum` tells `E − floor`, and the damping told is 0.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{PortSample, PortEnergy, Stabilizer};
/// use lyapunov_stabilizers::{TankLimits, Tank};
/// let store = TankLimits { start: 2e-4, floor: 1e-4, ceiling: 1e-3, power: f64::INFINITY };
/// let mut tank = Tank::new(PortEnergy, store)?;
/// let outwards = PortSample::new(1e-3, 0.0, -0.1, 0.0, 0.0);
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
    /// A tank that fills by the decrease of `candidate`.
    ///
    /// # Errors
    /// `floor` below 0 or not finite; `start` below `floor` or not finite; `ceiling` below `start`; `power` below 0.
    pub fn new(candidate: C, store: TankLimits<T>) -> Result<Self, ParameterError> {
        let TankLimits { start, floor, ceiling, power } = store;
        let floor = Requirement::NonNegative.check("tank floor", floor)?;
        let held = Requirement::NonNegative.check("tank start above its floor", start - floor)?;
        Requirement::Limit.check("tank ceiling above its start", ceiling - start)?;
        let power = Requirement::Limit.check("tank power", power)?;
        let mut observer: Observer<C, Held, Plain<T>> = Observer::of(candidate);
        observer.ledger.credit(held);
        Ok(Self { observer, room: ceiling - floor, power })
    }
}

impl<T, C, A> StabilizerExt for Tank<T, C, A> {}

impl<T: Scalar, C, A: Accumulator<T>> LimitCredit<T> for Tank<T, C, A> {
    #[inline]
    fn limit_credit(&mut self, most: T) {
        self.observer.ledger.limit_credit(most);
    }
}

impl<V, C, A> Stabilizer<V> for Tank<V::Scalar, C, A>
where
    V: Signal,
    C: LyapunovCandidate<V>,
    A: Accumulator<V::Scalar>,
{
    #[inline]
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        self.observer.ledger.limit_credit(self.room);
        let sum = self.observer.observe(sample, effort);
        let most = (sum.larger(zero) / sample.period).smaller(self.power);
        let given = -effort.inner(sample.velocity);
        let factor = V::Scalar::choose(given.above(most), most / given, one);
        let accepted = (given + sample.period + sample.work.sum()).finite() & effort.finite();
        Correction {
            effort: V::choose(accepted, effort.scale(factor), V::zero()),
            observed_energy: sum,
            alpha: zero,
            shortfall: (-sum).larger(zero),
            accepted,
        }
    }
}
