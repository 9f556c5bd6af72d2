//! Forces that grow no faster with the displacement than the device stands.

use lyapunov_core::{
    Accumulator, Action, Drive, ParameterError, Plain, Requirement, Scalar, Signal, Stabilizer,
};

use crate::Refine;

/// A bound on the slope of force over displacement, axis by axis: `F(n)` is the effort, as far as it lies between 0 and
/// `h = f_act(n−1) + μ Δx(n)`; and up to `ρ T` beyond either, if it may [`creep`](Self::creeping).
///
/// **Passive.** Let `U(F) = |F|² / (2 μ)`. Over a period a held force takes `F · Δx = (|F + μ Δx|² − |F|²) / (2 μ) − μ |Δx|² / 2`
/// from the motion, and the next force is between 0 and `F + μ Δx`, so `F · Δx ≥ ΔU − μ |Δx|² / 2`. The device's damper burns
/// at least `b |Δx|² / T` meanwhile. With `b ≥ μ T / 2`, the condition of Colgate and Schenkel (Journal of Robotic Systems
/// 14(1), 1997) with `μ` for the wall's stiffness, device and port together give away nothing, whatever stands behind: a wall
/// of any stiffness, late, slow, or driven. What it renders of a wall stiffer than `μ` is a spring `μ`; one that is not stiffer
/// passes unchanged.
///
/// **Input-to-state stable.** A passive port cannot render what acts by itself, a moving wall or a weight: at rest nothing may
/// grow. A creep of `ρ` N/s lets it, and then the port gives at most `ρ Σ |F| / μ` watts more than it took, a sum over the
/// axes, instead of nothing: motions stay bounded for bounded forces of operator and environment if the device damps, and need
/// not come to rest.
///
/// Jafari and Ryu (IEEE International Conference on Robotics and Automation, 2015) put the largest slope of the graph of force
/// over displacement into a controller for this reason: to release passivity to input-to-state stability. From their
/// approach, as later papers describe it, is the slope as the one gain. Derived here are the law, which holds an environment to a
/// slope instead of relying on it, its proof and the creep; their feed-forward of the force's rate is left out.
///
/// It needs no velocity and no memory, and adds no damping. A force that acts later than the next period is not covered: what
/// it gives shows in `sum`, the work of the port plus `μ |Δx|² / 2` a tick, and below 0 is told as shortfall, as is what creep
/// gives.
///
/// ```
/// use lyapunov_core::{Drive, Stabilizer};
/// use lyapunov_stabilizers::SlopeBound;
/// let mut bound = SlopeBound::of_damping(0.5, 1e-3)?; // μ = 2 b / T = 1 kN/m
/// let pressed = Drive::new(1e-3, 0.1e-3, 0.1, 0.1e-3, 2.0); // 2 N acted over 0.1 mm
/// assert!((bound.stabilize(&pressed, 9.0).effort - 2.1_f64).abs() < 1e-12);
/// assert_eq!(bound.stabilize(&pressed, 2.05).effort, 2.05);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SlopeBound<T, A = Plain<T>> {
    slope: T,
    creep: T,
    energy: A,
}

impl<T: Scalar> SlopeBound<T> {
    /// A bound of `slope` N/m.
    ///
    /// # Errors
    /// `slope` not above 0 and finite.
    pub fn new(slope: T) -> Result<Self, ParameterError> {
        let slope = Requirement::Positive.check("slope", slope)?;
        Ok(Self { slope, creep: T::of(0.0), energy: Plain::zero() })
    }

    /// The largest slope for a device that surely has the viscous `damping`, N·s/m: `μ = 2 b / T`.
    ///
    /// # Errors
    /// `damping` or `period` not above 0 and finite, or a slope out of range.
    pub fn of_damping(damping: T, period: T) -> Result<Self, ParameterError> {
        let damping = Requirement::Positive.check("device damping", damping)?;
        let period = Requirement::Positive.check("period", period)?;
        Self::new(T::of(2.0) * damping / period)
    }
}

impl<T: Scalar, A: Accumulator<T>> SlopeBound<T, A> {
    /// The same bound that lets a force grow by `rate` N/s without a displacement.
    ///
    /// # Errors
    /// `rate` below 0, infinite or NaN.
    pub fn creeping(self, rate: T) -> Result<Self, ParameterError> {
        Ok(Self { creep: Requirement::NonNegative.check("creep", rate)?, ..self })
    }

    /// The same bound with its energies summed in a `B`.
    pub fn summed_in<B: Accumulator<T>>(self) -> SlopeBound<T, B> {
        SlopeBound { slope: self.slope, creep: self.creep, energy: B::zero() }
    }
}

impl<T, A> Refine for SlopeBound<T, A> {}

impl<V: Signal, A: Accumulator<V::Scalar>> Stabilizer<V> for SlopeBound<V::Scalar, A> {
    #[inline]
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V> {
        let zero = V::Scalar::of(0.0);
        let moved = drive.displacement.pair(drive.displacement);
        let change = drive.work.sum() + V::Scalar::of(0.5) * self.slope * moved;
        let booked = (self.energy.value() + change).finite();
        self.energy.add(V::Scalar::choose(booked, change, zero));
        let sum = self.energy.value();

        let creep = self.creep * drive.period;
        let held = drive.acted + drive.displacement.scale(self.slope);
        let bounded = effort.zip(held, |asked, held| {
            asked.larger(held.smaller(zero) - creep).smaller(held.larger(zero) + creep)
        });
        let accepted = booked & effort.finite() & held.finite() & creep.finite();
        Action {
            effort: V::choose(accepted, bounded, V::zero()),
            sum,
            alpha: zero,
            shortfall: (-sum).larger(zero),
            accepted,
        }
    }
}
